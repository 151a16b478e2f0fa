#include "ui/window/lesson/prediction_fields.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QShortcut>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/friction/curve_file.h"
#include "core/friction/curve_quantity.h"
#include "core/scene/parameters.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_row.h"
#include "ui/window/lesson/lesson_check.h"
#include "ui/window/lesson/lesson_form.h"

namespace asperity {

namespace {

constexpr int kMaxChoices = 6;

enum Kind { kNone, kChoice, kNumber, kPoint };                               // as in the list
enum CurveVisibility { kVisible, kHiddenUntilAnswered, kHiddenThroughout };  // as in the list

constexpr int kPlaceholderRole = Qt::UserRole + 1;

/// Shows the placeholder of an empty cell.
class PlaceholderDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!option->text.isEmpty()) return;
    option->text = index.data(kPlaceholderRole).toString();
    option->features |= QStyleOptionViewItem::HasDisplay;
    option->palette.setColor(QPalette::Text, option->palette.color(QPalette::PlaceholderText));
  }
};

QString endText(double end) {
  return std::isfinite(end) ? shownNumber(end) : QString();
}
constexpr double kPointTolerance = 1;  // a factor of 2 on a logarithmic axis

enum ValueKind { kStateValue, kRatio, kPeak, kExponent };  // as in the list

ValueKind valueKind(const LessonValue& value) {
  if (value.kind == LessonValue::Kind::Peak) return kPeak;
  if (value.kind == LessonValue::Kind::Exponent) return kExponent;
  return value.over.empty() ? kStateValue : kRatio;
}

/// Returns a quantity of the friction curve in words.
QString columnTitle(std::string_view column) {
  for (const QuantityEntry& entry : quantityEntries())
    if (entry.word.text() == column) return translatedText(entry.title);
  const std::pair<std::string_view, QString> titles[] = {
      {"velocity", LessonValueFields::tr("velocity")},
      {"mu_standard_error", LessonValueFields::tr("standard error of μ")},
      {"mu_law", LessonValueFields::tr("μ by Eq. (11)")},
      {"dimensionless_velocity", LessonValueFields::tr("dimensionless velocity")},
      {"dimensionless_force", LessonValueFields::tr("dimensionless force")},
      {"mu_interface", LessonValueFields::tr("μ of the local friction")},
      {"mu_total", LessonValueFields::tr("μ with the local friction")},
      {"mu_mean_of_ratios", LessonValueFields::tr("mean of the ratios of force to load")},
      {"mu_ratio_of_means", LessonValueFields::tr("ratio of the mean force to the mean load")},
      {"marginal_share",
       LessonValueFields::tr("share of its load on an element that just touches")},
      {"extrapolated",
       LessonValueFields::tr("whether it rests on frequencies that were not measured")},
      {"normal_force", LessonValueFields::tr("normal force")},
      {"nominal_pressure", LessonValueFields::tr("nominal pressure")},
      {"contact_spots", LessonValueFields::tr("number of contacts")}};
  for (const auto& [name, title] : titles)
    if (name == column) return title;
  return fromUtf8(column);
}

}  // namespace

// ---- The computed answer

LessonValueFields::LessonValueFields(LessonForm& page) : QObject(&page), page_(page) {
  kind_ = page.addChoice(tr("Computed answer"), "editorValue");
  kind_->addItems(
      {tr("the value after the changes below"), tr("how many times as large as in this step"),
       tr("where on the axis it is largest"), tr("the power of a parameter with which it grows")});
  connect(kind_, &QComboBox::activated, this, [this] {
    showRows();
    proposeEnds();
  });
  column_ = page.addChoice(tr("of the quantity"), "editorColumn");
  for (const std::string_view name : curveColumns())
    if (name != "mu_low" && name != "mu_high" && name != "realizations") {
      column_->addItem(columnTitle(name), fromUtf8(name));
      column_->setItemData(column_->count() - 1, fromUtf8(name), Qt::ToolTipRole);
    }
  key_ = page.addChoice(tr("of the parameter"), "editorExponentKey");
  connect(key_, &QComboBox::activated, this, &LessonValueFields::proposeEnds);
  from_ = page.addLine(tr("from"), "editorExponentFrom");
  to_ = page.addLine(tr("to"), "editorExponentTo");
  for (QLineEdit* end : {from_, to_}) {
    end->setPlaceholderText(QStringLiteral("20 mN"));
    end->setToolTip(
        tr("Two values of the parameter, both above 0, between which the slope of the curve in "
           "logarithms is computed"));
  }
  set_ = page.addAssignments(tr("after the changes"), "editorValueSet");
}

