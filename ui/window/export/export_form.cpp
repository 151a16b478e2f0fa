#include "ui/window/export/export_form.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/chart/figure_style.h"
#include "core/paper/figure.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/window/figures/figure_queue.h"

namespace asperity {

namespace {

constexpr double kScreen = 96, kPaper = 300;  // usual pixels per inch
constexpr double kInch = 25.4;                // mm

/// A size in pixels or millimetres.
struct ExportSize {
  double width, height;
  bool isOnPaper;
  double density;  // pixels per inch
};

constexpr const char *kUsual = "usual", *kOfStyle = "style", *kOwn = "own";

struct NamedSize {
  const char* word;
  QString text;
  ExportSize size;
};

QList<NamedSize> namedSizes() {
  return {{"slide", ExportForm::tr("Slide, 1280 × 720"), {1280, 720, false, 96}},
          {"hd", ExportForm::tr("Full HD, 1920 × 1080"), {1920, 1080, false, 144}},
          {"4k", ExportForm::tr("4K, 3840 × 2160"), {3840, 2160, false, 288}},
          {"column", ExportForm::tr("Column of a journal, 86 × 62 mm"), {86, 62, true, 600}},
          {"page", ExportForm::tr("Page of a journal, 178 × 130 mm"), {178, 130, true, 600}}};
}

/// Returns what a command reads where people may type a decimal comma.
QString machineNumber(const QLineEdit& entry) {
  return entry.text().trimmed().replace(',', '.');
}

void choose(QComboBox& box, const QString& word) {
  if (const int index = box.findData(word); index >= 0) box.setCurrentIndex(index);
}

/// Returns the size of a style.
std::optional<ExportSize> sizeOfStyle(const QString& name) {
  const FigureStyle style = readStyle(name.toStdString());
  const auto size = parsePictureSize(style.size);
  if (!size) return {};
  const bool isOnPaper = size->isOnPaper();
  const double inUnit = isOnPaper ? kInch / size->perInch : 1;
  const double usual = isOnPaper ? kPaper : kScreen;
  return ExportSize{inUnit * size->width, inUnit * size->height, isOnPaper,
                    style.dotsPerInch > 0 ? style.dotsPerInch : usual};
}

QString chosen(const QComboBox& box) {
  return box.currentData().toString();
}

}  // namespace

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
  addSize();
  density_ = addField<QLineEdit>(
      *rows_, "exportDensity", tr("&Resolution (dpi)"),
      tr("Pixels per inch. More of them make texts and lines of a picture in pixels "
         "larger, and a picture on paper finer."));
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
  choose(*theme_, shown_.dark ? "dark" : "");
  connectControls();
  showSize();
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
  for (QComboBox* box : {kind_, content_, format_, style_, preset_, unit_, theme_, speed_})
    connect(box, &QComboBox::currentIndexChanged, this, [this, box] { followChoice(box); });
  for (QLineEdit* entry : {width_, height_})
    connect(entry, &QLineEdit::textEdited, this, [this] { choose(*preset_, kOwn); });
  for (QLineEdit* entry : {width_, height_, density_, duration_, rate_, speedValue_, columns_,
                           realizations_, further_})
    connect(entry, &QLineEdit::textEdited, this, &ExportForm::changed);
  for (QCheckBox* box : {transparent_, asShown_})
    connect(box, &QCheckBox::toggled, this, &ExportForm::changed);
}

/// Fills what depends on a choice that the user has made.
void ExportForm::followChoice(const QComboBox* box) {
  if (box == kind_) fillContents();
  if (box == content_) fillFormats();
  if (box == style_) {
    fillSizes();
    choose(*preset_, chosen(*style_).isEmpty() ? kUsual : kOfStyle);
    if (!chosen(*style_).isEmpty())
      choose(*theme_, "");  // that of the style
    else if (shown_.dark && kind() != ExportKind::Figure)
      choose(*theme_, "dark");
  }
  if (box == preset_ || box == style_ || box == content_ || box == kind_) showSize();
  if (box == preset_ && isOnPaper() && chosen(*theme_) == "dark") choose(*theme_, "");
  if (box == unit_) {
    convertSize();
    choose(*preset_, kOwn);
  }
  showRows();
  emit changed();
}

