#include "ui/window/curve/influence_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <stdexcept>

#include "core/chart/influence_sheets.h"
#include "core/friction/short_wave_cutoff.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "ui/draw/picture_file.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/window/figures/diagram_view.h"

namespace asperity {

namespace {

/// Returns the scene without its sweep, which does not change friction at the scene's own velocity,
/// and without its target accuracy: differences need the same lines on both sides.
Scene withStatedLines(const Scene& scene) {
  Scene state = scene;
  state.sweep = {};
  state.accuracy.targetRelativeError = 0;
  return state;
}

struct Result {
  DiagramSheet sheet;
  std::string table;
};

Result computeSensitivity(const Scene& scene, const StateOptions& options) {
  requireSteadySliding(scene, "the sensitivity");
  const std::vector<Exponent> exponents =
      sensitivityExponents(scene, sensitivities(scene, options));
  return {sensitivitySheet(scene, exponents), sensitivityCsv(exponents)};
}

Result computeCutoff(const Scene& scene, const StateOptions& options) {
  requireSteadySliding(scene, "the short-wave cut-off");
  const std::vector<CutoffPoint> points = frictionOverCutoff(scene, options);
  return {cutoffSheet(scene, points), cutoffCsv(points)};
}

}  // namespace

InfluencePage::InfluencePage(QWidget* parent)
    : QWidget(parent),
      choice_(named<ChoiceBox>("influenceChoice")),
      hint_(new QLabel),
      view_(named<DiagramView>("influenceView")) {
  setObjectName("influencePage");
  choice_->addItem(QString(), false);
  choice_->addItem(QString(), true);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  hint_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 8, 0);
  row->addWidget(choice_);
  row->addSpacing(6);
  row->addWidget(hint_, 1);
  auto* column = marginless<QVBoxLayout>(this, 2);
  column->addLayout(row);
  auto* scroll = scrolled(view_);
  scroll->setFocusPolicy(Qt::NoFocus);
  column->addWidget(scroll, 1);
  connect(choice_, &QComboBox::currentIndexChanged, this, [this] {
    showTexts();
    compute();
  });
  keepTranslated(*this, [this] { showTexts(); });
}

/// Returns the height in which the names of all bars can be read.
int InfluencePage::heightFor(const DiagramSheet& sheet) const {
  const int line = fontMetrics().height();
  const auto bars = static_cast<int>(sheet.diagrams.front().bars.size());
  return bars > 0 ? (bars + 4) * line : 0;
}

void InfluencePage::showTexts() {
  choice_->setSpoken(tr("what friction depends on"));
  choice_->setItemText(0, tr("Which parameter matters"));
  choice_->setItemText(1, tr("Which wavelengths matter"));
  hint_->setText(showsWaves() ? tr("friction without the waves below a cut-off")
                              : tr("% of friction for 1 % of each parameter"));
  view_->setAccessibleName(choice_->currentText());
  view_->setToolTip(translatedText(note_));
  showProgress();
}

/// Shows how much is computed, while there is nothing else to show.
void InfluencePage::showProgress() {
  if (work_.isBusy())
    view_->setPlaceholder(tr("The influences are being computed… %1 %").arg(percent_));
}

bool InfluencePage::showsWaves() const {
  return choice_->currentData().toBool();
}

void InfluencePage::showScene(const Scene& scene) {
  scene_ = withStatedLines(scene);
  if (isVisible()) compute();
}

void InfluencePage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  compute();
}

/// Stops the computation: a hidden page takes no processor time.
void InfluencePage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  work_.cancel();
}

void InfluencePage::compute() {
  if (!scene_ || !isVisible()) return;
  const bool hasWaves = showsWaves();
  // Another computation may be under way.
  if (shown_ == scene_ && shownWaves_ == hasWaves) return work_.cancel();
  // The diagram of another question would pass for the answer to this one.
  if (shownWaves_ != hasWaves) {
    view_->clear();
    shown_.reset();
  }
  percent_ = 0;
  work_.request(
      [this, scene = *scene_, hasWaves](const BackgroundWork::Run& run) {
        StateOptions options{.stop = run.stop()};
        options.progress = run.percents([this](int percent) {
          percent_ = percent;
          showProgress();
        });
        return hasWaves ? computeCutoff(scene, options) : computeSensitivity(scene, options);
      },
      [this, scene = *scene_, hasWaves](const Result& result) {
        shown_ = scene;
        shownWaves_ = hasWaves;
        showResult(result.sheet, result.table);
      },
      [this](const LiveText& reason) { showFailure(reason); });
  showProgress();
}

void InfluencePage::showResult(const DiagramSheet& sheet, const std::string& table) {
  note_ = sheet.note;
  // The window shows title and scene above the diagram; without them the names of the bars have
  // more space.
  DiagramSheet shown = sheet;
  shown.title = shown.subtitle = shown.note = {};
  view_->setToolTip(translatedText(note_));
  view_->setMinimumHeight(heightFor(shown));
  const char* verb = shownWaves_ ? "cutoff" : "sensitivity";
  view_->show([shown] { return shown; },
              {verb, [scene = *shown_, verb] { return pictureOrigin(verb, scene); },
               [scene = *shown_, verb, table] { return provenanceComment(verb, scene) + table; },
               [sheet] { return sheet; }});
}

void InfluencePage::showFailure(const LiveText& reason) {
  shown_.reset();
  note_ = {};
  view_->setPlaceholder({});
  view_->setToolTip({});
  view_->setMinimumHeight(0);
  view_->show(
      [reason]() -> DiagramSheet { throw std::runtime_error(QString(reason).toStdString()); });
}

}  // namespace asperity
