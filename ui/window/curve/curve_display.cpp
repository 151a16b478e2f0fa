#include "ui/window/curve/curve_display.h"

#include <QAbstractItemView>
#include <QFocusEvent>
#include <QSignalBlocker>
#include <QToolTip>
#include <functional>
#include <memory>

#include "core/base/number_text.h"
#include "core/chart/curve_set.h"
#include "core/chart/curve_words.h"
#include "core/scene/parameters.h"
#include "core/scene/sweep.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/friction_chart_model.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

constexpr int kDiagramPause = 80;  // ms; painting a diagram takes as long as several pictures
constexpr int kDigits = 3, kFineDigits = 5;  // digits of a value that the user sets
constexpr int kFade = 30;  // ms to wait for a new curve before the old one is drawn faded

CurveAxesChoice chosenAxes(const Session& session) {
  const FrictionChartModel& friction = session.friction();
  const Sweep& sweep = session.scene().sweep;
  return {sweep.key, sweep.scale, friction.axes(), friction.quantity(), friction.isLinearY()};
}

}  // namespace

CurveDisplay::CurveDisplay(Session& session, ChartView& view, QObject* parent)
    : QObject(parent), session_(session), view_(view) {
  pause_.setSingleShot(true);
  connect(&pause_, &QTimer::timeout, this, [this] {
    if (isDue_) show();
  });
  connect(&session_, &Session::plotChanged, this, &CurveDisplay::showSoon);
  connect(&session_, &Session::markChanged, this, &CurveDisplay::showMarker);
  // The marker belongs to the frame that is shown now, and does not wait for a pause.
  connect(&session_, &Session::axesChanged, this, &CurveDisplay::show);
  // The line returns to the marker where the value was refused, as in a step of a lesson.
  connect(&session_, &Session::commandSent, this, [this] {
    if (!requested_ || ownSweptValue(session_.scene()) == *requested_) return;
    requested_.reset();
    view_.releaseMarker();
  });
  view_.setDescribe([this](int id, int row) { return session_.friction().describe(id, row); });
  connect(&view_, &ChartView::markerMoved, this, [this](double x, bool finely) {
    const auto value = session_.friction().sweptAt(x);
    if (value) setSwept(roundedToDigits(*value, finely ? kFineDigits : kDigits));
  });
  connect(&view_, &ChartView::pointChosen, this, [this](int id, int row) {
    if (const auto value = session_.friction().sweptValue(id, row)) setSwept(*value);
  });
  connect(&view_, &ChartView::unpinRequested, this, [this](int id) {
    session_.editCurve([id](FrictionChartModel& plot) { plot.unpin(id); });
  });
  show();
}

void CurveDisplay::showSoon() {
  const bool isStale = session_.friction().isStale();
  const bool wasStale = std::exchange(wasStale_, isStale);
  if ((wasStale && !isStale) || chosenAxes(session_) != axes_) return show();
  isDue_ = true;
  if (isStale && !wasStale) return pause_.start(kFade);
  if (!pause_.isActive()) show();
}

void CurveDisplay::show() {
  isDue_ = false;
  if (const CurveAxesChoice axes = chosenAxes(session_); axes != axes_) {
    axes_ = axes;
    view_.fit();
  }
  view_.setSheet(session_.friction().sheet());
  pause_.start(kDiagramPause);
}

void CurveDisplay::showMarker() {
  view_.setMarker(session_.friction().marker());
}

/// Sets the key of the axis to exactly this value, within the limits of the table of parameters.
void CurveDisplay::setSwept(double value) {
  const Scene scene = withSweptValue(session_.scene(), value);
  if (scene == session_.scene()) return;
  requested_ = ownSweptValue(scene);
  emit sceneEdited(scene);
}

// ---- What is computed beside the curve

CurveComparison::CurveComparison(Session& session, MessageBar& messages, QObject* parent)
    : QObject(parent), session_(session), messages_(messages) {
  connect(&session_, &Session::plotChanged, this, &CurveComparison::update);
}

void CurveComparison::setSetting(const std::optional<CurveSetting>& setting) {
  if (setting == setting_) return;
  setting_ = setting;
  compared_.reset();
  work_.cancel();
  if (setting_) return update();
  session_.editCurve([](FrictionChartModel& plot) { plot.showDifference(std::nullopt); });
}