void LessonValueFields::show(const LessonValue& value, const Scene& scene) {
  scene_ = scene;
  kind_->setCurrentIndex(valueKind(value));
  column_->setCurrentIndex(column_->findData(QString::fromStdString(value.column)));
  set_->show(value.set, scene);
  key_->clear();
  for (const Parameter& row : parameters())
    if (std::holds_alternative<RealField>(row.field) && isApplicable(row, scene) &&
        row.key.find('.') != row.key.npos)
      key_->addItem(ParameterRow::labelText(row), fromUtf8(row.key));
  const QString key = QString::fromStdString(value.key.empty() ? "sliding.velocity" : value.key);
  // A key may have a meaning only after the changes below.
  if (key_->findData(key) < 0) {
    const Parameter* row = findParameter(key.toStdString());
    key_->addItem(row ? ParameterRow::labelText(*row) : key, key);
  }
  key_->setCurrentIndex(key_->findData(key));
  from_->setText(value.from == 0 ? QString() : keyValueText(value.key, value.from));
  to_->setText(value.to == 0 ? QString() : keyValueText(value.key, value.to));
  showRows();
}

void LessonValueFields::setShown(bool isShown) {
  isShown_ = isShown;
  showRows();
}

void LessonValueFields::showRows() {
  for (QWidget* field : std::initializer_list<QWidget*>{kind_, column_, set_})
    page_.setShown(field, isShown_);
  for (QWidget* field : std::initializer_list<QWidget*>{key_, from_, to_})
    page_.setShown(field, isShown_ && kind_->currentIndex() == kExponent);
}

/// Writes two values of the key where those that are there are none of it: that of the step, and
/// ten times as much.
void LessonValueFields::proposeEnds() {
  if (kind_->currentIndex() != kExponent || (rangeEnd(*from_) > 0 && rangeEnd(*to_) > 0)) return;
  const std::string key = key_->currentData().toString().toStdString();
  const Parameter* row = findParameter(key);
  if (!row || !std::holds_alternative<RealField>(row->field)) return;
  const double present = std::get<double>(parameterValue(*row, scene_));
  const double most = std::get<RealField>(row->field).maximum;
  const double to = present > 0 ? std::min(10 * present, most) : 1;
  from_->setText(keyValueText(key, roundedToDigits(0.1 * to, 4)));
  to_->setText(keyValueText(key, roundedToDigits(to, 4)));
  page_.notifyEdited();
}

/// Returns the value in SI; 0 where it cannot be read, which is a mistake of the lesson.
double LessonValueFields::rangeEnd(const QLineEdit& entry) const {
  return parseKeyValue(key_->currentData().toString().toStdString(), entry.text()).value_or(0);
}

LessonValue LessonValueFields::edited(const LessonValue& before) const {
  LessonValue value = before;
  value.column = column_->currentData().toString().toStdString();
  value.set = set_->assignments();
  const int kind = kind_->currentIndex();
  if (kind != valueKind(before)) {
    value.kind = kind == kPeak       ? LessonValue::Kind::Peak
                 : kind == kExponent ? LessonValue::Kind::Exponent
                                     : LessonValue::Kind::State;
    value.over.clear();
    if (kind == kRatio) value.over.push_back(LessonValue{});
  }
  // The divisor of a ratio is of the same column, unless the file names another one.
  for (LessonValue& under : value.over)
    if (kind != valueKind(before) || under.column == before.column) under.column = value.column;
  value.key.clear();
  value.from = value.to = 0;
  if (kind == kExponent) {
    value.key = key_->currentData().toString().toStdString();
    value.from = rangeEnd(*from_);
    value.to = rangeEnd(*to_);
  }
  return value;
}

// ---- The question

