#include "ui/window/main/scene_tabs.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QFontMetrics>
#include <QMenu>
#include <QResizeEvent>
#include <QStyle>
#include <QTabBar>
#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>

#include "core/base/statistics.h"
#include "core/chart/material_sheets.h"
#include "core/run/line_diagrams.h"
#include "core/scene/provenance.h"
#include "ui/chart/chart_view.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/panels/panel_style.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/accuracy/plan_list.h"
#include "ui/window/contact/motion_view.h"
#include "ui/window/curve/influence_page.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/session.h"
#include "ui/window/map/map_panel.h"

namespace asperity {

namespace {

constexpr int kMotionTab = 1;
// Pixels at each side of a title, in the style of a bar that is "crowded" by 0, 1 or 2.
constexpr std::array kTabPadding{14, 7, 4};
constexpr int kFreeWidth = 24;  // minimum pixels of the bar beside its titles
// Minimum height of the chart in pixels: the smallest window has room for it below the messages,
// the contact and the bar of time.
constexpr int kMinPlot = 150;

/// Returns the root mean square over the points that have such a value; NaN where none has one.
double rootMeanSquare(const std::vector<CurvePoint>& points, double (*value)(const CurvePoint&)) {
  std::vector<double> values;
  for (const CurvePoint& point : points)
    if (const double one = value(point); std::isfinite(one)) values.push_back(one);
  return rms(values);
}

}  // namespace

/// Caches the frequencies that a line excites, which do not depend on the velocity. Any thread.
class ExcitationCache {
 public:
  std::shared_ptr<const Excitation> get(const Scene& scene) {
    const std::lock_guard lock(mutex_);
    const bool isSame = excitation_ && scene.surface == scene_.surface &&
                        scene.elastomer == scene_.elastomer && scene.folder == scene_.folder &&
                        scene.ensemble == scene_.ensemble;
    if (!isSame) {
      excitation_.reset();
      excitation_ = std::make_shared<const Excitation>(computeExcitation(scene));
    }
    scene_ = scene;
    return excitation_;
  }

