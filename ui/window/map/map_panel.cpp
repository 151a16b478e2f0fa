#include "ui/window/map/map_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/chart/map_sheet.h"
#include "core/friction/curve_point.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/map/map_view.h"

namespace asperity {

namespace {

constexpr int kPoints = 64;              // along each side
constexpr int kMapPause = 40;            // ms between two pictures
constexpr double kSectionHeight = 0.42;  // height of the cut over that of the map
constexpr int kDigits = 3;               // of a value that the cross sets
constexpr int kErrorShare = 3;           // of the row; each list has 1
constexpr int kWidestList = 360;         // pixels
constexpr int kBeforeLabel = 8;          // pixels between a list and the next label

/// Returns whether two scenes are the same except for these two parameters.
bool differOnlyIn(const Scene& a, const Scene& b, const Parameter& x, const Parameter& y) {
  Scene same = a;
  for (const Parameter* row : {&x, &y})
    if (isApplicable(*row, b)) setValue(*row, same, parameterValue(*row, b));
  // Texts and comparisons of a curve do not matter for a map.
  same.title = b.title;
  same.description = b.description;
  same.chapter = b.chapter;
  same.comparison = b.comparison;
  return same == b;
}

/// Returns "10 lines, 38 % done": of how many the mean is that is shown, and how far the whole is.
QString shortProgress(std::int64_t shown, int percent) {
  return MapPanel::tr("%1 lines, %2 % done").arg(shown).arg(percent);
}

bool holds(const MapAxis& axis, double value) {
  const auto [least, most] = std::ranges::minmax(axis.values);
  return value >= least && value <= most;
}

/// Returns a series that is not drawn along the lines of the cross, which labels of contours avoid.
DiagramSeries placeOfCross(const Diagram& map, const DiagramMarker& cross) {
  DiagramSeries lines;
  lines.stroke = SeriesStroke::None;
  lines.points = {{cross.x, map.y.from},
                  {cross.x, map.y.to},
                  {kNotApplicable, kNotApplicable},
                  {map.x.from, cross.y},
                  {map.x.to, cross.y}};
  return lines;
}

/// The cut above the map, which the view has for its cross.
DiagramSheet mapSheetWithSection(const ParameterMap& map, const std::string& quantity) {
  DiagramSheet sheet = mapSheet(map, quantity);
  sheet.title = {};
  sheet.subtitle = {};
  sheet.note = {};
  Diagram& drawn = sheet.diagrams.front();
  // The few coarse cells of a stage have no border that a reader could trust.
  if (!map.isFinal)
    std::erase_if(drawn.series,
                  [](const DiagramSeries& series) { return series.id == kRegionBorder; });
  if (drawn.marker) drawn.series.push_back(placeOfCross(drawn, *drawn.marker));
  drawn.marker.reset();  // the view draws the cross
  Diagram cut = mapCut(map, quantity, true);
  cut.height = kSectionHeight;
  sheet.diagrams.insert(sheet.diagrams.begin(), std::move(cut));
  sheet.columns = 1;
  sheet.sharesAxis = true;
  return sheet;
}

}  // namespace

MapPanel::MapPanel(QWidget* parent)
    : QWidget(parent),
      row_(new QHBoxLayout),
      x_(named<ChoiceBox>("mapX")),
      y_(named<ChoiceBox>("mapY")),
      quantity_(named<ChoiceBox>("mapQuantity")),
      quantityLabel_(new QLabel),
      message_(named<QLabel>("mapMessage")),
      progressLabel_(named<QLabel>("mapProgress")),
      save_(named<QPushButton>("mapSave")),
      end_(new QStackedWidget),
      view_(named<MapView>("mapView")) {
  setObjectName("mapPanel");
  save_->setEnabled(false);  // until there is a map
  view_->setPause(kMapPause);
  for (ChoiceBox* box : {x_, y_, quantity_}) box->setMaximumWidth(kWidestList);
  row_->setContentsMargins(8, 4, 8, 0);
  for (const auto& [label, box] :
       {std::pair{new QLabel("x:"), x_}, {new QLabel("y:"), y_}, {quantityLabel_, quantity_}}) {
    if (row_->count() > 0) row_->addSpacing(kBeforeLabel);
    label->setBuddy(box);
    // Each list is as wide as its present name; only where that is too much are names shortened.
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(6);
    row_->addWidget(label);
    row_->addWidget(box);
  }
  row_->addStretch();  // what the lists leave over is not for the labels
  message_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  message_->hide();  // the lists use its space while there is none
  row_->addWidget(message_, kErrorShare);
  progressLabel_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  end_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  end_->addWidget(save_);
  end_->addWidget(progressLabel_);
  row_->addWidget(end_);
  auto* column = marginless<QVBoxLayout>(this, 2);
  column->addLayout(row_);
  column->addWidget(view_, 1);
  for (const std::string_view name : mapQuantities()) quantity_->addItem(QString(), fromUtf8(name));
  quantity_->setCurrentIndex(quantity_->findData("mu"));
  keepTranslated(*this, [this] { showTexts(); });
  connect(x_, &QComboBox::currentIndexChanged, this, [this] { compute(); });
  connect(y_, &QComboBox::currentIndexChanged, this, [this] { compute(); });
  connect(quantity_, &QComboBox::currentIndexChanged, this, [this] { showMap(); });
  connect(save_, &QPushButton::clicked, &view_->files(), &DiagramFiles::saveAs);
  connect(view_, &MapView::crossMoved, this, &MapPanel::moveTo);
  connect(view_, &MapView::pointedAt, this,
          [this](double x, double y) { view_->setReading(readingAt(x, y)); });
  connect(view_, &MapView::left, view_, [this] { view_->setReading({}); });
}

void MapPanel::showTexts() {
  x_->setAccessibleName(tr("parameter along x"));
  y_->setAccessibleName(tr("parameter along y"));
  quantityLabel_->setText(tr("Show:"));
  save_->setText(tr("Save…"));
  // The place of the progress is wide enough for any, so that nothing beside it moves.
  progressLabel_->setMinimumWidth(widestText(*progressLabel_, {shortProgress(2000, 100)}));
  view_->setAccessibleName(tr("friction over two parameters"));
  for (int i = 0; i < quantity_->count(); ++i)
    quantity_->setItemText(
        i, translatedText(mapQuantityTitle(quantity_->itemData(i).toString().toStdString())));
  for (ChoiceBox* box : {x_, y_})
    for (int i = 0; i < box->count(); ++i)
      if (const Parameter* row = findParameter(box->itemData(i).toString().toStdString()))
        box->setItemText(i, translatedText(row->label));
  if (map_) showCross();
  updateMessage();
  showTips();
  showProgress();
}

QString MapPanel::quantity() const {
  return quantity_->currentData().toString();
}

/// Offers the numbers that have a meaning in the scene; a choice stays where it can.
void MapPanel::fillChoosers() {
  const std::pair<ChoiceBox*, const char*> choosers[] = {{x_, "sliding.velocity"},
                                                         {y_, "load.normal_force"}};
  bool isKept = true;  // the choice of the last one, the vertical axis
  for (const auto& [box, usual] : choosers) {
    const QSignalBlocker quiet(box);
    const QString chosen = box->count() > 0 ? box->currentData().toString() : QString(usual);
    box->clear();
    for (const Parameter& row : parameters())
      if (isMapParameter(row, scene_)) box->addItem(translatedText(row.label), fromUtf8(row.key));
    isKept = box->findData(chosen) >= 0;
    box->setCurrentIndex(std::max(0, box->findData(chosen)));
  }
  if ((!isKept || x_->currentIndex() == y_->currentIndex()) && y_->count() > 1) {
    const QSignalBlocker quiet(y_);
    const int load = std::max(y_->findData("load.nominal_pressure"), y_->findData("load.depth"));
    y_->setCurrentIndex(load >= 0 && load != x_->currentIndex() ? load : (x_->currentIndex() == 0));
  }
  showTips();
}

void MapPanel::showScene(const Scene& scene) {
  scene_ = scene;
  target_ = std::exchange(scene_.accuracy.targetRelativeError, 0);
  hasScene_ = true;
  if (isVisible()) compute();
}

void MapPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (hasScene_) compute();
}

