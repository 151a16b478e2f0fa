#include "ui/window/import/surface_import.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/statistics.h"
#include "core/run/measured_sheet.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_files.h"
#include "core/surface/line_source.h"
#include "ui/draw/fonts.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/figures/diagram_view.h"

namespace asperity {

// ---- The topography from above

namespace {

/// Shades that stay apart in print and for colour-blind eyes: from dark blue over green to yellow.
QRgb topographyShade(double part) {
  static constexpr std::array<QColor, 5> kStops{
      {{45, 20, 80}, {50, 80, 140}, {35, 140, 140}, {95, 200, 100}, {250, 230, 60}}};
  const double position = std::clamp(part, 0.0, 1.0) * (kStops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), kStops.size() - 2);
  return mixed(kStops[below], kStops[below + 1], position - static_cast<double>(below)).rgb();
}

/// Returns the mean height of each patch of the grid; NaN where nothing was measured.
std::vector<double> patches(const Topography& topography, int width, int height) {
  std::vector<double> means;
  means.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    const std::int64_t top = y * topography.rows / height;
    const std::int64_t bottom = std::max(top + 1, (y + 1) * topography.rows / height);
    for (int x = 0; x < width; ++x) {
      const std::int64_t left = x * topography.columns / width;
      const std::int64_t right = std::max(left + 1, (x + 1) * topography.columns / width);
      double sum = 0;
      int count = 0;
      for (std::int64_t row = top; row < bottom; ++row)
        for (std::int64_t column = left; column < right; ++column)
          if (const double value = topography.at(row, column); !std::isnan(value)) {
            sum += value;
            ++count;
          }
      means.push_back(count > 0 ? sum / count : kNaN);
    }
  }
  return means;
}

}  // namespace

TopographyImage topographyImage(const Topography& topography, bool isTurned, int maxPixels) {
  TopographyImage made;
  if (topography.isProfile()) return made;
  const int width = static_cast<int>(std::min<std::int64_t>(topography.columns, maxPixels));
  const int height = static_cast<int>(std::min<std::int64_t>(topography.rows, maxPixels));
  const std::vector<double> means = patches(topography, width, height);
  std::vector<double> sorted;
  for (const double value : means)
    if (!std::isnan(value)) sorted.push_back(value);
  if (sorted.empty()) return made;
  std::ranges::sort(sorted);
  const std::size_t edge = sorted.size() / 100;
  made.lowest = sorted[edge];
  made.highest = sorted[sorted.size() - 1 - edge];
  const double range = made.highest > made.lowest ? made.highest - made.lowest : 1;
  QImage image(width, height, QImage::Format_ARGB32);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double value = means[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x)];
      image.setPixel(
          x, y,
          std::isnan(value) ? qRgba(0, 0, 0, 0) : topographyShade((value - made.lowest) / range));
    }
  made.isTurned = isTurned;
  made.image = isTurned ? image.transformed(QTransform(0, 1, 1, 0, 0, 0)) : image;
  made.width = isTurned ? topography.width() : topography.length();
  made.height = isTurned ? topography.length() : topography.width();
  return made;
}

TopographyPicture::TopographyPicture(QWidget* parent) : QWidget(parent) {
  setObjectName("topographyPicture");
}

void TopographyPicture::show(const TopographyImage& image, double row) {
  shown_ = image;
  row_ = row;
  setAccessibleName(tr("topography"));
  if (!image.image.isNull())
    setToolTip(tr("%1 × %2, heights over %3")
                   .arg(quantityLabel(image.width, "m"), quantityLabel(image.height, "m"),
                        quantityLabel(image.highest - image.lowest, "m")));
  setVisible(!image.image.isNull());
  update();
}

