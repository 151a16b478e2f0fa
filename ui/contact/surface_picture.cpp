#include "ui/contact/surface_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/contact/contact_layout.h"
#include "ui/contact/smooth_line.h"
#include "ui/draw/fonts.h"
#include "ui/draw/plot_axes.h"
#include "ui/draw/theme.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

constexpr int kDigits = 4;                // of the statistics
constexpr double kDecadesShown = 20;      // of a spectrum, below its highest point
constexpr double kFlatHalfHeight = 1e-6;  // m, shown around a line without heights

/// A mode of the line as the spectrum shows it, in decimal logarithms.
struct SpectrumPoint {
  double waveNumber;  // of q in 1/m
  double density;     // of C in m^3
};

std::vector<SpectrumPoint> spectrumOf(const FourierLine& modes, double length) {
  const double lowest = 2 * std::numbers::pi / length;
  std::vector<SpectrumPoint> points;
  for (std::size_t j = 0; j < modes.coefficients.size(); ++j) {
    const double density = std::norm(modes.coefficients[j]) / lowest;
    if (density > 0 && std::isfinite(density))
      points.push_back({std::log10(lowest * static_cast<double>(j + 1)), std::log10(density)});
  }
  return points;
}

std::vector<std::string> factsOf(const Scene& scene, const Line& line) {
  std::vector<std::string> facts{
      filled(Words::tr("one period L = %1"), {quantity(line.length, "m", kDigits)}),
      filled(Words::tr("rms height h = %1"), {quantity(line.rmsHeight, "m", kDigits, Zeros::Keep)}),
      filled(Words::tr("rms slope = %1"), {shortNumber(line.rmsSlope, kDigits, Zeros::Keep)})};
  if (scene.surface.kind == SurfaceKind::SelfAffine)
    facts.push_back(
        filled(Words::tr("Hurst exponent H = %1"), {shortNumber(scene.surface.hurst, kDigits)}));
  return facts;
}

class SurfacePicture {
 public:
  SurfacePicture(const Scene& scene, const Line& line, const FourierLine& modes,
                 const SurfacePictureOptions& options)
      : scene_(scene),
        line_(line),
        theme_(options.theme),
        spectrum_(spectrumOf(modes, line.length)) {
    list_.width = std::max(options.width, 1);
    list_.height = std::max(options.height, 1);
    list_.background = theme_.background;
    ContactPictureOptions sizes;
    sizes.width = list_.width;
    sizes.height = list_.height;
    sizes.scale = options.scale;
    sizes_ = sizesFor(sizes);
    side_ = std::round(16 * sizes_.unit);
  }

  DrawList compose() {
    const float top = addHeader() + side_;
    if (line_.nodes() == 0 || !(line_.length > 0)) return std::move(list_);
    const float below = std::ceil(kPlotBelow * sizes_.small);
    const float bottom = static_cast<float>(list_.height) - below;
    const float least = 8 * sizes_.small;  // height of a panel that can be read
    const bool both =
        spectrum_.size() > 1 && line_.rmsHeight > 0 && bottom - top > 2 * least + below + side_;
    const float middle = both ? top + 0.46F * (bottom - top - below - side_) : bottom;

    PlotAxes heights = lineAxes(top, middle), densities;
    float labels = widestLabel(heights.up, sizes_.small);
    if (both) {
      densities = spectrumAxes(middle + below + side_, bottom);
      labels = std::max(labels, widestLabel(densities.up, sizes_.small));
    }
    // The labels and, left of them, the titles.
    const float left = std::round(labels + 3 * sizes_.small);
    for (PlotAxes* axes : {&heights, &densities}) {
      axes->box.x = left;
      axes->box.width = std::max(1.0F, static_cast<float>(list_.width) - side_ - left);
    }
    addLinePanel(heights);
    if (both) addSpectrumPanel(densities);
    return std::move(list_);
  }

 private:
  /// Returns the pixels taken from the top.
  float addHeader() {
    const float width = static_cast<float>(list_.width) - 2 * side_;
    const std::string title =
        scene_.title.empty() ? Words::tr("Rigid line") : sceneText(scene_.title).toStdString();
    float baseline = std::round(10 * sizes_.unit + sizes_.title);
    addText(list_, {{elided(title, sizes_.title, true, width), true}}, {side_, baseline},
            sizes_.title, theme_.text);
    const float gap = 2 * sizes_.body, row = std::round(1.6F * sizes_.body);
    float x = side_;
    baseline += row;
    for (const std::string& fact : factsOf(scene_, line_)) {
      const float needed = textWidth(fact, sizes_.body);
      if (x > side_ && x + needed > side_ + width) {
        x = side_;
        baseline += row;
      }
      addLabel(list_, elided(fact, sizes_.body, false, width), {std::round(x), baseline},
               sizes_.body, TextAnchor::Left, theme_.faintText);
      x += needed + gap;
    }
    return baseline;
  }

  /// A box from `top` to `bottom`, over the whole width until the labels are known.
  Box roughBox(float top, float bottom) const {
    return {0, top, static_cast<float>(list_.width) - 6 * sizes_.small,
            std::max(1.0F, bottom - top)};
  }

