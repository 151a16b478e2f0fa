#include "ui/panels/parameter_row.h"

#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/elastomer_tables.h"
#include "ui/panels/list_box.h"
#include "ui/panels/material_box.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_text.h"
#include "ui/panels/tips.h"
#include "ui/panels/value_entry.h"
#include "ui/panels/value_slider.h"

namespace asperity {

namespace {

constexpr int kGap = 5;  // pixels between the columns

// These widths are in digits.
constexpr double kEntryWidth = 8.8;
constexpr double kUnitWidth = 5.6;
constexpr double kResetWidth = 2.25;

ParameterValue sliderValue(const Parameter& parameter, double value) {
  if (std::holds_alternative<IntegerField>(parameter.field))
    return static_cast<std::int64_t>(std::llround(value));
  return value;
}

/// Returns the width that a label needs where it is broken at spaces and hyphens.
int longestWord(const QString& html, const QFont& font) {
  static const QRegularExpression gap(QStringLiteral("\\s|(?<=-)"));
  const QFontMetrics metrics(font);
  int longest = 0;
  for (const QString& word : withoutTags(html).replace("&nbsp;", "_").split(gap))
    longest = std::max(longest, metrics.horizontalAdvance(word));
  return longest + 1;
}

/// Returns the width of the labels beside lists and texts. A very long one is broken into two
/// lines, so that it does not take space from every list.
int measuredLabelWidth(const QFont& font) {
  const QFontMetrics metrics(font);
  const int longest = metrics.horizontalAdvance(QStringLiteral("relaxation time  T"));
  int width = 0;
  for (const Parameter& parameter : parameters()) {
    if (allowedRange(parameter)) continue;  // a number has its label in the same line
    const QString text = withoutTags(labelWithSymbol(parameter));
    const auto textWidth = [&metrics](QString part) {
      return metrics.horizontalAdvance(part.replace("&nbsp;", " "));
    };
    int needed = textWidth(text);
    if (const qsizetype space = text.indexOf(' '); needed > longest && space > 0)
      needed = std::max(textWidth(text.left(space)), textWidth(text.mid(space + 1)));
    width = std::max(width, needed);
  }
  return width + 4;
}

/// Returns the same, measured once for all rows.
int labelWidth(const QFont& font) {
  static QFont measured;
  static std::string_view language;
  static int width = 0;
  if (width == 0 || measured != font || language != presentLanguage())
    width = measuredLabelWidth(font);
  measured = font;
  language = presentLanguage();
  return width;
}

double asNumber(const ParameterValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

}  // namespace

ParameterRow::ParameterRow(const Parameter& parameter, QWidget* parent)
    : QWidget(parent), parameter_(parameter) {
  setObjectName("row:" + fromUtf8(parameter.key));
  auto* column = marginless<QVBoxLayout>(this, 0);
  auto* line = new QHBoxLayout;
  line->setSpacing(kGap);
  column->addLayout(line);

  addLabel(*line);
  if (const auto* choice = std::get_if<ChoiceField>(&parameter.field))
    addChoice(*line, *choice);
  else if (isMaterial(parameter))
    addMaterials(*line);
  else if (std::holds_alternative<ArmsField>(parameter.field))
    addTable(*line, *column, *new ArmsEditor(this), "arms");
  else if (std::holds_alternative<ShiftTableField>(parameter.field))
    addTable(*line, *column, *new ShiftEditor(this), "shifts");
  else if (isList(parameter))
    addListBox(*line);
  else if (std::holds_alternative<TextField>(parameter.field))
    addText(*line);
  else
    addNumber(*line, *column);
  addReset(*line);
  if (text_) line->setAlignment(reset_, Qt::AlignTop);

  keepTipsBeside(*this);
}

void ParameterRow::showTexts() {
  label_->setText(labelWithSymbol(parameter_));
  label_->setToolTip(parameterTip(parameter_, rheology_));
  speak();
  for (QWidget* control : Widgets{slider_, entry_, choice_, table_, material_, list_, text_})
    if (control) control->setToolTip(tip());
  if (material_) material_->showTexts();
  if (list_) list_->showTexts();
  if (table_) table_->setToolTip({});  // its parts have their own tooltips
  if (choice_) {
    const auto& words = std::get<ChoiceField>(parameter_.field).choices;
    for (int i = 0; i < choice_->count(); ++i)
      choice_->setItemText(i, wordText(words[static_cast<std::size_t>(i)], parameter_.key));
  }
  if (browse_) {
    entry_->setPlaceholderText(tr("no file"));
    browse_->setToolTip(tr("Choose a file of this computer"));
    browse_->setAccessibleName(tr("choose file"));
  }
  reset_->setAccessibleName(tr("reset %1").arg(labelText(parameter_)));
  setWidths();
}

void ParameterRow::setParameter(const Parameter& parameter) {
  parameter_ = parameter;
  if (slider_) slider_->setScale(SliderScale(parameter_));
  showTexts();
}

/// Moves the slider. Its scale becomes longer at once where a value lies beyond it, and has its
/// usual length again with the next scene.
void ParameterRow::showOnSlider(double value, bool replace) {
  // The scale stays while the user moves the handle.
  if (replace && isSliderLonger_ && !slider_->hasFocus()) {
    slider_->setScale(SliderScale(parameter_));
    isSliderLonger_ = false;
  }
  if (std::isfinite(value) && !slider_->contains(value)) {
    slider_->setScale(SliderScale(parameter_, value));
    isSliderLonger_ = true;
  }
  slider_->showValue(value);
}

void ParameterRow::showScene(const Scene& scene, const LineSize& known, bool replace) {
  const ParameterValue value = parameterValue(parameter_, scene);
  const std::optional<Placeholder> placeholder = placeholderFor(parameter_, scene, known);
  if (rheology_ != scene.elastomer.rheology) {
    const Rheology before = std::exchange(rheology_, scene.elastomer.rheology);
    if (explanationText(parameter_, rheology_) != explanationText(parameter_, before)) showTexts();
  }
  if (slider_)
    showOnSlider(placeholder ? placeholder->value.value_or(0) : asNumber(value), replace);
  if (entry_) showEntry(value, placeholder, replace);
  if (text_) {
    const QString text = shownText(parameter_, value).number;
    if (replace)
      text_->replaceText(text);
    else
      text_->showText(text);
  }
  if (table_) table_->showScene(scene, replace);
  if (material_) material_->showMaterial(scene.elastomer);
  if (list_) list_->showScene(scene);
  if (choice_) choice_->setCurrentIndex(std::get<ChoiceField>(parameter_.field).read(scene));
  if (replace) {
    refusal_.clear();
    runError_.clear();
    showError();
  }
  showReset(value, resetValue(parameter_, scene));
  if (isChosenWhereOpen(parameter_))
    reset_->setToolTip(tr("Back to the default, chosen by the scene"));
  isFixed_ = placeholder && placeholder->isFixed;
  showEnabled();
  speak();
}

void ParameterRow::showEntry(const ParameterValue& value,
                             const std::optional<Placeholder>& placeholder, bool replace) {
  const UnitText shown = shownText(parameter_, value);
  const QString text = placeholder ? QString() : shown.number;
  if (browse_) {
    // The button has a text until a file name needs the space, which may not show all of it.
    browse_->setText(text.isEmpty() ? tr("choose file…") : QStringLiteral("…"));
    entry_->setToolTip(
        text.isEmpty() ? tip() : QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped()) + tip());
  } else {
    entry_->setPlaceholderText(placeholder ? placeholder->text : QString());
  }
  const QString unit = !placeholder                  ? shown.unit
                       : placeholder->unit.isEmpty() ? fromUtf8(parameter_.unit)
                                                     : placeholder->unit;
  if (replace)
    entry_->replaceText(text, unit);
  else
    entry_->showText(text, unit);
}

void ParameterRow::showReset(const ParameterValue& value, const ParameterValue& initial) {
  resetValue_ = initial;
  reset_->setEnabled(value != initial);
  reset_->setToolTip(initial == defaultValue(parameter_) ? resetText(parameter_, initial)
                                                         : tr("As the file says"));
}

void ParameterRow::showRefusal(const QString& reason) {
  refusal_ = reason;
  showError();
}

void ParameterRow::showRunError(const QString& text) {
  runError_ = text;
  showError();
}

void ParameterRow::showError() {
  const QString& shown = refusal_.isEmpty() ? runError_ : refusal_;
  if (entry_) entry_->showError(shown);
  showRemark(Remark::Error, shown);
}

void ParameterRow::showNote(const QString& text) {
  showRemark(Remark::Note, text);
}

void ParameterRow::showWarning(const QString& text) {
  showRemark(Remark::Warning, text);
}

void ParameterRow::showRemark(Remark kind, const QString& text) {
  constexpr std::array kRoles{"note", "warning", "error"};
  const auto place = static_cast<std::size_t>(kind);
  QLabel*& remark = remarks_[place];
  const QString shown = keptTogether(text);
  if (remark ? remark->text() == shown : shown.isEmpty()) return;
  if (!remark) {
    remark = named<QLabel>(nameFor(kRoles[place]), this);
    remark->setProperty("role", kRoles[place]);
    remark->setWordWrap(true);
    remark->setIndent(0);  // a padding of the style sheet would indent it
    auto& column = static_cast<QVBoxLayout&>(*layout());
    const auto below = std::count_if(remarks_.begin() + place + 1, remarks_.end(),
                                     [](const QLabel* other) { return other != nullptr; });
    column.insertWidget(column.count() - static_cast<int>(below), remark);
  }
  remark->setText(shown);
  remark->setVisible(!shown.isEmpty());
  speak();
}

bool ParameterRow::hasRemark() const {
  return std::ranges::any_of(
      remarks_, [](const QLabel* remark) { return remark && !remark->text().isEmpty(); });
}

bool ParameterRow::isHeld() const {
  return slider_ && slider_->isSliderDown();
}

void ParameterRow::setLocked(bool locked) {
  isLocked_ = locked;
  showEnabled();
}

void ParameterRow::showEnabled() {
  setEnabled(!isLocked_ && !isFixed_);
}

void ParameterRow::takeFocus() {
  for (QWidget* control : Widgets{slider_, choice_, material_, list_, entry_, text_,
                                  table_ ? &table_->fold() : nullptr})
    if (control && control->isVisibleTo(this)) return control->setFocus(Qt::ShortcutFocusReason);
}

bool ParameterRow::isChanged() const {
  return reset_->isEnabledTo(this);
}

/// Aligns the columns of all rows, with widths that follow the font.
void ParameterRow::setWidths() {
  const double digit = QFontMetricsF(font()).horizontalAdvance('0');
  const auto digits = [digit](double count) {
    return static_cast<int>(std::lround(count * digit));
  };
  if (unit_) {
    label_->setMinimumWidth(longestWord(label_->text(), font()));
    // A count may have many digits: it also uses the width of the unit that it does not have.
    const bool isCount = std::holds_alternative<IntegerField>(parameter_.field);
    unit_->setHidden(isCount);
    unit_->setFixedWidth(digits(kUnitWidth));
    entry_->setFixedWidth(digits(kEntryWidth) + (isCount ? kGap + unit_->width() : 0));
  } else {
    label_->setFixedWidth(labelWidth(font()));
  }
  reset_->setFixedWidth(digits(kResetWidth));
}

void ParameterRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange && reset_) setWidths();
}

