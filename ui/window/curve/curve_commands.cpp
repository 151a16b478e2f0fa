#include "ui/window/curve/curve_commands.h"

#include <QAction>
#include <QMenu>
#include <filesystem>
#include <utility>

#include "core/accuracy/compute_curve.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/stop.h"
#include "core/chart/curve_diagram.h"
#include "core/chart/curve_words.h"
#include "core/scene/provenance.h"
#include "core/scene/sweep.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/pixel_context.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/exports.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

constexpr double kZoom = 1.5;  // factor of one command

/// Computes the whole curve of a scene, as the chart pins it. Throws as computeCurve() does, and
/// StopRequested where it was stopped.
std::shared_ptr<const CurveUpdate> computeCurveToPin(const Scene& scene,
                                                     const std::stop_token& stop) {
  Curve curve = computeCurve(scene, {.stop = stop});
  if (!curve.isComplete) throw StopRequested{};
  auto update = std::make_shared<CurveUpdate>();
  update->scene = std::make_shared<const Scene>(scene);
  update->realizationsDone = update->realizationsTotal = curve.points.front().realizations;
  update->points = std::move(curve.points);
  update->isComplete = true;
  return update;
}

}  // namespace

void pinCurves(Session& session, BackgroundWork& work, std::function<std::vector<Scene>()> scenes,
               BackgroundWork::Failed failed) {
  using Curves = std::vector<std::shared_ptr<const CurveUpdate>>;
  work.request(
      [scenes = std::move(scenes)](const BackgroundWork::Run& run) {
        Curves curves;
        for (const Scene& scene : scenes()) curves.push_back(computeCurveToPin(scene, run.stop()));
        return curves;
      },
      [&session](const Curves& curves) {
        session.editCurve([&](FrictionChartModel& plot) {
          for (const auto& curve : curves) plot.pin(curve);
        });
      },
      std::move(failed));
}

CurveCommands::CurveCommands(Session& session, ChartView& view, Exports& exports,
                             MessageBar& messages, QObject* parent)
    : QObject(parent), session_(session), view_(view), exports_(exports), messages_(messages) {
  pin_ = add(
      "pinCurve", [] { return tr("Pin curve"); },
      [this] { session_.editCurve([](FrictionChartModel& plot) { plot.pin(); }); },
      [] { return tr("Keeps this curve to compare others with"); });
  pin_->setShortcut(Qt::Key_P);
  unpinAll_ = add(
      "unpinAll", [] { return tr("Unpin all"); },
      [this] { session_.editCurve([](FrictionChartModel& plot) { plot.unpinAll(); }); });
  unpinAll_->setShortcut(Qt::SHIFT | Qt::Key_P);
  dimensionless_ = add(
      "dimensionlessAxes", [] { return tr("Dimensionless axes"); }, [] {},
      [] { return tr("v̄ of Eq. (13) and μ over the rms slope of the line"); });
  dimensionless_->setCheckable(true);
  dimensionless_->setShortcut(Qt::Key_D);
  connect(dimensionless_, &QAction::toggled, this, &CurveCommands::setAxes);
  linearX_ = add(
      "linearAxis", [] { return tr("Linear horizontal axis"); },
      [this] { spaceEvenly(linearX_->isChecked()); });
  linearX_->setCheckable(true);
  linearY_ = add(
      "linearQuantity", [] { return tr("Linear vertical axis"); },
      [this] {
        session_.editCurve(
            [this](FrictionChartModel& plot) { plot.setLinearY(linearY_->isChecked()); });
      });
  linearY_->setCheckable(true);
  nearer_ = add(
      "curveNearer", [] { return tr("Zoom in"); }, [this] { view_.zoom(1 / kZoom); });
  farther_ = add(
      "curveFarther", [] { return tr("Zoom out"); }, [this] { view_.zoom(kZoom); });
  fit_ = add(
      "curveFit", [] { return tr("Fit axes"); },
      [this] {
        view_.fit();
        session_.editCurve([](FrictionChartModel& plot) { plot.fitVerticalAxis(); });
      });
  save_ = add(
      "saveCurve", [] { return tr("Save curve…"); }, [this] { askSave(); },
      [] { return tr("Everything that is shown, as a picture or as a table"); });
  save_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_E);
  copy_ = add(
      "copyCurvePicture", [] { return tr("Copy curve picture"); }, [this] { copyPicture(); });
  guide_ = add(
      "aboutCurve", [] { return tr("Read about it in the guide"); },
      [this] { emit guideRequested(view_.guideAnchor()); },
      [] { return tr("Opens the guide at what is under the pointer: a region, a curve, a law"); });
  connect(&session_, &Session::plotChanged, this, &CurveCommands::showState);
  connect(&view_, &ChartView::fitRequested, fit_, &QAction::trigger);
}