/// Adds the named sizes, and below them width, height and unit in one row.
void ExportForm::addSize() {
  preset_ = addField<ChoiceBox>(*rows_, "exportPreset", tr("S&ize"));
  size_ = new QWidget;
  auto* row = marginless<QHBoxLayout>(size_);
  width_ = named<QLineEdit>("exportWidth");
  width_->setAccessibleName(tr("width"));
  height_ = named<QLineEdit>("exportHeight");
  height_->setAccessibleName(tr("height"));
  auto* units = named<ChoiceBox>("exportUnit");
  units->setSpoken(tr("unit of width and height"));
  unit_ = units;
  unit_->addItem(tr("pixels"), "");
  unit_->addItem("mm", "mm");
  size_->setToolTip(tr(
      "A picture on paper becomes higher where several panels need more room for their letters."));
  row->addWidget(width_, 1);
  row->addWidget(new QLabel(QStringLiteral("×")));
  row->addWidget(height_, 1);
  row->addWidget(unit_);
  rows_->addRow(QString(), size_);
}

void ExportForm::setKind(ExportKind kind) {
  kind_->setCurrentIndex(static_cast<int>(kind));
}

void ExportForm::setContent(const QString& content) {
  choose(*content_, content);
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
    choose(*theme_, "");  // that of print
  } else if (kind() == ExportKind::Table) {
    content_->addItem(tr("Friction curve"), "curve");
    if (isMotion_) content_->addItem(tr("Motion in time"), "motion");
    content_->addItem(tr("Contact, point by point"), "shape");
    content_->addItem(tr("List of contacts"), "contacts");
    if (isMotion_) choose(*content_, "motion");
  } else {
    content_->addItem(tr("Contact"), "contact");
    content_->addItem(tr("Contact and friction curve"), "both");
    if (isMotion_) content_->addItem(tr("Contact and motion in time"), "transient");
    if (kind() == ExportKind::Picture) {
      content_->addItem(tr("Friction curve"), "curve");
      if (isMotion_) content_->addItem(tr("Motion in time"), "motion");
    }
    choose(*content_, shown_.layout);
  }
  fillFormats();
}

void ExportForm::fillFormats() {
  const QSignalBlocker quiet(format_);
  const QString before = chosen(*format_);
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
  choose(*format_, before);
  fillSizes();
}

void ExportForm::fillSizes() {
  const QSignalBlocker quiet(preset_);
  const QString before = chosen(*preset_);
  preset_->clear();
  preset_->addItem(hasContact() ? tr("As in the window") : tr("Usual size"), kUsual);
  if (!chosen(*style_).isEmpty()) preset_->addItem(tr("As the style says"), kOfStyle);
  for (const NamedSize& each : namedSizes()) preset_->addItem(each.text, each.word);
  preset_->addItem(tr("Own size"), kOwn);
  choose(*preset_, before);
}

/// Shows the width, height and resolution of the named size.
void ExportForm::showSize() {
  const QString word = chosen(*preset_);
  if (word == kOwn) return;
  const auto ofStyle = word == kOfStyle ? sizeOfStyle(chosen(*style_)) : std::nullopt;
  if (word == kOfStyle && !ofStyle) return;
  if (hasOwnSize() && !ofStyle) {  // which the command chooses
    for (QLineEdit* entry : {width_, height_, density_}) entry->clear();
    return;
  }
  ExportSize size{1200, 800, false, kScreen};
  if (chosen(*content_) == "motion") size.height = 1000;
  if (chosen(*content_) == "curve") size.height = curveHeight(shown_.curves, {1200, 800}, 1);
  if (const QSize window = renderSize(shown_, chosen(*content_)); hasContact() && !window.isEmpty())
    size = {1.0 * window.width(), 1.0 * window.height(), false, kScreen * shown_.scale};
  for (const NamedSize& each : namedSizes())
    if (word == each.word) size = each.size;
  if (ofStyle) size = *ofStyle;
  const QSignalBlocker quiet(unit_);
  width_->setText(QString::number(size.width));
  height_->setText(QString::number(size.height));
  choose(*unit_, size.isOnPaper ? "mm" : "");
  density_->setText(QString::number(size.density));
}