void ParameterRow::addLabel(QHBoxLayout& line) {
  label_ = new QLabel(this);
  label_->setTextFormat(Qt::RichText);
  label_->setWordWrap(true);
  line.addWidget(label_);
}

void ParameterRow::addEntry() {
  entry_ = named<ValueEntry>(nameFor("entry"), this);
  connect(entry_, &ValueEntry::entryRestored, this, [this] { showRefusal({}); });
}

/// Adds the entry to the line of the label, and below them the slider, which is as wide as the row.
void ParameterRow::addNumber(QHBoxLayout& line, QVBoxLayout& column) {
  line.setStretchFactor(label_, 1);
  addEntry();
  connect(entry_, &ValueEntry::textCommitted, this, [this](const QString& text) {
    emit textGiven(inShownUnit(withoutGroups(text.trimmed()), entry_->unit()));
  });
  line.addWidget(entry_);

  unit_ = named<QLabel>(nameFor("unit"), this);
  unit_->setProperty("role", "unit");
  connect(entry_, &ValueEntry::unitShown, unit_, &QLabel::setText);
  line.addWidget(unit_);

  // The slider follows the entry in the order of the tab key, too.
  slider_ = named<ValueSlider>(nameFor("slider"), SliderScale(parameter_), this);
  connect(slider_, &ValueSlider::valuePicked, this,
          [this](double value) { emit valueGiven(sliderValue(parameter_, value)); });
  connect(slider_, &QSlider::sliderReleased, this, &ParameterRow::released);
  connect(entry_, &ValueEntry::stepped, slider_, [this](int key, Qt::KeyboardModifiers modifiers) {
    QKeyEvent step(QEvent::KeyPress, key, modifiers);
    QCoreApplication::sendEvent(slider_, &step);
  });
  column.addWidget(slider_);
  // The slider has no position for "automatic" or "none"; the keys for its steps remain.
  if (!zeroText(parameter_).isEmpty()) slider_->hide();
}