QAction* CurveCommands::add(const char* name, Text text, std::function<void()> run, Text tip) {
  auto* action = named<QAction>(name, this);
  connect(action, &QAction::triggered, this, std::move(run));
  keepTranslated(*this, [action, text, tip] {
    action->setText(text());
    if (tip) action->setToolTip(tip());
  });
  return action;
}

void CurveCommands::fill(QMenu& menu) {
  menu.setToolTipsVisible(true);
  menu.addAction(pin_);
  unpin_ = addSubmenu(menu, "unpinMenu", [] { return tr("Unpin"); });
  connect(unpin_, &QMenu::aboutToShow, this, &CurveCommands::fillUnpin);
  menu.addAction(unpinAll_);
  family_ = addSubmenu(menu, "familyMenu", [] { return tr("Family of curves"); });
  keepTranslated(*family_, [this] {
    family_->setToolTip(tr("Pins some curves, at as many values of another parameter"));
  });
  connect(family_, &QMenu::aboutToShow, this, [this] {
    fillKeys(
        *family_, [this](const Parameter& row) { pinFamily(row); },
        !session_.scene().sweep.isOfVelocity());
    addFamilySizes();
  });
  menu.addSeparator();
  keys_ = addSubmenu(menu, "axisMenu", [] { return tr("Horizontal axis"); });
  connect(keys_, &QMenu::aboutToShow, this, [this] {
    fillKeys(
        *keys_, [this](const Parameter& row) { chooseAxis(&row); }, true);
  });
  quantities_ = addSubmenu(menu, "quantityMenu", [] { return tr("Vertical axis"); });
  connect(quantities_, &QMenu::aboutToShow, this, &CurveCommands::fillQuantities);
  menu.addActions({linearX_, linearY_, dimensionless_, nearer_, farther_, fit_});
  menu.addSeparator();
  menu.addActions({save_, copy_});
  view_.setContextMenuPolicy(Qt::ActionsContextMenu);
  const auto addGroup = [this](const QList<QAction*>& group) {
    if (!view_.actions().isEmpty()) {
      auto* separator = new QAction(&view_);
      separator->setSeparator(true);
      view_.addAction(separator);
    }
    view_.addActions(group);
  };
  addGroup({pin_, unpinAll_, family_->menuAction()});
  addGroup(
      {keys_->menuAction(), quantities_->menuAction(), linearX_, linearY_, dimensionless_, fit_});
  addGroup({save_, copy_});
  addGroup({guide_});
  showState();
}

/// Adds one entry for each pinned curve, with its name in the legend.
void CurveCommands::fillUnpin() {
  unpin_->clear();
  for (const PinnedCurve& pinned : session_.friction().pinned()) {
    QAction* action =
        unpin_->addAction(session_.friction().pinnedName(pinned), this, [this, pinned] {
          session_.editCurve([&](FrictionChartModel& plot) { plot.unpin(pinned.id); });
        });
    action->setObjectName(QStringLiteral("unpin:%1").arg(pinned.id));
  }
  explainEmpty(*unpin_, tr("No curve is pinned"));
}

void CurveCommands::showState() {
  const bool hasPins = !session_.friction().pinned().empty();
  const bool hasCurve = session_.friction().hasCurve();  // on the present axis
  // A curve that a lesson hides must not appear as a pinned one or in a file.
  const bool isConcealed = session_.friction().isConcealed();
  pin_->setEnabled(hasCurve && !isConcealed);
  family_->setEnabled(!isConcealed);
  unpinAll_->setEnabled(hasPins);
  const Sweep& sweep = session_.scene().sweep;
  dimensionless_->setEnabled(sweep.isOfVelocity());
  if (!sweep.isOfVelocity() && dimensionless_->isChecked()) dimensionless_->setChecked(false);
  linearX_->setChecked(sweep.scale == SweepScale::Linear);
  linearX_->setEnabled(sweep.isOfVelocity() || (sweep.from > 0 && sweep.to > 0));
  linearY_->setChecked(session_.friction().isLinearY());
  // The ends of the axis hide the answer of a lesson.
  linearY_->setEnabled(!isConcealed);
  save_->setEnabled(hasCurve && !isConcealed);
  copy_->setEnabled(hasCurve);
}