  PlotAxes lineAxes(float top, float bottom) {
    PlotAxes axes;
    axes.box = roughBox(top, bottom);
    points_ = sampledLine(line_, static_cast<std::size_t>(list_.width));
    const auto [lowest, highest] = std::minmax_element(
        points_.begin(), points_.end(),
        [](const LinePoint& a, const LinePoint& b) { return a.height < b.height; });
    double low = lowest->height, high = highest->height;
    // A line without heights: rounding errors are not shown as if they were roughness.
    if (!(high - low > 1e-9 * std::max(std::abs(low), std::abs(high)))) {
      low -= kFlatHalfHeight;
      high += kFlatHalfHeight;
    }
    const double below = 0.08 * (high - low);
    // Above, the name of the body has room beside the highest crest.
    const double label = std::min(0.4F, 2.4F * sizes_.small / axes.box.height);
    const double above = std::max(0.08, label / (1 - label)) * (high - low);
    const float size = sizes_.small;
    axes.along = linearAxisAlong(0, line_.length, axes.box.width, size, Words::tr("position"), "m");
    axes.up =
        linearAxisUp(low - below, high + above, axes.box.height, size, Words::tr("height"), "m");
    return axes;
  }

  PlotAxes spectrumAxes(float top, float bottom) const {
    PlotAxes axes;
    axes.box = roughBox(top, bottom);
    double low = spectrum_.front().density, high = low;
    for (const SpectrumPoint& point : spectrum_) {
      low = std::min(low, point.density);
      high = std::max(high, point.density);
    }
    const float size = sizes_.small;
    const int along = std::clamp(static_cast<int>(axes.box.width / (6 * size)), 2, 10);
    const int up = std::clamp(static_cast<int>(axes.box.height / (2.2F * size)), 2, 8);
    axes.along =
        logarithmicAxis(spectrum_.front().waveNumber - 0.1, spectrum_.back().waveNumber + 0.1,
                        along, Words::tr("wave number q (1/m)"), "q (1/m)");
    axes.up = logarithmicAxis(std::max(low, high - kDecadesShown) - 0.5, high + 0.5, up,
                              Words::tr("power spectral density C (m³)"), "C (m³)");
    return axes;
  }

  void addLinePanel(const PlotAxes& axes) {
    addPlotAxes(list_, axes, theme_, sizes_.small, sizes_.unit);
    const Box& box = axes.box;
    std::vector<Place> places;
    places.reserve(points_.size());
    for (const LinePoint& point : points_)
      places.push_back({axes.px(point.x), axes.py(point.height)});
    places = thinned(places);
    DrawLayer layer;
    layer.clip = {box.x, box.y, box.width, box.height};
    for (std::size_t i = 1; i < places.size(); ++i) {  // the rigid body is above
      const auto corner = [&](Place place) { return DrawVertex{place.x, place.y, theme_.rigid}; };
      addQuad(layer, corner({places[i - 1].x, box.y}), corner({places[i].x, box.y}),
              corner(places[i]), corner(places[i - 1]));
    }
    addLine(layer, places, 1.5F * sizes_.unit, theme_.rigidEdge);
    list_.layers.push_back(std::move(layer));
    const TextRuns name{{Words::tr("rigid body"), true}};
    if (box.height > 5 * sizes_.small && textWidth(name, sizes_.small) + side_ < box.width)
      addText(list_, name,
              {std::round(box.x + 0.6F * side_), std::round(box.y + 1.6F * sizes_.small)},
              sizes_.small, textOn(theme_.rigid));
  }

  void addSpectrumPanel(const PlotAxes& axes) {
    addPlotAxes(list_, axes, theme_, sizes_.small, sizes_.unit);
    const Box& box = axes.box;
    std::vector<Place> places;
    for (const SpectrumPoint& point : spectrum_)
      places.push_back({axes.px(point.waveNumber), axes.py(point.density)});
    DrawLayer layer;
    layer.clip = {box.x, box.y, box.width, box.height};
    addLine(layer, thinned(places), 2 * sizes_.unit, theme_.highlight);
    list_.layers.push_back(std::move(layer));
    const std::string law = Words::tr("C ∝ q⁻²ᴴ⁻¹, cut off at π over the element spacing");
    if (scene_.surface.kind == SurfaceKind::SelfAffine &&
        textWidth(law, sizes_.small) < 0.7F * box.width)
      addLabel(list_, law, {box.right() - 0.6F * side_, std::round(box.y + 1.8F * sizes_.small)},
               sizes_.small, TextAnchor::Right, theme_.text);
  }

  const Scene& scene_;
  const Line& line_;
  Theme theme_;
  std::vector<SpectrumPoint> spectrum_;
  std::vector<LinePoint> points_;
  Sizes sizes_;
  float side_ = 0;
  DrawList list_;
};

}  // namespace

DrawList composeSurface(const Scene& scene, const Line& line, const FourierLine& modes,
                        const SurfacePictureOptions& options) {
  return SurfacePicture(scene, line, modes, options).compose();
}

}  // namespace asperity