void ParameterRow::addChoice(QHBoxLayout& line, const ChoiceField& field) {
  choice_ = named<ChoiceBox>(nameFor("choice"), this);
  for (const std::string_view word : field.choices) choice_->addItem(QString(), fromUtf8(word));
  choice_->setEnabled(field.choices.size() > 1);
  connect(choice_, &QComboBox::activated, this, [this](int index) {
    emit valueGiven(choice_->itemData(index).toString().toStdString());
  });
  line.addWidget(choice_, 1);
}

void ParameterRow::addText(QHBoxLayout& line) {
  if (isLongText(parameter_)) return addLongText(line);
  addEntry();
  connect(entry_, &ValueEntry::textCommitted, this, &ParameterRow::textGiven);
  line.addWidget(entry_, 1);
  if (isFile(parameter_)) addBrowse(line);
}

void ParameterRow::addLongText(QHBoxLayout& line) {
  text_ = named<TextBox>(nameFor("text"), this);
  connect(text_, &TextBox::textCommitted, this, &ParameterRow::textGiven);
  line.addWidget(text_, 1);
  line.setAlignment(label_, Qt::AlignTop);
}

/// Adds the fold's line to the row and the table below it.
void ParameterRow::addTable(QHBoxLayout& line, QVBoxLayout& column, PairEditor& table,
                            const char* kind) {
  table_ = &table;
  table_->setObjectName(nameFor(kind));
  connect(table_, &PairEditor::listGiven, this, &ParameterRow::valueGiven);
  line.addWidget(&table.fold(), 1);
  column.addWidget(table_);
}