 private:
  std::mutex mutex_;
  Scene scene_;
  std::shared_ptr<const Excitation> excitation_;
};

SceneTabs::SceneTabs(Session& session, QWidget* parent)
    : QTabWidget(parent),
      session_(session),
      plot_(named<ChartView>("frictionPlot")),
      motion_(named<MotionView>("transientStrips")),  // as in settings of earlier versions
      spectrum_(named<DiagramView>("spectrumView")),
      statistics_(named<DiagramView>("statisticsView")),
      material_(named<DiagramView>("materialView")),
      accuracy_(new AccuracyPanel),
      plan_(new PlanList),
      map_(new MapPanel),
      influences_(new InfluencePage),
      excitation_(std::make_shared<ExcitationCache>()) {
  setObjectName("tabs");
  setDocumentMode(true);
  tabBar()->setFocusPolicy(Qt::NoFocus);  // the space bar pauses the run
  tabBar()->setDrawBase(false);
  // Tabs move closer and have shorter titles before any of them is out of sight.
  tabBar()->setUsesScrollButtons(false);
  tabBar()->setElideMode(Qt::ElideRight);
  // The chart has keys of its own; clicking here also leaves an entry.
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumHeight(kMinPlot);
  // Newer tabs are last, so that the keys of the others stay.
  addPage(
      *plot_, [] { return tr("Friction curve"); }, [] { return tr("Curve"); });
  addPage(
      *motion_, [] { return tr("Motion in time"); }, [] { return tr("Motion"); });
  addPage(*spectrum_, [] { return tr("Spectrum"); });
  addPage(*statistics_, [] { return tr("Statistics"); });
  addPage(*material_, [] { return tr("Material"); });
  addPage(*accuracy_, [] { return tr("Accuracy"); });
  addPage(*plan_, [] { return tr("Plan"); });
  addPage(*map_, [] { return tr("Map"); });
  addPage(*influences_, [] { return tr("Influences"); });
  setTabVisible(kMotionTab, false);
  pageAt(kMotionTab).action->setVisible(false);
  keepTranslated(*this, [this] { showTexts(); });
  connect(statistics_, &DiagramView::visibilityChanged, this, &SceneTabs::fieldsChanged);
  connect(&session_, &Session::plotChanged, this, &SceneTabs::showMeasuredCurve);
}

void SceneTabs::addPage(QWidget& widget, Title title, Title brief) {
  auto* action = named<QAction>("tab:" + widget.objectName(), this);
  action->setText(title());
  action->setCheckable(true);
  action->setChecked(true);
  const auto index = static_cast<int>(pages_.size());
  connect(action, &QAction::toggled, this, [this, index](bool on) { setTabRequested(index, on); });
  pages_.push_back({title, brief ? brief : title, action});
  addTab(&widget, title());
  if (menu_) menu_->addAction(action);
  if (commands_) addKey(index);
  QList<DiagramView*> views = widget.findChildren<DiagramView*>();
  if (auto* view = qobject_cast<DiagramView*>(&widget)) views += view;
  for (DiagramView* view : std::as_const(views))
    connect(view, &DiagramView::failed, this, &SceneTabs::failed);
  for (DiagramFiles* files : widget.findChildren<DiagramFiles*>()) {
    connect(files, &DiagramFiles::saved, this, &SceneTabs::saved);
    connect(files, &DiagramFiles::copied, this, &SceneTabs::copied);
    connect(files, &DiagramFiles::failed, this, &SceneTabs::failed);
  }
  if (isVisible()) fitTitles();
}

void SceneTabs::showTexts() {
  setAccessibleName(tr("about the scene"));
  // Qt's own buttons keep the texts of their first language.
  for (const char* side : {"Left", "Right"})
    if (auto* button =
            tabBar()->findChild<QAbstractButton*>(QStringLiteral("Scroll%1Button").arg(side)))
      button->setAccessibleName(
          QCoreApplication::translate("QTabBar", QByteArray("Scroll ") + side));
  plot_->setAccessibleName(tr("coefficient of friction against velocity"));
  spectrum_->setAccessibleName(tr("spectrum of the rigid line"));
  statistics_->setAccessibleName(tr("line loads and slopes in contact"));
  material_->setAccessibleName(tr("moduli of the elastomer and the frequencies in use"));
  for (const Page& page : pages_) page.action->setText(page.title());
  fitTitles();
}

/// Returns the width of the visible tabs with their whole or their brief titles, measured as
/// QTabBar measures them: it rounds the width of each title up, and shortens one if a single pixel
/// is missing.
int SceneTabs::tabsWidth(Title Page::*title, int padding) const {
  const QFontMetrics metrics = tabBar()->fontMetrics();
  int width = 0;
  for (int i = 0; i < count(); ++i)
    if (isTabVisible(i))
      width += metrics.size(Qt::TextShowMnemonic, (pageAt(i).*title)()).width() + 2 * padding;
  return width;
}

/// Returns the width of the button in the corner.
int SceneTabs::cornerWidth() const {
  return cornerWidget() ? cornerWidget()->sizeHint().width() : 0;
}

/// Returns the size in which all tabs fit; the dock of parameters becomes narrower first. No page
/// makes it wider, because the views would move when the page is shown for the first time.
QSize SceneTabs::minimumSizeHint() const {
  QSize size = QTabWidget::minimumSizeHint();
  if (!mayScroll_) size.setWidth(narrowestTabs_ + kFreeWidth);
  return size;
}

/// Gives the tabs margins and titles that fit into the bar: wide or narrow, long or short. A bar
/// that is still too narrow has buttons that scroll it: titles are never cut.
void SceneTabs::fitTitles() {
  struct Form {
    Title Page::*title;
    std::size_t crowded;
  };
  constexpr std::array<Form, 4> kForms{
      {{&Page::title, 0}, {&Page::title, 1}, {&Page::brief, 1}, {&Page::brief, 2}}};
  const int available = width() - cornerWidth();
  const auto fits = [&](const Form& form) {
    return tabsWidth(form.title, kTabPadding[form.crowded]) <= available;
  };
  const auto* fitting = std::ranges::find_if(kForms, fits);
  const bool needsButtons = fitting == kForms.end();
  const auto [shown, crowded] = needsButtons ? kForms.back() : *fitting;
  if (tabBar()->usesScrollButtons() != needsButtons) {
    tabBar()->setUsesScrollButtons(needsButtons);
    tabBar()->setElideMode(needsButtons ? Qt::ElideNone : Qt::ElideRight);
  }
  for (int i = 0; i < count(); ++i) {
    const QString title = pageAt(i).title(), text = (pageAt(i).*shown)();
    if (tabText(i) != text) setTabText(i, text);
    setTabToolTip(i, isTabEnabled(i) ? title : tr("%1: hidden until the answer").arg(title));
  }
  // A layout of the whole window for each value of a slider would be slow.
  const int narrowest = tabsWidth(&Page::brief, kTabPadding.back()) + cornerWidth();
  if (std::exchange(narrowestTabs_, narrowest) != narrowest) updateGeometry();
  const auto level = static_cast<int>(crowded);
  if (tabBar()->property("crowded").toInt() == level) return;
  setStyleProperty(*tabBar(), "crowded", level);
  // The bar updates the sizes of its tabs only after a StyleChange event.
  QEvent changed(QEvent::StyleChange);
  QCoreApplication::sendEvent(tabBar(), &changed);
}

void SceneTabs::setMayScroll(bool mayScroll) {
  mayScroll_ = mayScroll;
  updateGeometry();
  fitTitles();
}

/// Qt reserves the space of a corner widget even while it is hidden.
void SceneTabs::showInCorner(QWidget& widget, bool isShown) {
  QWidget* corner = isShown ? &widget : nullptr;
  const bool isOther = cornerWidget() != corner;
  if (isOther) setCornerWidget(corner);
  widget.setVisible(isShown);
  if (isOther) fitTitles();
}

bool SceneTabs::event(QEvent* event) {
  // The button in the corner may have got another text or font after the tabs had.
  if (event->type() == QEvent::LayoutRequest) fitTitles();
  return QTabWidget::event(event);
}

void SceneTabs::resizeEvent(QResizeEvent* event) {
  fitTitles();
  QTabWidget::resizeEvent(event);
}

void SceneTabs::changeEvent(QEvent* event) {
  QTabWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fitTitles();
}

void SceneTabs::addTo(Commands& commands) {
  commands_ = &commands;
  for (int i = 0; i < count(); ++i) addKey(i);
}

/// Adds the key of a tab: Alt and its number.
void SceneTabs::addKey(int index) {
  QList<QKeySequence> keys;
  if (index < 9) keys += Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + index);
  QAction* action =
      commands_->add({"go:" + widget(index)->objectName().toStdString(),
                      [this, index] { return tr("Show %1").arg(pageAt(index).title()); },
                      [this, index] { bringToFront(index); }, keys});
  keepTranslated(*this, [action] { action->setProperty("group", tr("Tabs")); });
}

