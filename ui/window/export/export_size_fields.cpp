#include "ui/window/export/export_size_fields.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <cmath>
#include <utility>

#include "core/chart/figure_style.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"

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
  return {{"slide", ExportSizeFields::tr("Slide, 1280 × 720"), {1280, 720, false, 96}},
          {"hd", ExportSizeFields::tr("Full HD, 1920 × 1080"), {1920, 1080, false, 144}},
          {"4k", ExportSizeFields::tr("4K, 3840 × 2160"), {3840, 2160, false, 288}},
          {"column", ExportSizeFields::tr("Column of a journal, 86 × 62 mm"), {86, 62, true, 600}},
          {"page", ExportSizeFields::tr("Page of a journal, 178 × 130 mm"), {178, 130, true, 600}}};
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

double numberOf(const QLineEdit& entry) {
  return machineNumber(entry).toDouble();
}

}  // namespace

QString machineNumber(const QLineEdit& entry) {
  return withoutGroups(entry.text().trimmed());
}

ExportSizeFields::ExportSizeFields(QFormLayout& rows, const RenderCommandOptions& shown)
    : QObject(rows.parentWidget()), rows_(rows), shown_(shown) {
  preset_ = addField<ChoiceBox>(rows_, "exportPreset", tr("S&ize"));
  addSize();
  density_ = addField<QLineEdit>(
      rows_, "exportDensity", tr("&Resolution (dpi)"),
      tr("Pixels per inch. More of them make texts and lines of a picture in pixels "
         "larger, and a picture on paper finer."));
  connect(preset_, &QComboBox::currentIndexChanged, this, [this] {
    showSize();
    emit presetChanged();
  });
  connect(unit_, &QComboBox::currentIndexChanged, this, [this] {
    convertSize();
    chooseWord(*preset_, kOwn);
    emit changed();
  });
  for (QLineEdit* entry : {width_, height_})
    connect(entry, &QLineEdit::textEdited, this, [this] { chooseWord(*preset_, kOwn); });
  for (QLineEdit* entry : {width_, height_, density_})
    connect(entry, &QLineEdit::textEdited, this, &ExportSizeFields::changed);
}

/// Adds width, height and unit in one row.
void ExportSizeFields::addSize() {
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
  rows_.addRow(QString(), size_);
}

void ExportSizeFields::setContent(const ExportContent& content) {
  const bool hasOtherStyle = content.style != content_.style;
  content_ = content;
  const QSignalBlocker quiet(preset_);
  fillPresets();
  if (hasOtherStyle) chooseWord(*preset_, content_.style.isEmpty() ? kUsual : kOfStyle);
  showSize();
}

void ExportSizeFields::fillPresets() {
  const QString before = chosenWord(*preset_);
  preset_->clear();
  preset_->addItem(content_.hasContact ? tr("As in the window") : tr("Usual size"), kUsual);
  if (!content_.style.isEmpty()) preset_->addItem(tr("As the style says"), kOfStyle);
  for (const NamedSize& each : namedSizes()) preset_->addItem(each.text, each.word);
  preset_->addItem(tr("Own size"), kOwn);
  chooseWord(*preset_, before);
}

/// Shows the width, height and resolution of the named size.
void ExportSizeFields::showSize() {
  for (QWidget* field : Widgets{preset_, size_, density_})
    setRowShown(rows_, field, content_.kind != ExportKind::Table);
  for (QWidget* field : Widgets{width_, height_, unit_, density_})
    field->setEnabled(!isChosenByCommand());
  const QString word = chosenWord(*preset_);
  if (word == kOwn) return;
  const auto ofStyle = word == kOfStyle ? sizeOfStyle(content_.style) : std::nullopt;
  if (word == kOfStyle && !ofStyle) return;
  if (isChosenByCommand() && !ofStyle) {
    for (QLineEdit* entry : {width_, height_, density_}) entry->clear();
    return;
  }
  ExportSize size{1200, 800, false, kScreen};
  if (content_.word == "motion") size.height = 1000;
  if (content_.word == "curve") size.height = curveHeight(shown_.curves, {1200, 800}, 1);
  if (const QSize window = renderSize(shown_, content_.word);
      content_.hasContact && !window.isEmpty())
    size = {1.0 * window.width(), 1.0 * window.height(), false, kScreen * shown_.scale};
  for (const NamedSize& each : namedSizes())
    if (word == each.word) size = each.size;
  if (ofStyle) size = *ofStyle;
  const QSignalBlocker quiet(unit_);
  width_->setText(QString::number(size.width));
  height_->setText(QString::number(size.height));
  chooseWord(*unit_, size.isOnPaper ? "mm" : "");
  density_->setText(QString::number(size.density));
}

/// Gives width and height in the unit that was just chosen, at the resolution of the rows, so that
/// the picture keeps its size.
void ExportSizeFields::convertSize() {
  const double perInch = numberOf(*density_);
  if (!(perInch > 0)) return;
  for (QLineEdit* entry : {width_, height_}) {
    const double size = numberOf(*entry);
    if (!(size > 0)) continue;
    entry->setText(isOnPaper() ? QString::number(size * kInch / perInch, 'g', 6)
                               : QString::number(std::round(size * perInch / kInch), 'g', 15));
  }
}

/// Returns whether the command chooses the size: that of the style, or of a figure.
bool ExportSizeFields::isChosenByCommand() const {
  const QString size = chosenWord(*preset_);
  return size == kOfStyle || (size == kUsual && content_.kind == ExportKind::Figure);
}

void ExportSizeFields::writeTo(ExportRequest& request) const {
  if (isChosenByCommand()) return;
  const QString unit = chosenWord(*unit_);
  request.size = machineNumber(*width_) + unit + 'x' + machineNumber(*height_) + unit;
  const QString usual = QString::number(isOnPaper() ? kPaper : kScreen);
  if (const QString density = machineNumber(*density_);
      density != usual || !request.style.isEmpty())
    request.scale = density + QStringLiteral("dpi");
}

bool ExportSizeFields::isOnPaper() const {
  return chosenWord(*unit_) == "mm";
}

QSizeF ExportSizeFields::pixels() const {
  const QSizeF size(numberOf(*width_), numberOf(*height_));
  return isOnPaper() ? size * (numberOf(*density_) / kInch) : size;
}

QString ExportSizeFields::errorText() const {
  if (content_.kind == ExportKind::Table || isChosenByCommand()) return {};
  const QSizeF size = pixels();
  if (!(size.width() > 0 && size.height() > 0 && numberOf(*density_) > 0))
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

/// The command names the size that it was given and one that is enough, "640x444" and "640x530",
/// in pixels of the preview.
std::optional<double> ExportSizeFields::heightEnough(const NeededHeight& needed) const {
  const double height = numberOf(*height_);
  if (needed.enough <= needed.given || !(height > 0)) return std::nullopt;
  return std::ceil(height * needed.enough / needed.given);
}

bool ExportSizeFields::raiseHeight(double height) {
  if (chosenWord(*preset_) != kUsual || isChosenByCommand()) return false;
  height_->setText(QString::number(height));  // textEdited is not emitted: the size stays the usual
  return true;
}

QString ExportSizeFields::tooSmallText(const NeededHeight& needed) const {
  if (const auto height = heightEnough(needed))
    return tr("The picture is too small for its diagrams; %1 × %2 %3 are enough.")
        .arg(width_->text(), QString::number(*height), unit_->currentText());
  return tr("The picture is too small for its diagrams; make it higher or wider.");
}

}  // namespace asperity