/// A hidden map costs nothing.
void MapPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!work_.isBusy()) return;
  work_.cancel();
  requested_.reset();
}

/// Returns whether a map belongs to the present scene, except for the position of the cross.
bool MapPanel::isCoveredBy(const ParameterMap& map) const {
  const Parameter &x = *map.x.range.row, &y = *map.y.range.row;
  return x_->currentData().toString().toStdString() == x.key &&
         y_->currentData().toString().toStdString() == y.key &&
         differOnlyIn(scene_, map.scene, x, y) && holds(map.x, parameterNumber(x, scene_)) &&
         holds(map.y, parameterNumber(y, scene_));
}

/// Shows the present map again where only its cross has moved, or requests another one.
void MapPanel::compute() {
  if (!hasScene_ || !isVisible()) return;
  fillChoosers();
  const auto key = [](const ChoiceBox* box) { return box->currentData().toString().toStdString(); };
  if (x_->count() < 2) return;
  if (requested_ && isCoveredBy(*requested_)) {
    requested_->scene = scene_;
    showTarget();
    if (map_ && isCoveredBy(*map_)) {
      ParameterMap moved = *map_;
      moved.scene = scene_;
      map_ = std::make_shared<const ParameterMap>(std::move(moved));
      showMap();
    }
    return;
  }
  MapAxis x, y;
  try {
    x = mapAxis(scene_, usualMapRange(scene_, knownParameter(key(x_)), kPoints));
    y = mapAxis(scene_, usualMapRange(scene_, knownParameter(key(y_)), kPoints));
    if (x.range.row == y.range.row)
      throw InputError("", std::string(x.key()),
                       "is both sides of the map; they need two "
                       "different keys");
  } catch (const InputError& error) {
    work_.cancel();
    requested_.reset();
    showProgress();
    showMessage([error] { return errorWithLabel(error); });
    return;
  }
  request(x, y);
}

