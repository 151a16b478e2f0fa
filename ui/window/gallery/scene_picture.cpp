#include "ui/window/gallery/scene_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/accuracy/compute_curve.h"
#include "core/base/stop.h"
#include "core/chart/comparison.h"
#include "core/chart/curve_diagram.h"
#include "core/run/simulation.h"
#include "core/run/steady_frames.h"
#include "core/run/transient_diagram.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"

namespace asperity {

namespace {

constexpr std::int64_t kLines = 6;  // of a friction curve; smooth enough for a small picture
constexpr int kParts = 100;         // of a motion, between which it can be stopped

/// Draws the list without its texts and returns the part inside of the axes.
QImage cropped(DrawList list, const QRectF& part) {
  list.texts.clear();
  const QRect whole = part.toAlignedRect().intersected(QRect(0, 0, list.width, list.height));
  return renderImage(contextOfThread(), list)
      .copy(whole)
      .scaled(kScenePicture, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Returns the view of the contact under the greatest pressure, as wide as shows its summit.
ContactView closeUp(const Frame& frame) {
  constexpr double kWidth = 0.26;  // of the period
  ContactView view = fittedView(frame);
  const auto count = static_cast<std::int64_t>(frame.pressure.size());
  if (count == 0) return view;
  const auto most = std::ranges::max_element(frame.pressure) - frame.pressure.begin();
  view.width = kWidth * frame.length;
  view.left = (static_cast<double>(most) + 0.5) * frame.spacing - 0.5 * view.width;
  // Heights from below the contact to the middle height of the line beside it.
  const auto half = static_cast<std::int64_t>(0.5 * kWidth * static_cast<double>(count));
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, deepest = lowest;
  for (std::int64_t i = most - half; i <= most + half; ++i) {
    const auto at = static_cast<std::size_t>(((i % count) + count) % count);
    lowest = std::min(lowest, static_cast<double>(frame.lineHeight[at]));
    highest = std::max(highest, static_cast<double>(frame.lineHeight[at]));
    deepest = std::min(deepest, static_cast<double>(frame.surfaceHeight[at]));
  }
  const double size = 0.6 * (highest - lowest);
  if (!(size > 0)) return view;
  view.bottom = std::min(lowest, deepest) - 0.75 * size;
  view.top = lowest + size;
  return view;
}

QImage contactImage(const Scene& scene, const Theme& theme, bool isClose) {
  const Frame frame = SteadyFrames(std::make_shared<const Scene>(scene), {},
                                   isClose ? 0.1 * scene.surface.length : 0)
                          .frameAt(0, 0, 0);
  ContactPictureOptions options;
  options.theme = theme;
  options.title = options.names = false;
  options.lineWidth = 2.5F;
  options.view = isClose ? closeUp(frame) : fittedView(frame);
  // The axes around the plot take a part of the picture, which grows until the plot is as large as
  // the result.
  const QSizeF wanted = kScenePicture;
  options.width = static_cast<int>(wanted.width());
  options.height = static_cast<int>(wanted.height());
  for (int i = 0; i < 3; ++i) {
    const Box plot = contactPlotArea(frame, options);
    options.width +=
        static_cast<int>(std::lround(wanted.width() - static_cast<double>(plot.width)));
    options.height +=
        static_cast<int>(std::lround(wanted.height() - static_cast<double>(plot.height)));
  }
  const Box plot = contactPlotArea(frame, options);
  return cropped(composeContact(frame, options), {plot.x, plot.y, plot.width, plot.height});
}

/// Draws the first diagram of a sheet, with thick curves.
QImage diagramImage(DiagramSheet sheet, const Theme& theme) {
  sheet.title = {};
  sheet.note = {};
  sheet.diagrams.resize(1);
  DiagramOptions options;
  options.width = 2 * kScenePicture.width();
  options.height = 2 * kScenePicture.height();
  options.scale = 2;
  options.theme = theme;
  options.format.lineWidth = 6;
  options.format.legend = LegendMode::None;
  const std::vector<DiagramFrame> frames = diagramFrames(sheet, options);
  if (frames.empty()) return cropped(composeDiagrams(sheet, options), QRectF(0, 0, 1e6, 1e6));
  const DiagramFrame& frame = frames.front();
  return cropped(composeDiagrams(sheet, options),
                 {frame.left, frame.top, frame.width, frame.height});
}

QImage curveImage(Scene scene, const Theme& theme, const std::stop_token& stop) {
  scene.ensemble.realizations = std::min(scene.ensemble.realizations, kLines);
  scene.accuracy.targetRelativeError = 0;
  CurveOptions options;
  options.threads = 1;
  options.stop = stop;
  const Curve curve = computeCurve(scene, options);
  throwIfStopped(stop);
  CurveSet set;
  set.present = {{}, scene, curve.points, 0, kPresentCurve};
  StateOptions others;
  others.stop = stop;
  if (hasComparisons(set)) addComparisons(set, readComparisonData(scene), others);
  return diagramImage(curveSheet(set), theme);
}

/// Draws friction in time, which is the second strip of a motion.
QImage motionImage(const Scene& scene, const Theme& theme, const std::stop_token& stop) {
  Simulation motion(std::make_shared<const Scene>(scene), 0,
                    std::numeric_limits<double>::infinity());
  for (int i = 0; i < kParts; ++i) {
    throwIfStopped(stop);
    motion.advance(1.0 / kParts, 1.0 / 25);
  }
  const Frame frame = motion.frame();
  if (!frame.transient) return contactImage(scene, theme, false);
  DiagramSheet sheet = transientSheet(scene, *frame.transient, frame.spacing, frame.length);
  if (sheet.diagrams.size() > 1) sheet.diagrams.erase(sheet.diagrams.begin());
  return diagramImage(std::move(sheet), theme);
}

}  // namespace

QImage drawScenePicture(const Scene& scene, SceneView view, const Theme& theme,
                        const std::stop_token& stop) {
  throwIfStopped(stop);
  switch (view) {
    case SceneView::Curve:
      return curveImage(scene, theme, stop);
    case SceneView::Motion:
      return motionImage(scene, theme, stop);
    case SceneView::Contact:
    case SceneView::CloseUp:
      break;
  }
  return contactImage(scene, theme, view == SceneView::CloseUp);
}

}  // namespace asperity