void TopographyPicture::paintEvent(QPaintEvent*) {
  if (shown_.image.isNull()) return;
  QPainter painter(this);
  const QString text = QStringLiteral("%1 × %2").arg(quantityLabel(shown_.width, "m"),
                                                     quantityLabel(shown_.height, "m"));
  const int line = fontMetrics().height();
  // Very long and narrow surfaces are shown less narrow than they are.
  constexpr double kNarrowest = 4;
  const QRectF available = QRectF(rect()).adjusted(1, 1, -1, -line - 4);
  const double ratio = std::clamp(shown_.width / shown_.height, 1 / kNarrowest, kNarrowest);
  QSizeF frame(available.width(), available.width() / ratio);
  if (frame.height() > available.height()) frame = {available.height() * ratio, available.height()};
  const QRectF imageRect({available.left(), available.top()}, frame);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(imageRect, shown_.image);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(imageRect);
  const QColor mark(255, 60, 60);
  if (row_ >= 0) {
    painter.setPen(QPen(mark, 2));
    if (shown_.isTurned) {
      const double x = imageRect.left() + row_ * imageRect.width();
      painter.drawLine(QPointF(x, imageRect.top()), QPointF(x, imageRect.bottom()));
    } else {
      const double y = imageRect.top() + row_ * imageRect.height();
      painter.drawLine(QPointF(imageRect.left(), y), QPointF(imageRect.right(), y));
    }
  } else {
    painter.setPen(QPen(mark, 2));
    painter.drawRect(imageRect.adjusted(1, 1, -1, -1));
  }
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(0, height() - line - 2, width(), line + 2),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(text, Qt::ElideRight, width()));
}

// ---- The page

/// The result of preparing a scene in the background.
struct SurfaceImport::Preview {
  std::optional<MeasuredSummary> summary{};
  LineSize line{};
  TopographyImage image{};
  // An error: the parameter, which may be empty, and core's message.
  std::optional<std::pair<QString, Message>> fault{};
};

namespace {

constexpr double kReading = 0.3;  // part of the work, where a spectrum follows

std::vector<ParameterGroup> groups() {
  return {
      {[] { return SurfaceImport::tr("The file"); },
       {"surface.format", "surface.position_unit", "surface.height_unit", "surface.point_spacing",
        "surface.position_column", "surface.height_column", "surface.direction", "surface.row"}},
      {[] { return SurfaceImport::tr("Levelling and filters"); },
       {"surface.gaps", "surface.outliers", "surface.form", "surface.short_wave_cut",
        "surface.long_wave_cut"}},
      {[] { return SurfaceImport::tr("The line that slides"); },
       {"surface.seam", "surface.blend_length", "surface.seed", "surface.line",
        "surface.contact_side", "surface.length", "surface.elements", "ensemble.realizations"}}};
}

QString valueText(double value, const std::string& unit) {
  return quantityLabel(value, unit, 4).toHtmlEscaped();
}

/// A table of the values before and after.
QString valuesTable(const MeasuredSummary& summary) {
  const QString cell = QStringLiteral("<td align=right style='padding-left:14px'>%1</td>");
  QString rows = "<tr><td></td>" + cell.arg(SurfaceImport::tr("raw")) +
                 cell.arg("<b>" + SurfaceImport::tr("used") + "</b>") + "</tr>";
  for (const NamedValue& value : namedValues(summary))
    rows += "<tr><td>" + QString::fromStdString(value.name).toHtmlEscaped() + "</td>" +
            cell.arg(valueText(value.raw, value.unit)) +
            cell.arg("<b>" + valueText(value.used, value.unit) + "</b>") + "</tr>";
  return "<table cellspacing=0 cellpadding=1>" + rows + "</table>";
}

}  // namespace

SurfaceImport::SurfaceImport(const Scene& scene, const QString& file, QWidget* parent)
    : ImportPage(file, tr("&Use this surface"), parent), scene_(scene) {
  setObjectName("surfaceImport");
  setWindowTitle(tr("Open surface"));
  useSurface(scene_, file.toStdString());
  panel_ = new ParameterPanel(scene_, groups(), this);
  connect(panel_, &ParameterPanel::sceneEdited, this, [this](const Scene& edited) {
    scene_ = edited;
    restart();
  });
  connect(this, &QDialog::accepted, this, [this] { emit sceneChosen(scene_); });
  buildViews();
  halves().addWidget(panel_);
  restart();
}

void SurfaceImport::buildViews() {
  topography_ = new TopographyPicture;
  topography_->hide();
  notes_ = warningTextLabel("surfaceNotes");
  facts_ = textLabel("surfaceFacts");
  values_ = named<QLabel>("surfaceValues");
  values_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  values_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* head = new QHBoxLayout;
  head->setSpacing(14);
  head->addWidget(topography_);
  head->addWidget(values_);
  head->addWidget(scrolledTexts({notes_, facts_}, 10, tr("what is known of the surface")), 1);
  profile_ = named<DiagramView>("surfaceProfile");
  profile_->setAccessibleName(tr("the profile, raw and used"));
  spectrum_ = named<DiagramView>("surfaceSpectrum");
  spectrum_->setAccessibleName(tr("spectrum and distribution of the heights, raw and used"));
  views().addLayout(head);
  views().addWidget(profile_, 4);
  views().addWidget(spectrum_, 5);
}