void CurveCommands::setAxes(bool dimensionless) {
  session_.editCurve([dimensionless](FrictionChartModel& plot) {
    plot.setAxes(dimensionless ? CurveAxes::Dimensionless : CurveAxes::Physical);
  });
}

/// Adds one entry for each number that changes friction, velocity first, in groups as in the panel.
void CurveCommands::fillKeys(QMenu& menu, std::function<void(const Parameter&)> choose,
                             bool withVelocity) {
  menu.clear();
  const Scene& scene = session_.scene();
  const auto addKey = [&](const Parameter& row) {
    QAction* action =
        checkedEntry(menu, "key:" + fromUtf8(row.key),
                     capitalized(plainTitle(translatedText(parameterTitle(row.key)))),
                     row.key == scene.sweep.key, [choose, &row](bool) { choose(row); });
    action->setCheckable(&menu == keys_);
  };
  std::string_view section;
  for (const Parameter* row : axisKeys()) {
    if (row->key == kVelocityKey ? !withVelocity : &menu != keys_ && row->key == scene.sweep.key)
      continue;
    const std::string_view group = row->key.substr(0, row->key.find('.'));
    if (group != section) menu.addSeparator();
    section = group;
    addKey(*row);
  }
}

/// Offers two to nine curves in a family.
void CurveCommands::addFamilySizes() {
  constexpr int kMin = 2, kMax = 9;
  family_->addSeparator();
  QMenu* sizes = family_->addMenu(tr("Curves in a family: %1").arg(familySize_));
  sizes->setObjectName("familySizes");
  for (int size = kMin; size <= kMax; ++size)
    checkedEntry(*sizes, QStringLiteral("familySize:%1").arg(size), QString::number(size),
                 size == familySize_, [this, size](bool) { familySize_ = size; });
}

std::vector<const Parameter*> CurveCommands::axisKeys() const {
  std::vector<const Parameter*> keys{findParameter(kVelocityKey)};
  for (const std::string_view section :
       {"load.", "elastomer.", "surface.", "interface.", "accuracy."})
    for (const Parameter& row : parameters())
      if (row.key.starts_with(section) && whyNotSwept(row, session_.scene()).empty())
        keys.push_back(&row);
  return keys;
}

void CurveCommands::fillQuantities() {
  quantities_->clear();
  for (const QuantityEntry& entry : quantityEntries())
    checkedEntry(*quantities_, "quantity:" + QString::fromStdString(entry.word.text()),
                 capitalized(translatedText(entry.title)),
                 session_.friction().quantity() == entry.quantity,
                 [this, quantity = entry.quantity](bool) { chooseQuantity(quantity); });
}

void CurveCommands::chooseQuantity(CurveQuantity quantity) {
  dimensionless_->setChecked(false);
  session_.editCurve([&](FrictionChartModel& plot) { plot.setQuantity(quantity); });
}

bool CurveCommands::hasDimensionlessAxes() const {
  return dimensionless_->isChecked();
}

void CurveCommands::chooseAxis(const Parameter* parameter) {
  const Scene& scene = session_.scene();
  const std::string_view key = parameter ? parameter->key : kVelocityKey;
  Scene next = scene;
  if (key == kVelocityKey)
    next.sweep = {};
  else
    next = sceneOver(usualRange(*parameter, scene), scene);
  if (key == scene.sweep.key) return dimensionless_->setChecked(!parameter);
  next.sweep.points = scene.sweep.points;
  emit axisChosen(next);
  if (!parameter) dimensionless_->setChecked(true);
}

void CurveCommands::spaceEvenly(bool isLinear) {
  Scene next = session_.scene();
  next.sweep.scale = isLinear ? SweepScale::Linear : SweepScale::Logarithmic;
  emit axisChosen(next);
}