void MapPanel::request(const MapAxis& x, const MapAxis& y) {
  lines_ = 0;
  percent_ = 0;
  requested_ = ParameterMap{scene_, x, y, {}, 0, 0, false, false};
  showTarget();
  work_.request(
      [this, scene = scene_, x, y](const BackgroundWork::Run& run) {
        StateOptions options{.stop = run.stop()};
        const auto preview = [this, &run](ParameterMap stage) {
          run.post([this, stage = std::make_shared<ParameterMap>(std::move(stage))] {
            take(std::move(*stage));
          });
        };
        options.progress = run.percents([this](int percent) {
          percent_ = percent;
          showProgress();
        });
        constexpr std::int64_t kCoarsest = 1;  // nodes in an element: the lines are only counted
        run.post([this, lines = LineSource(scene, kCoarsest).lines()] {
          lines_ = lines;
          showProgress();
        });
        ParameterMap map = parameterMap(scene, x, y, options, preview);
        if (!map.isComplete) throw StopRequested{};
        return map;
      },
      [this](ParameterMap map) { take(std::move(map)); },
      [this](const LiveText& reason) {
        requested_.reset();
        showProgress();
        showMessage(reason);
      });
  showProgress();
}

/// Shows a stage; the cross may have moved since it was requested.
void MapPanel::take(ParameterMap map) {
  if (requested_) map.scene = requested_->scene;
  map_ = std::make_shared<const ParameterMap>(std::move(map));
  showMap();
}

void MapPanel::showMap() {
  showTips();
  showProgress();
  if (!map_) return;
  const std::string shown = quantity().toStdString();
  showCross();
  const auto origin = [map = map_, shown] { return mapProvenance(*map, shown); };
  DiagramExport saved;
  if (map_->isFinal)  // a stage has fewer lines than a file of it would state
    saved = {
        "map", [origin] { return provenanceLine(origin()); },
        [map = map_, shown, origin] { return provenanceComment(origin()) + mapCsv(*map, shown); },
        [map = map_, shown] { return mapSheet(*map, shown); }};
  view_->show([map = map_, shown] { return mapSheetWithSection(*map, shown); }, saved);
  save_->setEnabled(!view_->files().isEmpty());
}

void MapPanel::showCross() {
  const double x = parameterNumber(*map_->x.range.row, map_->scene);
  const double y = parameterNumber(*map_->y.range.row, map_->scene);
  view_->setCross(x, y);
  view_->setAccessibleDescription(readingAt(x, y));  // for those who move it by keys
}