/// Reads and processes in the background. The file is read once, because core keeps the last one.
void SurfaceImport::begin() {
  work().request(
      [this, scene = scene_](const BackgroundWork::Run& run) {
        Preview preview;
        try {
          // The bar runs once from end to end: first the file, then the spectrum of all its rows.
          const bool hasSpectrum = scene.surface.line == LineKind::IsotropicEquivalent ||
                                   scene.surface.processing.seam == Seam::RandomPhases;
          const double reading = hasSpectrum ? kReading : 1;
          const auto within = [&](double from, double to) {
            return [this, &run, from, to](double part) {
              run.post([this, done = from + (to - from) * part] { showProgress(done); });
            };
          };
          const auto file = readMeasuredSurface(scene, run.stop(), within(0, reading));
          preview.image = topographyImage(
              file->topography, scene.surface.reading.direction == ProfileDirection::AlongY);
          const auto lines = MeasuredLines::of(scene, run.stop(), within(reading, 1));
          const LineSource source(scene, 1);
          preview.line = {source.length(), source.elements()};
          preview.summary = measuredSummary(scene, source);
        } catch (const InputError& error) {
          preview.fault = {QString::fromStdString(error.key()), error.message()};
        } catch (const std::bad_alloc&) {
          preview.fault = {QString(), Message("there is not enough memory for this surface")};
        }
        return preview;
      },
      [this](const Preview& preview) { take(preview); },
      [this](const QString& reason) { finish(reason); });
}

void SurfaceImport::take(const Preview& preview) {
  panel_->clearErrors();
  summary_ = preview.summary;
  double row = -1;
  if (summary_ && summary_->rowsUsed == 1)
    row = (static_cast<double>(summary_->rowInFile) - 0.5) / static_cast<double>(summary_->rows);
  topography_->show(preview.image, row);
  if (preview.fault) {
    const auto& [key, message] = *preview.fault;
    const QString text = withLabels(translatedText(message));
    panel_->showError(key, text);
    const Parameter* parameter = findParameter(key.toStdString());
    return finish((parameter ? labelText(*parameter) : QFileInfo(file()).fileName()) + ": " + text);
  }
  panel_->showLine(preview.line);
  showSummary(*summary_);
  finish({});
}

void SurfaceImport::showSummary(const MeasuredSummary& summary) {
  QStringList facts, notes;
  for (const Message& fact : factsOf(summary)) facts += sentence(withLabels(translatedText(fact)));
  // A mirrored period is twice the file, and the force stays that on one period.
  const Load load = loadOn(scene_.load, summary.period);
  if (load.kind == LoadKind::Force) {
    facts +=
        tr("Normal force %1 on one period of %2, that is %3.")
            .arg(quantityLabel(load.normalForce, "N", 4), quantityLabel(summary.period, "m", 4),
                 quantityLabel(load.normalForce / summary.period, "N/m", 4));
  }
  facts += translatedText(measuredSheetNote());
  for (const Note note : summary.notes.list())
    notes += sentence(withLabels(translatedText(noteSentence(note))));
  facts_->setText(facts.join('\n'));
  showWarnings(*notes_, notes);
  values_->setText(valuesTable(summary));
  // Shows the sheet of the command in two views: the profile over the whole width, the rest below.
  // Its texts are shown beside it.
  profile_->show([summary] {
    DiagramSheet sheet = measuredSheet(summary, {});
    sheet.diagrams.resize(sheet.diagrams.size() - 2);
    sheet.title = sheet.subtitle = sheet.note = {};
    return sheet;
  });
  spectrum_->show([summary] {
    DiagramSheet sheet = measuredSheet(summary, {});
    sheet.diagrams.erase(sheet.diagrams.begin(), sheet.diagrams.end() - 2);
    sheet.title = sheet.subtitle = sheet.note = {};
    sheet.columns = 2;
    return sheet;
  });
}

}  // namespace asperity