/// Gives width and height in the unit that was just chosen, at the resolution of the form, so that
/// the picture keeps its size.
void ExportForm::convertSize() {
  const double perInch = machineNumber(*density_).toDouble();
  if (!(perInch > 0)) return;
  for (QLineEdit* entry : {width_, height_}) {
    const double size = machineNumber(*entry).toDouble();
    if (!(size > 0)) continue;
    entry->setText(isOnPaper() ? QString::number(size * kInch / perInch, 'g', 6)
                               : QString::number(std::round(size * perInch / kInch), 'g', 15));
  }
}

/// Returns whether the command chooses the size: that of the style, or of a figure.
bool ExportForm::hasOwnSize() const {
  const QString size = chosen(*preset_);
  return size == kOfStyle || (size == kUsual && kind() == ExportKind::Figure);
}

/// Returns whether the contact is drawn or listed, rather than diagrams alone.
bool ExportForm::hasContact() const {
  const QString content = chosen(*content_);
  return content != "curve" && content != "motion" && kind() != ExportKind::Figure;
}

/// Returns whether the format of the file knows transparency.
bool ExportForm::canBeTransparent() const {
  return kind() != ExportKind::Film || extension() != ".mp4";
}

bool ExportForm::isSlow() const {
  return chosen(*speed_) == "slow";
}

/// Returns whether the length of the film can be given: that of a whole motion follows from how
/// many times slower it is.
bool ExportForm::hasDuration() const {
  return !(isMotion_ && isSlow());
}

bool ExportForm::isOnPaper() const {
  return chosen(*unit_) == "mm";
}

/// Shows the rows that have a meaning for the kind.
void ExportForm::showRows() {
  const bool isTable = kind() == ExportKind::Table, isFilm = kind() == ExportKind::Film;
  const auto show = [this](QWidget* field, bool isShown) { setRowShown(*rows_, field, isShown); };
  for (QWidget* field : Widgets{style_, preset_, size_, density_, theme_, transparent_})
    show(field, !isTable);
  for (QWidget* field : Widgets{width_, height_, unit_, density_}) field->setEnabled(!hasOwnSize());
  show(asShown_, hasContact());
  asShown_->setText(isFilm ? tr("Same p&art of the line as in the window")
                           : tr("Same p&art of the line and moment as in the window"));
  transparent_->setEnabled(canBeTransparent());
  transparent_->setToolTip(canBeTransparent()
                               ? QString()
                               : tr("MP4 knows no transparency. WebM, GIF and WebP know it."));
  for (QWidget* field : Widgets{duration_, rate_, speedRow_}) show(field, isFilm);
  duration_->setEnabled(hasDuration());
  speedValue_->setEnabled(chosen(*speed_) != "whole");
  show(columns_, isTable);
  show(realizations_, kind() == ExportKind::Figure);
}

ExportRequest ExportForm::request() const {
  ExportRequest request;
  request.kind = kind();
  request.content = chosen(*content_);
  request.asShown = asShown_->isChecked();
  request.further = QProcess::splitCommand(further_->text());
  if (request.kind == ExportKind::Table) {
    request.columns = columns_->text().simplified().remove(' ');
    return request;
  }
  request.style = chosen(*style_);
  request.theme = chosen(*theme_);
  request.isTransparent = transparent_->isChecked() && canBeTransparent();
  if (request.kind == ExportKind::Figure) request.realizations = machineNumber(*realizations_);
  if (!hasOwnSize()) {
    const QString unit = chosen(*unit_);
    request.size = machineNumber(*width_) + unit + 'x' + machineNumber(*height_) + unit;
    const QString usual = QString::number(isOnPaper() ? kPaper : kScreen);
    if (const QString density = machineNumber(*density_);
        density != usual || !request.style.isEmpty())
      request.scale = density + QStringLiteral("dpi");
  }
  if (request.kind != ExportKind::Film) return request;
  if (hasDuration()) request.duration = machineNumber(*duration_);
  request.framesPerSecond = machineNumber(*rate_);
  if (isSlow()) request.slowMotion = machineNumber(*speedValue_);
  if (chosen(*speed_) == "cycles") request.cycles = machineNumber(*speedValue_);
  return request;
}