/// Pins curves that differ in a second parameter.
void CurveCommands::pinFamily(const Parameter& parameter) {
  const Scene scene = session_.scene();
  ParameterRange range = usualRange(parameter, scene);
  range.points = familySize_;
  const auto family = [scene, range] {
    std::vector<Scene> members;
    for (const double value : rangeValues(range)) {
      Scene member = scene;
      member.sweep.key = std::string(range.key());
      member = withSweptValue(member, value);
      member.sweep.key = scene.sweep.key;
      members.push_back(member);
    }
    return members;
  };
  pinCurves(session_, work_, family, messages_.failureReporter(MessageBar::Failure::Comparison));
}

// ---- Files and pictures

namespace {

/// Returns the provenance of the present scene, as `asperity curve` writes it, with the other
/// curves.
nlohmann::ordered_json curveOrigin(const CurveSet& set) {
  nlohmann::ordered_json origin = provenance("curve", set.present.scene);
  if (set.axes == CurveAxes::Dimensionless) origin["axes"] = "dimensionless";
  for (const NamedCurve& curve : set.pinned)
    origin["pinned"].push_back(provenance("curve", curve.scene)["scene"]);
  if (set.difference) origin["compared_with"] = settingName(set.difference->setting).english();
  return origin;
}

/// Writes PNG, SVG, PDF or CSV, by the extension: the picture that `asperity curve` would draw with
/// everything that is shown, or all plotted numbers as one table. Any thread on which no OpenGL
/// context of the window is current, one at a time. Throws as writePicture and writeFileAtomically
/// do.
void writeCurves(const std::filesystem::path& file, const CurveSet& set) {
  nlohmann::ordered_json origin = curveOrigin(set);
  const std::string extension = file.extension().string();
  if (extension == ".csv")
    return writeFileAtomically(file, provenanceComment(origin) + curveSetCsv(set));
  if (extension != ".png" && extension != ".svg" && extension != ".pdf")
    throw unknownExtension(file.string(), extension, {".png", ".svg", ".pdf", ".csv"});
  nameLanguage(origin);
  constexpr int kDifferenceHeight = 500;  // pixels, as the other sizes
  DiagramOptions options;
  options.width = 2400;
  options.height = 1600 + (set.difference ? kDifferenceHeight : 0);
  options.scale = 2;
  options.theme = printTheme();
  const DiagramSheet sheet = curveSheet(set);
  writePicture(file, composeDiagrams(sheet, options),
               {translated(sheet.title), provenanceLine(origin), options.scale});
}

/// Draws an image of this size in pixels; scale: device pixels per logical pixel. Any thread, as
/// for writeCurves.
QImage renderCurves(const CurveSet& set, const QSize& size, double scale, const Theme& theme) {
  DiagramOptions options;
  options.width = size.width();
  options.height = size.height();
  options.scale = static_cast<float>(scale);
  options.theme = theme;
  return renderImage(contextOfThread(), composeDiagrams(curveSheet(set), options));
}

}  // namespace

std::optional<CurveSet> CurveCommands::shown() const {
  return session_.friction().shown(view_.isZoomed() ? std::optional(view_.visibleRange())
                                                    : std::nullopt);
}

void CurveCommands::askSave() {
  const QString file = askSaveFile(nullptr, tr("Save curve"), "curve.png",
                                   pictureFilter() + ";;" + tr("Table (*.csv)"));
  if (!file.isEmpty()) save(file);
}

void CurveCommands::save(const QString& file) {
  const std::optional<CurveSet> set = shown();
  if (!set) return;
  exports_.save(file, [set = *set, file] { writeCurves(file.toStdString(), set); });
}

/// Copies the diagram in the size and colours of the screen.
void CurveCommands::copyPicture() {
  const std::optional<CurveSet> set = shown();
  if (!set) return;
  const double scale = view_.devicePixelRatioF();
  const QSize size = view_.size().expandedTo({900, 600}) * scale;
  const Theme& theme = pictureTheme(view_.palette());
  exports_.copy([set = *set, size, scale, &theme] { return renderCurves(set, size, scale, theme); },
                [] { return tr("The curve's picture is on the clipboard"); });
}

}  // namespace asperity