/// Sets both parameters. A map of another scene, which is shown until there is that of the present
/// one, would bring its own scene back; its cross stays.
void MapPanel::moveTo(double x, double y) {
  if (!map_) return;
  if (!isCoveredBy(*map_)) return showCross();
  try {
    Scene edited = sceneAt(*map_, roundedToDigits(x, kDigits), roundedToDigits(y, kDigits));
    edited.accuracy.targetRelativeError = target_;
    emit sceneEdited(edited);
  } catch (const InputError&) {
    // Rounding exceeded a limit; the cross continues from the next position.
  }
}

/// Shows that a map has no target accuracy where its scene has one.
void MapPanel::showTarget() {
  const bool isLeftOut = target_ > 0 && scene_.accuracy.scheme == Scheme::Cubic;
  if (!isLeftOut) return showMessage({});
  showMessage([] { return tr("without the target error"); },
              [] {
                return tr(
                    "All cells of a map have the same lines, those that the scene "
                    "states.");
              });
}

/// Shows a text beside the lists, as why there is no map. Without a tip of its own the tooltip has
/// all of the text, for which the label may be too narrow.
void MapPanel::showMessage(const LiveText& text, const LiveText& tip) {
  messageText_ = text;
  messageTip_ = tip.isEmpty() ? text : tip;
  updateMessage();
}

void MapPanel::updateMessage() {
  message_->setText(messageText_);
  message_->setToolTip(messageTip_);
  message_->setVisible(!messageText_.isEmpty());
}

/// Shows of how many lines the values are the mean and how much of the map over all lines is
/// computed, in the place of the button that saves the complete map.
void MapPanel::showProgress() {
  const bool waits = work_.isBusy();
  view_->setPlaceholder(waits ? tr("The map is being computed…") : QString());
  end_->setCurrentWidget(waits ? static_cast<QWidget*>(progressLabel_) : save_);
  if (!waits)
    return save_->setToolTip(tr("Save the map as a picture or a table, once it is computed"));
  const bool isStage = map_ && !map_->isFinal && !map_->points.empty() && isCoveredBy(*map_);
  const std::int64_t shown = isStage ? map_->points.front().realizations : 0;
  const QString percent = tr("%1 %").arg(percent_);
  progressLabel_->setText(shown > 1 ? shortProgress(shown, percent_) : percent);
  const QString reason =
      tr("%1 % of the map over all lines are computed. It can be saved then: what is shown until "
         "then is a mean of fewer lines.")
          .arg(percent_);
  const QString lines =
      lines_ > 1 ? tr("Shown: the mean of %1 of %2 lines. ").arg(shown).arg(lines_) : QString();
  progressLabel_->setToolTip(wrappedTip(lines + reason));
  save_->setToolTip(reason);
}

/// Makes the boxes as wide as their names, which their tips repeat where a box is too narrow.
void MapPanel::showTips() {
  for (ChoiceBox* box : {x_, y_, quantity_}) {
    box->setShownText(box->currentText());
    box->setToolTip(box->currentText());
  }
  fitRow();
}

/// Leaves out the word before the list of quantities, which names itself, where names would be
/// shortened.
void MapPanel::fitRow() {
  const bool isLeftOut = quantityLabel_->isHidden();
  const int label = isLeftOut ? quantityLabel_->sizeHint().width() + row_->spacing() : 0;
  quantityLabel_->setVisible(row_->sizeHint().width() + label <= width());
}

void MapPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitRow();
}

/// Returns the two values and the friction of the nearest cell.
QString MapPanel::readingAt(double x, double y) const {
  if (!map_) return {};
  const auto nearest = [](const MapAxis& axis, double value) {
    const auto place = [&](double v) { return axis.range.isLogarithmic ? std::log(v) : v; };
    std::size_t best = 0;
    for (std::size_t i = 1; i < axis.values.size(); ++i)
      if (std::abs(place(axis.values[i]) - place(value)) <
          std::abs(place(axis.values[best]) - place(value)))
        best = i;
    return best;
  };
  const std::size_t i = nearest(map_->x, x), j = nearest(map_->y, y);
  const std::string shown = quantity().toStdString();
  const double value = mapValues(*map_, shown)[j * map_->x.values.size() + i];
  return QStringLiteral("%1, %2: %3%4")
      .arg(quantityLabel(map_->x.values[i], map_->x.range.row->unit),
           quantityLabel(map_->y.values[j], map_->y.range.row->unit),
           map_->isFinal ? QString() : QStringLiteral("\u2248\u00a0"),
           quantityLabel(value, mapQuantityUnit(shown)));
}

}  // namespace asperity
