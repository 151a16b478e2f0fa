#include "ui/window/export/export_form.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QProcess>
#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "core/chart/figure_style.h"
#include "core/paper/figure.h"
#include "ui/language/language.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/window/export/export_size_fields.h"
#include "ui/window/figures/figure_queue.h"

namespace asperity {

ExportForm::ExportForm(bool isMotion, const RenderCommandOptions& shown, QWidget* parent)
    : QWidget(parent), isMotion_(isMotion), shown_(shown), rows_(new QFormLayout(this)) {
  setObjectName("exportForm");
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  rows_->setContentsMargins(0, 0, 6, 0);
  kind_ = addField<ChoiceBox>(*rows_, "exportKind", tr("&Kind"));
  kind_->addItem(tr("Picture"), "picture");
  kind_->addItem(tr("Film"), "film");
  kind_->addItem(tr("Table"), "table");
  kind_->addItem(tr("Figures of the paper"), "figure");
  content_ = addField<ChoiceBox>(*rows_, "exportContent", tr("&What"));
  format_ = addField<ChoiceBox>(*rows_, "exportFormat", tr("&Format"));
  style_ = addField<ChoiceBox>(*rows_, "exportStyle", tr("St&yle"));
  style_->addItem(tr("none"), "");
  for (const std::string_view name : namesOf(shippedStyles()))
    style_->addItem(fromUtf8(name), fromUtf8(name));
  size_ = new ExportSizeFields(*rows_, shown_);
  theme_ = addField<ChoiceBox>(*rows_, "exportTheme", tr("&Theme"));
  theme_->addItem(tr("automatic"), "");
  theme_->addItem(tr("light"), "light");
  theme_->addItem(tr("dark"), "dark");
  theme_->addItem(tr("print"), "print");
  theme_->addItem(tr("paper, in light tints"), "paper");
  transparent_ = named<QCheckBox>("exportTransparent", tr("Trans&parent background"));
  rows_->addRow(transparent_);
  asShown_ =
      named<QCheckBox>("exportAsShown", tr("Same p&art of the line and moment as in the window"));
  asShown_->setChecked(true);
  rows_->addRow(asShown_);
  addFilm();
  columns_ = addField<QLineEdit>(*rows_, "exportColumns", tr("Co&lumns"),
                                 tr("Names of columns, separated by commas; empty: all"));
  columns_->setPlaceholderText(tr("all"));
  realizations_ =
      addField<QLineEdit>(*rows_, "exportRealizations", tr("A&verage of lines"),
                          tr("Random lines over which each point is a mean; the paper has 200"));
  realizations_->setText("200");

  further_ = addField<QLineEdit>(
      *rows_, "exportFurther", tr("&Other options"),
      tr("Any other options of the command, such as --font-size 9 --title none; asperity "
         "render --help lists them"));

  fillContents();
  chooseWord(*theme_, shown_.dark ? "dark" : "");
  connectControls();
  fitSize();
  // The widest kind of export sets the width, so that nothing moves with the kind.
  setMinimumWidth(rows_->minimumSize().width());
  showRows();
}

/// Adds the rows of a film: its length, its frames, and how fast the contact moves in it.
void ExportForm::addFilm() {
  duration_ = addField<QLineEdit>(*rows_, "exportDuration", tr("&Duration (s)"),
                                  tr("Length of the film in seconds"));
  duration_->setText("6");
  rate_ = addField<QLineEdit>(*rows_, "exportRate", tr("Fra&mes per s"), tr("0.001 to 1000"));
  rate_->setText("25");
  speedRow_ = new QWidget;
  auto* speed = marginless<QHBoxLayout>(speedRow_);
  auto* kinds = named<ChoiceBox>("exportSpeed");
  kinds->setSpoken(tr("speed"));
  speed_ = kinds;
  if (isMotion_)
    speed_->addItem(tr("the whole motion"), "whole");
  else
    speed_->addItem(tr("periods of the line"), "cycles");
  speed_->addItem(tr("times slower"), "slow");
  speedValue_ = named<QLineEdit>("exportSpeedValue", "1");
  speedValue_->setAccessibleName(tr("value of the speed"));
  speedValue_->setMaximumWidth(90);
  speed->addWidget(speedValue_);
  speed->addWidget(speed_, 1);
  rows_->addRow(tr("&Speed"), speedRow_);
}

void ExportForm::connectControls() {
  for (QComboBox* box : {kind_, content_, format_, style_, theme_, speed_})
    connect(box, &QComboBox::currentIndexChanged, this, [this, box] { followChoice(box); });
  connect(size_, &ExportSizeFields::changed, this, &ExportForm::changed);
  connect(size_, &ExportSizeFields::presetChanged, this, [this] {
    if (size_->isOnPaper() && chosenWord(*theme_) == "dark") chooseWord(*theme_, "");
    emit changed();
  });
  for (QLineEdit* entry : {duration_, rate_, speedValue_, columns_, realizations_, further_})
    connect(entry, &QLineEdit::textEdited, this, &ExportForm::changed);
  for (QCheckBox* box : {transparent_, asShown_})
    connect(box, &QCheckBox::toggled, this, &ExportForm::changed);
}

/// Fills what depends on a choice that the user has made.
void ExportForm::followChoice(const QComboBox* box) {
  if (box == kind_) fillContents();
  if (box == content_) fillFormats();
  if (box == kind_ || box == content_ || box == style_) fitSize();
  if (box == style_) {
    if (!chosenWord(*style_).isEmpty())
      chooseWord(*theme_, "");  // that of the style
    else if (shown_.dark && kind() != ExportKind::Figure)
      chooseWord(*theme_, "dark");
  }
  showRows();
  emit changed();
}

void ExportForm::setKind(ExportKind kind) {
  kind_->setCurrentIndex(static_cast<int>(kind));
}

void ExportForm::setContent(const QString& content) {
  chooseWord(*content_, content);
}

ExportKind ExportForm::kind() const {
  return static_cast<ExportKind>(kind_->currentIndex());
}

/// Offers what this kind can contain, first what the window shows.
void ExportForm::fillContents() {
  const QSignalBlocker quietContent(content_), quietTheme(theme_);
  content_->clear();
  if (kind() == ExportKind::Figure) {
    content_->addItem(tr("Figures 1 to 6"), "paper");
    content_->addItem(tr("All figures"), "all");
    for (const FigureEntry& entry : figureEntries())
      content_->addItem(figureTitle(entry), fromUtf8(entry.word));
    chooseWord(*theme_, "");  // that of print
  } else if (kind() == ExportKind::Table) {
    content_->addItem(tr("Friction curve"), "curve");
    if (isMotion_) content_->addItem(tr("Motion in time"), "motion");
    content_->addItem(tr("Contact, point by point"), "shape");
    content_->addItem(tr("List of contacts"), "contacts");
    if (isMotion_) chooseWord(*content_, "motion");
  } else {
    content_->addItem(tr("Contact"), "contact");
    content_->addItem(tr("Contact and friction curve"), "both");
    if (isMotion_) content_->addItem(tr("Contact and motion in time"), "transient");
    if (kind() == ExportKind::Picture) {
      content_->addItem(tr("Friction curve"), "curve");
      if (isMotion_) content_->addItem(tr("Motion in time"), "motion");
    }
    chooseWord(*content_, shown_.layout);
  }
  fillFormats();
}

void ExportForm::fillFormats() {
  const QSignalBlocker quiet(format_);
  const QString before = chosenWord(*format_);
  format_->clear();
  switch (kind()) {
    case ExportKind::Picture:
      format_->addItem(tr("PNG, pixels"), ".png");
      format_->addItem(tr("SVG, vectors"), ".svg");
      format_->addItem(tr("PDF, vectors"), ".pdf");
      break;
    case ExportKind::Film:
      format_->addItem("MP4", ".mp4");
      format_->addItem("WebM", ".webm");
      format_->addItem(tr("GIF, animated"), ".gif");
      format_->addItem(tr("WebP, animated"), ".webp");
      format_->addItem(tr("Folder of PNG frames"), "");
      break;
    case ExportKind::Table:
      format_->addItem("CSV", ".csv");
      format_->addItem("JSON", ".json");
      break;
    case ExportKind::Figure:
      format_->addItem(tr("Folder: PNG, SVG, PDF, CSV"), "");
      break;
  }
  chooseWord(*format_, before);
}

void ExportForm::fitSize() {
  size_->setContent({kind(), chosenWord(*content_), chosenWord(*style_), hasContact()});
}

/// Returns whether the contact is drawn or listed, rather than diagrams alone.
bool ExportForm::hasContact() const {
  const QString content = chosenWord(*content_);
  return content != "curve" && content != "motion" && kind() != ExportKind::Figure;
}

/// Returns whether the format of the file knows transparency.
bool ExportForm::canBeTransparent() const {
  return kind() != ExportKind::Film || extension() != ".mp4";
}

bool ExportForm::isSlow() const {
  return chosenWord(*speed_) == "slow";
}

/// Returns whether the length of the film can be given: that of a whole motion follows from how
/// many times slower it is.
bool ExportForm::hasDuration() const {
  return !(isMotion_ && isSlow());
}

/// Shows the rows that have a meaning for the kind.
void ExportForm::showRows() {
  const bool isTable = kind() == ExportKind::Table, isFilm = kind() == ExportKind::Film;
  const auto show = [this](QWidget* field, bool isShown) { setRowShown(*rows_, field, isShown); };
  for (QWidget* field : Widgets{style_, theme_, transparent_}) show(field, !isTable);
  show(asShown_, hasContact());
  asShown_->setText(isFilm ? tr("Same p&art of the line as in the window")
                           : tr("Same p&art of the line and moment as in the window"));
  transparent_->setEnabled(canBeTransparent());
  transparent_->setToolTip(canBeTransparent()
                               ? QString()
                               : tr("MP4 knows no transparency. WebM, GIF and WebP know it."));
  for (QWidget* field : Widgets{duration_, rate_, speedRow_}) show(field, isFilm);
  duration_->setEnabled(hasDuration());
  speedValue_->setEnabled(chosenWord(*speed_) != "whole");
  show(columns_, isTable);
  show(realizations_, kind() == ExportKind::Figure);
}

ExportRequest ExportForm::request() const {
  ExportRequest request;
  request.kind = kind();
  request.content = chosenWord(*content_);
  request.asShown = asShown_->isChecked();
  request.further = QProcess::splitCommand(further_->text());
  if (request.kind == ExportKind::Table) {
    request.columns = columns_->text().simplified().remove(' ');
    return request;
  }
  request.style = chosenWord(*style_);
  request.theme = chosenWord(*theme_);
  request.isTransparent = transparent_->isChecked() && canBeTransparent();
  if (request.kind == ExportKind::Figure) request.realizations = machineNumber(*realizations_);
  size_->writeTo(request);
  if (request.kind != ExportKind::Film) return request;
  if (hasDuration()) request.duration = machineNumber(*duration_);
  request.framesPerSecond = machineNumber(*rate_);
  if (isSlow()) request.slowMotion = machineNumber(*speedValue_);
  if (chosenWord(*speed_) == "cycles") request.cycles = machineNumber(*speedValue_);
  return request;
}

QString ExportForm::extension() const {
  return chosenWord(*format_);
}

void ExportForm::chooseExtension(const QString& extension) {
  if (!extension.isEmpty()) chooseWord(*format_, extension);
}

bool ExportForm::isTyped(const QString& option) const {
  return std::ranges::any_of(
      request().further, [&](const QString& typed) { return typed.section('=', 0, 0) == option; });
}

QString ExportForm::errorText() const {
  // The preview, too, would write such a file, and ask nobody.
  for (const QString& typed : request().further)
    if (typed.section('=', 0, 0) == "--output" || typed.startsWith("-o"))
      return tr("%1: enter the name of the file in its own field.").arg(further_->accessibleName());
  for (const QLineEdit* entry : numbers())
    if (!(machineNumber(*entry).toDouble() > 0))
      return tr("%1: “%2” is not a number above 0.").arg(entry->accessibleName(), entry->text());
  return size_->errorText();
}

/// Returns the entries that have a meaning for the kind and hold a number, but for the size.
std::vector<const QLineEdit*> ExportForm::numbers() const {
  if (kind() == ExportKind::Figure) return {realizations_};
  if (kind() != ExportKind::Film) return {};
  std::vector<const QLineEdit*> numbers{rate_};
  if (hasDuration()) numbers.push_back(duration_);
  if (chosenWord(*speed_) != "whole") numbers.push_back(speedValue_);
  return numbers;
}

QString ExportForm::inWords(const QString& reason, const NeededHeight& needed) const {
  const QString option = reason.section(':', 0, 0);
  if (isTyped(option)) return reason;
  if (option == "--size") return size_->tooSmallText(needed);
  for (const auto& [name, entry] : std::initializer_list<std::pair<const char*, const QLineEdit*>>{
           {"--scale", &size_->density()},
           {"--fps", rate_},
           {"--duration", duration_},
           {"--cycles", speedValue_},
           {"--slow-motion", speedValue_},
           {"--columns", columns_},
           {"--realizations", realizations_}})
    if (option == QLatin1String(name)) return entry->accessibleName() + reason.mid(option.size());
  return reason;
}

}  // namespace asperity
