#include "ui/window/import/surface_import.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/run/measured_sheet.h"
#include "core/scene/parameters.h"
#include "core/surface/line_source.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/parameter_row.h"
#include "ui/panels/scene_files.h"
#include "ui/window/figures/diagram_view.h"

namespace asperity {

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
  if (!std::isfinite(value)) return QStringLiteral("–");
  return inLanguage(QString::fromStdString(unit.empty() ? printedNumber(value, 4)
                                                        : printedQuantity(value, unit, 4)))
      .toHtmlEscaped();
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

QLabel* addText(QVBoxLayout& column, const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column.addWidget(label);
  return label;
}

}  // namespace

SurfaceImport::SurfaceImport(const Scene& scene, const QString& file, const Theme& theme,
                             QWidget* parent)
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
  buildViews(theme);
  halves().addWidget(panel_);
  restart();
}

void SurfaceImport::buildViews(const Theme& theme) {
  topography_ = new TopographyPicture;
  topography_->hide();
  auto* texts = new QWidget;
  auto* column = new QVBoxLayout(texts);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  notes_ = addText(*column, "surfaceNotes");
  notes_->setProperty("role", "warning");
  notes_->setStyleSheet(panelStyleSheet(palette()));
  facts_ = addText(*column, "surfaceFacts");
  column->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidget(texts);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  values_ = new QLabel;
  values_->setObjectName("surfaceValues");
  values_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  values_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* head = new QHBoxLayout;
  head->setSpacing(14);
  head->addWidget(topography_);
  head->addWidget(values_);
  head->addWidget(scroll, 1);
  scroll->setFixedHeight(10 * fontMetrics().lineSpacing());  // the views below stay where they are
  profile_ = new DiagramView;
  profile_->setObjectName("surfaceProfile");
  profile_->setAccessibleName(tr("the profile, raw and used"));
  spectrum_ = new DiagramView;
  spectrum_->setObjectName("surfaceSpectrum");
  spectrum_->setAccessibleName(tr("spectrum and distribution of the heights, raw and used"));
  for (DiagramView* view : {profile_, spectrum_}) view->setTheme(theme);
  views().addLayout(head);
  views().addWidget(profile_, 4);
  views().addWidget(spectrum_, 5);
}

/// Reads and processes in the background. The file is read once, because core keeps the last one.
void SurfaceImport::begin() {
  work_.request(
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
    return finish((parameter ? ParameterRow::labelText(*parameter) : QFileInfo(file()).fileName()) +
                  ": " + text);
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
    const auto quantity = [](double value, const char* unit) {
      return inLanguage(QString::fromStdString(printedQuantity(value, unit, 4)));
    };
    facts += tr("Normal force %1 on one period of %2, F\u2099/L = %3.")
                 .arg(quantity(load.normalForce, "N"), quantity(summary.period, "m"),
                      quantity(load.normalForce / summary.period, "N/m"));
  }
  for (const Note note : summary.notes.list())
    notes += QStringLiteral("⚠ ") + sentence(withLabels(translatedText(noteSentence(note))));
  facts_->setText(facts.join('\n'));
  notes_->setText(keptTogether(notes.join('\n')));
  notes_->setVisible(!notes.isEmpty());
  values_->setText(valuesTable(summary));
  // Shows the sheet of the command in two views: the profile over the whole width, the rest below.
  // The texts of its headings are shown beside it.
  profile_->show([summary] {
    DiagramSheet sheet = measuredSheet(summary, {});
    sheet.diagrams.resize(sheet.diagrams.size() - 2);
    sheet.title = sheet.subtitle = sheet.note = {};
    return sheet;
  });
  spectrum_->show([summary] {
    DiagramSheet sheet = measuredSheet(summary, {});
    sheet.diagrams.erase(sheet.diagrams.begin(), sheet.diagrams.end() - 2);
    sheet.title = sheet.subtitle = {};
    sheet.columns = 2;
    return sheet;
  });
}

}  // namespace asperity