void CurveComparison::update() {
  const CurveUpdate* curve = session_.curve();
  if (!setting_ || !curve || !curve->isComplete) return;
  if (choosesAccuracy(*curve->scene) || !curve->scene->sweep.isOfVelocity()) return;
  if (compared_ && haveSameCurve(*compared_, *curve->scene)) return;
  compared_ = *curve->scene;
  // Curves of any motion are computed for steady sliding.
  compared_->sliding.kind = SlidingKind::Steady;
  work_.request(
      [this, scene = *compared_, setting = *setting_](const BackgroundWork::Run& run) {
        DifferenceOptions options;
        options.stop = run.stop();
        options.progress = [&](const CurveDifference& part) {
          run.post([this, part = std::make_shared<const CurveDifference>(part)] {
            messages_.end(MessageBar::Failure::Comparison);
            session_.editCurve([&](FrictionChartModel& plot) { plot.showDifference(*part); });
          });
        };
        curveDifference(scene, setting, options);
      },
      [] {}, messages_.failureReporter(MessageBar::Failure::Comparison));
}

SceneComparisons::SceneComparisons(Session& session, MessageBar& messages, QObject* parent)
    : QObject(parent), session_(session), messages_(messages) {
  connect(&session_, &Session::plotChanged, this, &SceneComparisons::update);
}

void SceneComparisons::update() {
  const CurveUpdate* curve = session_.curve();
  if (!curve || !curve->isComplete) return;
  const Scene& scene = *curve->scene;
  const CurveQuantity quantity = session_.friction().quantity();
  if (compared_ && haveSameCurve(*compared_, scene) && quantity == quantity_) return;
  compared_ = scene;
  quantity_ = quantity;
  CurveSet named;
  named.present.scene = scene;
  named.y = quantity;
  if (!hasComparisons(named)) return work_.cancel();
  work_.request(
      [scene, quantity](const BackgroundWork::Run& run) {
        auto set = std::make_shared<CurveSet>();
        set->present.scene = scene;
        set->y = quantity;
        addComparisons(*set, readComparisonData(scene), {.stop = run.stop()});
        return std::shared_ptr<const CurveSet>(std::move(set));
      },
      [this, scene](const std::shared_ptr<const CurveSet>& set) {
        messages_.end(MessageBar::Failure::Files);
        session_.editCurve([&](FrictionChartModel& plot) { plot.showComparisons(scene, *set); });
      },
      messages_.failureReporter(MessageBar::Failure::Files));
}

// ---- The lists at the axes

namespace {

/// The entry of both lists that stands for the axes of Eq. (13); no key has this name.
const QString kDimensionless = QStringLiteral("dimensionless");

QString entryText(const Message& title, std::string_view unit) {
  const QString text = capitalized(plainTitle(translatedText(title)));
  return unit.empty() ? text : QStringLiteral("%1 (%2)").arg(text, fromUtf8(unit));
}

}  // namespace

/// A list whose entries are made when it opens, because finding the parameters of a scene takes a
/// while.
class AxisBox : public ChoiceBox {
 public:
  using Fill = std::function<void()>;

  explicit AxisBox(Fill fill) : fill_(std::move(fill)) {
    setMinimumContentsLength(4);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  }

  void showPopup() override {
    fill_();
    // The list is as wide as its entries, not as the box.
    view()->setMinimumWidth(view()->sizeHintForColumn(0) + 24);
    ChoiceBox::showPopup();
  }

 protected:
  /// Shows the tooltip to the right, not over the numbers of the axis.
  bool event(QEvent* event) override {
    if (event->type() != QEvent::ToolTip) return ChoiceBox::event(event);
    QToolTip::showText(mapToGlobal(QPoint(width(), 0)), toolTip(), this);
    return true;
  }

  void focusInEvent(QFocusEvent* event) override {
    if (event->reason() != Qt::PopupFocusReason) fill_();
    ChoiceBox::focusInEvent(event);
  }

 private:
  Fill fill_;
};

namespace {

/// Sets the entries if they have changed: the list may be open.
void setEntries(AxisBox& box, const QList<std::pair<QString, QVariant>>& entries) {
  bool isSame = box.count() == entries.size();
  for (int i = 0; isSame && i < box.count(); ++i)
    isSame = box.itemText(i) == entries[i].first && box.itemData(i) == entries[i].second;
  if (isSame) return;
  const QSignalBlocker blocker(box);
  box.clear();
  for (const auto& [text, data] : entries) box.addItem(text, data);
}

}  // namespace