PredictionFields::PredictionFields(LessonForm& page) : QObject(&page), page_(page) {
  kind_ = page.addChoice(tr("Prediction"), "editorKind");
  kind_->addItems({tr("none"), tr("a choice"), tr("a number"), tr("a point on the chart")});
  connect(kind_, &QComboBox::activated, this, [this] {
    showRows();
    proposeTolerance();
    page_.notifyEdited();
  });
  question_ = page.addText(tr("Question"), "editorQuestion", 2);
  addChoices();
  value_ = new LessonValueFields(page);
  computed_ = new WrappedLabel;
  computed_->setObjectName("editorComputed");
  page.addRow(QString(), computed_);
  page.setShown(computed_, false);
  x_ = page.addLine(tr("Place on the axis"), "editorX");
  x_->setPlaceholderText(tr("empty: the largest value is asked"));
  connect(x_, &QLineEdit::textEdited, this, &PredictionFields::showRowsOfPoint);
  tolerance_ = page.addLine(tr("Tolerance in %"), "editorTolerance");
  tolerance_->setToolTip(tr(
      "How far a right answer may be from the computed one; of a point, the factor on the chart is "
      "1.5 for 50 %"));
  xTolerance_ = page.addLine(tr("Tolerance of the place in %"), "editorPlaceTolerance");
  xTolerance_->setToolTip(
      tr("How far the place of a right answer may be from that of the largest value: the factor is "
         "2 for 100 %"));
  right_ = page.addLine(tr("If right"), "editorRight");
  wrong_ = page.addLine(tr("If wrong"), "editorWrong");
  hides_ = page.addChoice(tr("The curve is"), "editorHides");
  hides_->addItems({tr("in sight"), tr("hidden until the answer"), tr("hidden throughout")});
  after_ = page.addAssignments(tr("Changed with the answer"), "editorAfter");
  after_->setToolTip(tr("What the program changes in the scene when the answer is shown"));
  reveal_ = page.addText(tr("Said with the answer"), "editorReveal", 4);
  for (QWidget* text : std::initializer_list<QWidget*>{right_, wrong_, reveal_})
    text->setToolTip(tr(
        "Write {answer} where the computed answer or the right choice belongs, and {given} where "
        "the student's does"));
}

void PredictionFields::addChoices() {
  choices_ = new QTableWidget(kMaxChoices, 4);
  choices_->setObjectName("editorChoices");
  choices_->setAccessibleName(tr("choices"));
  choices_->setHorizontalHeaderLabels({tr("Choice"), tr("Right"), tr("From"), tr("To")});
  choices_->setToolTip(
      tr("Tick the right one; or leave all unticked, give the range of the "
         "computed answer for which each is right, and say below what is computed"));
  choices_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int column = 1; column < 4; ++column)
    choices_->setColumnWidth(column, 8 * choices_->fontMetrics().horizontalAdvance('0'));
  choices_->verticalHeader()->hide();
  const int row = choices_->fontMetrics().lineSpacing() + 10;
  choices_->verticalHeader()->setDefaultSectionSize(row);
  choices_->setFixedHeight(choices_->horizontalHeader()->sizeHint().height() + kMaxChoices * row +
                           2 * choices_->frameWidth());
  choices_->setTabKeyNavigation(false);
  choices_->setItemDelegateForColumn(0, new PlaceholderDelegate(choices_));
  for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
    // Only of the table itself: in a cell that is being edited the keys delete letters.
    auto* shortcut = new QShortcut(QKeySequence(key), choices_);
    shortcut->setContext(Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, this, &PredictionFields::emptySelectedCells);
  }
  page_.addRow(tr("Choices"), choices_);
  connect(choices_, &QTableWidget::itemChanged, &page_, &LessonForm::notifyEdited);
}

/// Empties the selected cells but for the ticks, as one edit.
void PredictionFields::emptySelectedCells() {
  {
    const QSignalBlocker quiet(choices_);
    for (QTableWidgetItem* item : choices_->selectedItems())
      if (item->column() != 1) item->setText({});
  }
  page_.notifyEdited();
}

// ---- Showing