void SceneTabs::addMenu(QMenu& menu) {
  menu_ = addSubmenu(menu, "tabsMenu", [] { return tr("Tabs"); });
  for (const Page& page : pages_) menu_->addAction(page.action);
}

void SceneTabs::setTabRequested(int index, bool isRequested) {
  setTabVisible(index, isRequested && pageAt(index).action->isVisible());
  fitTitles();
  setVisible(std::ranges::any_of(pages_, [](const Page& page) {
    return page.action->isVisible() && page.action->isChecked();
  }));
}

void SceneTabs::bringToFront(int index) {
  QAction* action = pageAt(index).action;
  if (action->isVisible()) action->setChecked(true);
  if (isTabVisible(index) && isTabEnabled(index)) setCurrentIndex(index);
}

void SceneTabs::bringToFront(const QString& name) {
  for (int i = 0; i < count(); ++i)
    if (widget(i)->objectName() == name && isTabVisible(i) && isTabEnabled(i)) setCurrentIndex(i);
}

void SceneTabs::setCurveHidden(bool isHidden) {
  for (QWidget* page : Widgets{map_, influences_})
    setTabEnabled(indexOf(page), !isHidden || page == currentWidget());
  fitTitles();
}

QStringList SceneTabs::hiddenTabs() const {
  QStringList names;
  for (int i = 0; i < count(); ++i)
    if (!pageAt(i).action->isChecked()) names += widget(i)->objectName();
  return names;
}

