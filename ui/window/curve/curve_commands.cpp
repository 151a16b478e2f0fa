#include "ui/window/curve/curve_commands.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <memory>
#include <utility>

#include "ui/chart/chart_view.h"
#include "ui/language/language.h"
#include "ui/window/curve/curve_files.h"
#include "ui/window/main/picture_files.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

constexpr double kZoom = 1.5;

}  // namespace

CurveCommands::CurveCommands(Session& session, ChartView& view, Export run, QObject* parent)
    : QObject(parent), session_(session), view_(view), run_(std::move(run)) {
  pin_ =
      add("pinCurve", [this] { session_.editCurve([](FrictionChartModel& plot) { plot.pin(); }); });
  pin_->setShortcut(Qt::Key_P);
  unpinAll_ = add("unpinAll", [this] {
    session_.editCurve([](FrictionChartModel& plot) { plot.unpinAll(); });
  });
  unpinAll_->setShortcut(Qt::SHIFT | Qt::Key_P);
  dimensionless_ = add("dimensionlessAxes", [] {});
  dimensionless_->setCheckable(true);
  dimensionless_->setShortcut(Qt::Key_D);
  connect(dimensionless_, &QAction::toggled, this, &CurveCommands::setAxes);
  nearer_ = add("curveNearer", [this] { view_.zoom(1 / kZoom); });
  farther_ = add("curveFarther", [this] { view_.zoom(kZoom); });
  fit_ = add("curveFit", [this] { view_.fit(); });
  save_ = add("saveCurve", [this] { askSave(); });
  save_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_E);
  copy_ = add("copyCurvePicture", [this] { copyPicture(); });
  connect(&session_, &Session::plotChanged, this, &CurveCommands::showState);
  connect(&view_, &ChartView::zoomChanged, this, &CurveCommands::showState);
}

QAction* CurveCommands::add(const char* name, std::function<void()> run) {
  auto* action = new QAction(this);
  action->setObjectName(name);
  connect(action, &QAction::triggered, this, std::move(run));
  return action;
}

void CurveCommands::showTexts() {
  pin_->setText(tr("Pin curve"));
  pin_->setToolTip(tr("Keeps this curve to compare others with"));
  unpin_->setTitle(tr("Unpin"));
  unpinAll_->setText(tr("Unpin all"));
  dimensionless_->setText(tr("Dimensionless axes"));
  dimensionless_->setToolTip(tr("v̄ of Eq. (13) and μ over the rms slope of the line"));
  nearer_->setText(tr("Zoom in"));
  farther_->setText(tr("Zoom out"));
  fit_->setText(tr("Fit axes"));
  save_->setText(tr("Save curve…"));
  save_->setToolTip(tr("Everything that is shown, as a picture or as a table"));
  copy_->setText(tr("Copy curve picture"));
}

void CurveCommands::fill(QMenu& menu) {
  menu.setToolTipsVisible(true);
  menu.addAction(pin_);
  unpin_ = menu.addMenu(QString());
  unpin_->setObjectName("unpinMenu");
  connect(unpin_, &QMenu::aboutToShow, this, &CurveCommands::fillUnpin);
  menu.addAction(unpinAll_);
  menu.addSeparator();
  menu.addActions({dimensionless_, nearer_, farther_, fit_});
  menu.addSeparator();
  menu.addActions({save_, copy_});
  view_.setContextMenuPolicy(Qt::ActionsContextMenu);
  view_.addActions({pin_, unpinAll_, dimensionless_, fit_, save_, copy_});
  keepTranslated(menu, [this] { showTexts(); });
  showState();
}

/// Adds one entry for each pinned curve, with its name in the legend.
void CurveCommands::fillUnpin() {
  unpin_->clear();
  for (const PinnedCurve& pinned : session_.friction().pinned()) {
    QAction* action = unpin_->addAction(session_.friction().nameOf(pinned), this, [this, pinned] {
      session_.editCurve([&](FrictionChartModel& plot) { plot.unpin(pinned.id); });
    });
    action->setObjectName(QStringLiteral("unpin:%1").arg(pinned.id));
  }
}

void CurveCommands::showState() {
  const bool hasPins = !session_.friction().pinned().empty();
  const bool hasCurve = session_.friction().hasCurve();
  pin_->setEnabled(hasCurve);
  unpinAll_->setEnabled(hasPins);
  unpin_->setEnabled(hasPins);
  fit_->setEnabled(view_.isZoomed());
  save_->setEnabled(hasCurve);
  copy_->setEnabled(hasCurve);
}

/// Changes the axes. Zoomed ranges belong to the former axes.
void CurveCommands::setAxes(bool dimensionless) {
  view_.fit();
  session_.editCurve([dimensionless](FrictionChartModel& plot) {
    plot.setAxes(dimensionless ? CurveAxes::Dimensionless : CurveAxes::Physical);
  });
}

std::optional<CurveSet> CurveCommands::shown() const {
  return session_.friction().shown(view_.isZoomed() ? std::optional(view_.visibleRange())
                                                    : std::nullopt);
}

void CurveCommands::askSave() {
  const QString file = askSaveFile(nullptr, tr("Save curve"), "curve.png",
                                   tr("Pictures (*.png *.svg *.pdf);;Table (*.csv)"));
  if (!file.isEmpty()) save(file);
}

void CurveCommands::save(const QString& file) {
  const std::optional<CurveSet> set = shown();
  if (!set) return;
  run_([set = *set, file] { writeCurves(file.toStdString(), set); },
       [this, file] { emit exported(file); });
}

/// Copies the diagram in the size and colours of the screen.
void CurveCommands::copyPicture() {
  const std::optional<CurveSet> set = shown();
  if (!set) return;
  const auto image = std::make_shared<QImage>();
  const double scale = view_.devicePixelRatioF();
  const QSize size = view_.size().expandedTo({900, 600}) * scale;
  const bool isDark = view_.palette().color(QPalette::Window).lightness() < 128;
  run_(
      [set = *set, image, size, scale, isDark] {
        *image =
            imageOf(set, size.width(), size.height(), scale, isDark ? darkTheme() : lightTheme());
      },
      [this, image] {
        QGuiApplication::clipboard()->setImage(*image);
        emit exported({});
      });
}

}  // namespace asperity