void PredictionFields::show(const LessonStep& step) {
  const LessonPrediction prediction = step.prediction.value_or(LessonPrediction{});
  axis_ = step.scene.sweep.key;
  isLinearY_ = step.show.isLinearY;
  kind_->setCurrentIndex(step.prediction ? 1 + static_cast<int>(prediction.kind) : kNone);
  page_.showText(*question_, prediction.question);
  const QString places =
      tr("{answer}: the computed answer, or the right choice; {given}: that of the student");
  page_.showText(*right_, prediction.right, places);
  page_.showText(*wrong_, prediction.wrong, places);
  tolerance_->setText(percentText(prediction.tolerance));
  xTolerance_->setText(percentText(prediction.xTolerance));
  x_->setText(prediction.x ? keyValueText(axis_, *prediction.x) : QString());
  value_->show(prediction.answer.value_or(LessonValue{}), step.scene);
  hides_->setCurrentIndex(!step.show.hidesCurve       ? kVisible
                          : step.show.hidesCurveAfter ? kHiddenThroughout
                                                      : kHiddenUntilAnswered);
  after_->show(step.after, step.revealedScene);
  page_.showText(*reveal_, step.reveal, places);
  showChoices(prediction);
  showRows();
}

void PredictionFields::showChoices(const LessonPrediction& prediction) {
  for (int i = 0; i < kMaxChoices; ++i) {
    const bool has = i < static_cast<int>(prediction.choices.size());
    const LessonChoice choice =
        has ? prediction.choices[static_cast<std::size_t>(i)] : LessonChoice{};
    auto* tick = new QTableWidgetItem;
    tick->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    tick->setCheckState(choice.isRight ? Qt::Checked : Qt::Unchecked);
    auto* text = new QTableWidgetItem(page_.localText(choice.text));
    text->setData(kPlaceholderRole, page_.placeholder(choice.text));
    choices_->setItem(i, 0, text);
    choices_->setItem(i, 1, tick);
    choices_->setItem(i, 2, new QTableWidgetItem(endText(choice.above)));
    choices_->setItem(i, 3, new QTableWidgetItem(endText(choice.below)));
  }
}

/// Shows the rows that the kind of prediction has.
void PredictionFields::showRows() {
  const int kind = kind_->currentIndex();
  for (QWidget* field : std::initializer_list<QWidget*>{question_, right_, wrong_, after_, reveal_})
    page_.setShown(field, kind != kNone);
  page_.setShown(choices_, kind == kChoice);
  value_->setShown(kind == kChoice || kind == kNumber);
  page_.setShown(x_, kind == kPoint);
  page_.setShown(tolerance_, kind == kNumber || kind == kPoint);
  showRowsOfPoint();
}

/// Shows the tolerance of the place where the place is asked for. The curve of a point is never
/// visible before the answer, but it may stay hidden after it.
void PredictionFields::showRowsOfPoint() {
  const bool isPoint = kind_->currentIndex() == kPoint;
  page_.setShown(xTolerance_, isPoint && x_->text().trimmed().isEmpty());
  qobject_cast<QStandardItemModel*>(hides_->model())->item(kVisible)->setEnabled(!isPoint);
  if (isPoint && hides_->currentIndex() == kVisible) hides_->setCurrentIndex(kHiddenUntilAnswered);
}

void PredictionFields::showComputed(const QString& text) {
  computed_->setText(text);
  page_.setShown(computed_, !text.isEmpty());
}

/// Where a point is asked for from now on, its usual tolerance is a factor: on a logarithmic axis
/// of several decades a tenth of a value is one pixel. A number gets the usual one back.
void PredictionFields::proposeTolerance() {
  const bool isPoint = kind_->currentIndex() == kPoint;
  const QString usual = percentText(LessonPrediction{}.tolerance);
  const QString factor = percentText(kPointTolerance);
  if (isPoint && !isLinearY_ && tolerance_->text() == usual) tolerance_->setText(factor);
  if (!isPoint && tolerance_->text() == factor) tolerance_->setText(usual);
}

// ---- Taking what is written

/// Writes the choices into the prediction. Returns whether they have ranges of a computed answer.
bool PredictionFields::takeChoices(LessonPrediction& prediction) const {
  prediction.choices.clear();
  bool hasRanges = false;
  for (int i = 0; i < kMaxChoices; ++i) {
    LessonChoice choice;
    const QTableWidgetItem& text = *choices_->item(i, 0);
    // The text in the other language stays with its row, also where a row above is empty.
    page_.write(choice.text, text.text(), text.data(kPlaceholderRole).toString());
    choice.isRight = choices_->item(i, 1)->checkState() == Qt::Checked;
    choice.above = numberIn(choices_->item(i, 2)->text()).value_or(LessonChoice{}.above);
    choice.below = numberIn(choices_->item(i, 3)->text()).value_or(LessonChoice{}.below);
    if (choice.text.empty()) continue;
    hasRanges = hasRanges || choice.isRange();
    prediction.choices.push_back(choice);
  }
  if (hasRanges)
    for (LessonChoice& choice : prediction.choices) choice.isRight = false;
  return hasRanges;
}