void SceneTabs::hideTabs(const QStringList& names) {
  for (int i = 0; i < count(); ++i)
    pageAt(i).action->setChecked(!names.contains(widget(i)->objectName()));
}

void SceneTabs::showScene(const Scene& scene) {
  const bool hasMotion = scene.sliding.kind != SlidingKind::Steady;
  const bool hadMotion = isTabVisible(kMotionTab);
  // The tab of the motion is left before it is hidden; otherwise Qt shows the next one.
  if (!hasMotion && currentWidget() == motion_) setCurrentWidget(plot_);
  QAction& action = *pageAt(kMotionTab).action;
  action.setVisible(hasMotion);
  if (const bool isShown = hasMotion && action.isChecked(); isShown != hadMotion) {
    setTabVisible(kMotionTab, isShown);
    fitTitles();
  }
  if (hasMotion && !hadMotion) setCurrentIndex(kMotionTab);
  motion_->showScene(scene);
  plan_->showScene(scene);
  spectrum_->show([scene] { return spectrumSheet(scene); },
                  {"spectrum", [scene] { return pictureOrigin("surface", scene); }});
  material_->show(
      [scene, excitation = excitation_] { return excitationSheet(scene, *excitation->get(scene)); },
      {"material", [scene] { return pictureOrigin("material", scene); },
       [scene, excitation = excitation_] {
         return provenanceComment("material", scene) +
                excitationCsv(scene, *excitation->get(scene));
       }});
  accuracy_->showScene(scene);
  map_->showScene(scene);
  influences_->showScene(scene);
  if (!timed_ || !haveSameCurve(*timed_, scene)) {
    timed_ = scene;
    measured_.reset();
    beginCurve();
  } else if (measured_) {
    accuracy_->showMeasured(*measured_);
  }
}

void SceneTabs::showFrame(const Frame& frame) {
  if (frame.transient && frame.sceneNumber == session_.sceneNumber()) motion_->showFrame(frame);
  if (!statistics_->isVisible()) return;
  const std::shared_ptr<const Frame> shown = session_.frame();
  statistics_->show([shown] { return statisticsSheet(*shown); },
                    {"statistics", [shown] { return pictureOrigin("statistics", *shown->scene); }});
}

/// A diagram of the previous scene would be taken for that of the present one.
void SceneTabs::clearFrame() {
  statistics_->clear();
}

void SceneTabs::setTheme(const Theme& theme) {
  for (ChartView* chart : findChildren<ChartView*>()) chart->setTheme(theme);
}

void SceneTabs::beginCurve() {
  curveTime_.start();
}

/// Shows time and error once, when the present scene's curve is complete.
void SceneTabs::showMeasuredCurve() {
  const CurveUpdate* curve = session_.curve();
  if (!curveTime_.isValid() || !curve || !curve->isComplete) return;
  const auto& points = curve->points;
  measured_ = {
      1e-3 * static_cast<double>(curveTime_.elapsed()),
      rootMeanSquare(points, [](const CurvePoint& at) { return at.muStandardError / at.mu; }),
      rootMeanSquare(points,
                     [](const CurvePoint& at) { return (at.muHigh - at.muLow) / 2 / at.mu; })};
  accuracy_->showMeasured(*measured_);
  curveTime_.invalidate();
}

FrameFields SceneTabs::fields() const {
  FrameFields fields;
  fields.lineSlope = statistics_->isVisible();
  return fields;
}

bool SceneTabs::isShowingMotion() const {
  return currentWidget() == motion_;
}

}  // namespace asperity