void ParameterRow::addMaterials(QHBoxLayout& line) {
  material_ = named<MaterialBox>(nameFor("material"), this);
  connect(material_, &MaterialBox::nameGiven, this,
          [this](const QString& given) { emit valueGiven(given.toStdString()); });
  connect(material_, &MaterialBox::fileRequested, this, &ParameterRow::fileRequested);
  line.addWidget(material_, 1);
}

void ParameterRow::addListBox(QHBoxLayout& line) {
  list_ = named<ListBox>(nameFor("list"), std::string(parameter_.key), this);
  connect(list_, &ListBox::listGiven, this, &ParameterRow::valueGiven);
  connect(list_, &ListBox::fileRequested, this, &ParameterRow::fileRequested);
  line.addWidget(list_, 1);
}

/// Adds the button for files. The entry shows the end of a path, which is more informative.
void ParameterRow::addBrowse(QHBoxLayout& line) {
  entry_->setShownEnd(Qt::RightEdge);
  browse_ = named<QToolButton>(nameFor("browse"), this);
  browse_->setProperty("role", "browse");
  browse_->setFocusPolicy(Qt::TabFocus);
  connect(browse_, &QToolButton::clicked, this, &ParameterRow::fileRequested);
  line.addWidget(browse_);
}

void ParameterRow::addReset(QHBoxLayout& line) {
  reset_ = named<QToolButton>(nameFor("reset"), this);
  reset_->setText(QStringLiteral("↺"));
  reset_->setProperty("role", "reset");
  reset_->setFocusPolicy(Qt::NoFocus);
  connect(reset_, &QToolButton::clicked, this, [this] { emit valueGiven(resetValue_); });
  line.addWidget(reset_);
}

QString ParameterRow::nameFor(const char* kind) const {
  return QString(kind) + ":" + fromUtf8(parameter_.key);
}

/// Tells screen readers what the controls are, with the remarks below them. The slider also says
/// its value: its own one is a position.
void ParameterRow::speak() {
  const QString name = labelText(parameter_);
  QStringList sentences{translatedText(parameter_.sentence)};
  for (const QLabel* remark : remarks_)
    if (remark && !remark->text().isEmpty()) sentences += remark->text();
  const QString description = sentences.join(' ');
  for (QWidget* control : Widgets{slider_, entry_, table_, text_}) {
    if (!control) continue;
    control->setAccessibleName(name);
    control->setAccessibleDescription(description);
  }
  for (ChoiceBox* box : std::initializer_list<ChoiceBox*>{choice_, material_, list_})
    if (box) box->setSpoken(name, description);
  if (entry_) entry_->setSpokenName(name);
  if (!slider_) return;
  const QString number = entry_->text().isEmpty() ? entry_->placeholderText() : entry_->text();
  slider_->setAccessibleDescription(
      QStringLiteral("%1. %2").arg((number + ' ' + entry_->unit()).trimmed(), description));
}

QString ParameterRow::tip() const {
  const SliderUse slider = !slider_              ? SliderUse::None
                           : slider_->isHidden() ? SliderUse::Hidden
                                                 : SliderUse::Visible;
  return controlTip(parameter_, rheology_, slider);
}

void ParameterRow::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction(reset_->toolTip(), reset_, &QToolButton::click)->setEnabled(reset_->isEnabled());
  if (const auto explanation = findExplanation(parameter_.key))
    menu.addAction(tr("Read about it in the guide"), this, [this, explanation] {
      emit guideRequested(fromUtf8(explanation->guideAnchor));
    });
  menu.exec(event->globalPos());
}

}  // namespace asperity