AxisChoosers::AxisChoosers(Session& session, ChartView& view, CurveCommands& commands)
    : QObject(&commands),
      session_(session),
      commands_(commands),
      x_(named<AxisBox>("axisKey", [this] { fillKeys(); })),
      y_(named<AxisBox>("axisQuantity", [this] { fillQuantities(); })) {
  connect(x_, &QComboBox::activated, this, [this](int index) {
    const QString key = x_->itemData(index).toString();
    commands_.chooseAxis(key == kDimensionless ? nullptr : findParameter(key.toStdString()));
    update();
  });
  connect(y_, &QComboBox::activated, this, [this](int index) {
    if (y_->itemData(index).toString() == kDimensionless)
      commands_.chooseAxis(nullptr);
    else
      commands_.chooseQuantity(static_cast<CurveQuantity>(y_->itemData(index).toInt()));
    update();
  });
  view.setChoosers(x_, y_);
  connect(&view, &ChartView::titlesChanged, this, &AxisChoosers::showTitles);
  keepTranslated(*x_, [this] { showTexts(); });
}

void AxisChoosers::showTexts() {
  x_->setAccessibleName(tr("horizontal axis"));
  y_->setAccessibleName(tr("vertical axis"));
  for (AxisBox* box : {x_, y_}) box->nameList();
  fillKeys();
  fillQuantities();
}

/// Shows the titles as they fit the visible range, with the unit of the ticks.
void AxisChoosers::showTitles(const QString& x, const QString& y) {
  x_->setShownText(plainTitle(x));
  y_->setShownText(plainTitle(y));
  update();
}

void AxisChoosers::fillKeys() {
  QList<std::pair<QString, QVariant>> entries;
  for (const Parameter* row : commands_.axisKeys())
    entries.emplaceBack(entryText(parameterTitle(row->key), row->unit), fromUtf8(row->key));
  entries.insert(1, {tr("Dimensionless velocity v̄, Eq. (13)"), kDimensionless});
  setEntries(*x_, entries);
  update();
}

void AxisChoosers::fillQuantities() {
  QList<std::pair<QString, QVariant>> entries;
  for (const QuantityEntry& entry : quantityEntries())
    entries.emplaceBack(entryText(entry.title, entry.unit), static_cast<int>(entry.quantity));
  if (session_.scene().sweep.isOfVelocity())
    entries.emplaceBack(tr("Dimensionless: μ over the rms slope against v̄"), kDimensionless);
  setEntries(*y_, entries);
  update();
}

/// Sets the tooltips that explain the axes.
void AxisChoosers::explain() {
  const bool isPlain = !commands_.hasDimensionlessAxes();
  const Rheology rheology = session_.scene().elastomer.rheology;
  const auto tip = [rheology](std::string_view id, const QString& hint) {
    const auto explanation = findExplanation(id);
    return (explanation ? explanationHtml(withFormulaFor(*explanation, rheology)) : QString()) +
           "<p><small>" + hint.toHtmlEscaped() + "</small></p>";
  };
  x_->setToolTip(
      tip(isPlain ? std::string_view(session_.scene().sweep.key) : "dimensionless_velocity",
          tr("What the curve goes over: any number that changes friction in this scene. "
             "The marker then sets it.")));
  y_->setToolTip(tip(isPlain ? std::string_view(quantityEntry(session_.friction().quantity()).word)
                             : "normalized_mu",
                     tr("What the curve shows")));
  for (AxisBox* box : {x_, y_}) box->setSpoken(box->accessibleName(), spokenText(box->toolTip()));
}

/// Selects what is shown.
void AxisChoosers::update() {
  const QSignalBlocker blockX(x_), blockY(y_);
  const bool isPlain = !commands_.hasDimensionlessAxes();
  const QString key = QString::fromStdString(session_.scene().sweep.key);
  x_->setCurrentIndex(x_->findData(isPlain ? key : kDimensionless));
  const auto quantity = static_cast<int>(session_.friction().quantity());
  y_->setCurrentIndex(y_->findData(isPlain ? QVariant(quantity) : QVariant(kDimensionless)));
  explain();
}

}  // namespace asperity