void PredictionFields::take(LessonStep& step) const {
  step.show.hidesCurve = hides_->currentIndex() != kVisible;
  step.show.hidesCurveAfter = hides_->currentIndex() == kHiddenThroughout;
  const int kind = kind_->currentIndex();
  const bool wasComputed = step.prediction && step.prediction->answer;
  const std::vector<std::string> changesBefore =
      wasComputed ? step.prediction->answer->set : std::vector<std::string>();
  if (kind == kNone) {
    step.prediction.reset();
    step.reveal = {};
    step.after.clear();
    step.values.clear();
    return;
  }
  LessonPrediction prediction = step.prediction.value_or(LessonPrediction{});
  prediction.kind = static_cast<PredictionKind>(kind - 1);
  page_.write(prediction.question, LessonForm::plainText(*question_));
  page_.write(prediction.right, right_->text());
  page_.write(prediction.wrong, wrong_->text());
  prediction.tolerance = partIn(tolerance_->text(), prediction.tolerance);
  prediction.xTolerance = partIn(xTolerance_->text(), prediction.xTolerance);
  if (kind != kPoint || unreadableIn(*x_).isEmpty())
    prediction.x = kind == kPoint ? parseKeyValue(axis_, x_->text()) : std::nullopt;
  if (kind != kChoice || unreadableChoice().isEmpty()) {
    const bool isComputed = kind == kNumber || (kind == kChoice && takeChoices(prediction));
    if (kind != kChoice) prediction.choices.clear();
    if (isComputed)
      prediction.answer = value_->edited(prediction.answer.value_or(LessonValue{}));
    else
      prediction.answer.reset();
  }
  step.prediction = prediction;
  // The curve would show a number that is asked for from now on.
  if (!wasComputed && showsAnswer(step)) {
    step.show.hidesCurve = true;
    hides_->setCurrentIndex(kHiddenUntilAnswered);
  }
  step.after = after_->assignments();
  // The picture follows the changes of the answer, until it is given other ones.
  const std::vector<std::string> changes =
      prediction.answer ? prediction.answer->set : std::vector<std::string>();
  if (changes != changesBefore && step.after == changesBefore) {
    step.after = changes;
    after_->show(step.after, step.scene);
  }
  page_.write(step.reveal, LessonForm::plainText(*reveal_));
}

// ---- What cannot be read

QString PredictionFields::unreadableIn(const QLineEdit& line) const {
  const QString text = line.text().trimmed();
  const bool isPlace = &line == x_;
  if (!line.isVisibleTo(&page_) || (isPlace && text.isEmpty())) return {};
  const bool isRead = isPlace ? parseKeyValue(axis_, text).has_value()
                              : numberIn(QString(text).remove('%')).has_value();
  return isRead ? QString() : tr("%1: “%2” is not a number").arg(line.accessibleName(), text);
}

QString PredictionFields::unreadableChoice() const {
  if (!choices_->isVisibleTo(&page_)) return {};
  for (int row = 0; row < choices_->rowCount(); ++row)
    for (const int column : {2, 3}) {
      const QTableWidgetItem* item = choices_->item(row, column);  // none: no step was shown yet
      const QString text = item ? item->text().trimmed() : QString();
      if (text.isEmpty() || numberIn(text)) continue;
      return tr("Choice %1, %2: “%3” is not a number")
          .arg(row + 1)
          .arg(choices_->horizontalHeaderItem(column)->text(), text);
    }
  return {};
}

QString PredictionFields::unreadable() const {
  for (const QLineEdit* line : {x_, tolerance_, xTolerance_})
    if (const QString text = unreadableIn(*line); !text.isEmpty()) return text;
  return unreadableChoice();
}

}  // namespace asperity