QString ExportForm::extension() const {
  return chosen(*format_);
}

void ExportForm::chooseExtension(const QString& extension) {
  const int index = extension.isEmpty() ? -1 : format_->findData(extension);
  if (index >= 0) format_->setCurrentIndex(index);
}

/// The command names the size that it was given and one that is enough, "640x444" and "640x530",
/// in pixels of the preview.
std::optional<double> ExportForm::heightEnough(const NeededHeight& needed) const {
  const double height = machineNumber(*height_).toDouble();
  if (isTyped("--size") || needed.enough <= needed.given || !(height > 0)) return std::nullopt;
  return std::ceil(height * needed.enough / needed.given);
}

bool ExportForm::raiseHeight(double height) {
  if (chosen(*preset_) != kUsual || hasOwnSize()) return false;
  height_->setText(QString::number(height));  // textEdited is not emitted: the size stays the usual
  return true;
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
  return sizeError();
}

/// Returns the entries that have a meaning for the kind and hold a number, but for the size.
std::vector<const QLineEdit*> ExportForm::numbers() const {
  if (kind() == ExportKind::Figure) return {realizations_};
  if (kind() != ExportKind::Film) return {};
  std::vector<const QLineEdit*> numbers{rate_};
  if (hasDuration()) numbers.push_back(duration_);
  if (chosen(*speed_) != "whole") numbers.push_back(speedValue_);
  return numbers;
}

QString ExportForm::sizeError() const {
  if (kind() == ExportKind::Table || hasOwnSize()) return {};
  const QSizeF size = pixels();
  if (!(size.width() > 0 && size.height() > 0 && machineNumber(*density_).toDouble() > 0))
    return tr("Width, height and resolution are numbers above 0.");
  for (const auto& [name, side] :
       {std::pair(tr("width"), size.width()), std::pair(tr("height"), size.height())})
    if (side < kSmallestPicture - 0.5 || side >= kLargestPicture + 0.5)
      return tr("The picture has a %1 of %2 pixels; %3 to %4 are allowed.")
          .arg(name, readingLabel(side))
          .arg(kSmallestPicture)
          .arg(kLargestPicture);
  return {};
}

QString ExportForm::inWords(const QString& reason, const NeededHeight& needed) const {
  const QString option = reason.section(':', 0, 0);
  if (isTyped(option)) return reason;
  if (option == "--size") {
    if (const auto height = heightEnough(needed))
      return tr("The picture is too small for its diagrams; %1 × %2 %3 are enough.")
          .arg(width_->text(), QString::number(*height), unit_->currentText());
    return tr("The picture is too small for its diagrams; make it higher or wider.");
  }
  for (const auto& [name, entry] :
       {std::pair("--scale", density_), std::pair("--fps", rate_),
        std::pair("--duration", duration_), std::pair("--cycles", speedValue_),
        std::pair("--slow-motion", speedValue_), std::pair("--columns", columns_),
        std::pair("--realizations", realizations_)})
    if (option == QLatin1String(name)) return entry->accessibleName() + reason.mid(option.size());
  return reason;
}

QSizeF ExportForm::pixels() const {
  const QSizeF size(machineNumber(*width_).toDouble(), machineNumber(*height_).toDouble());
  return isOnPaper() ? size * (machineNumber(*density_).toDouble() / kInch) : size;
}

}  // namespace asperity
