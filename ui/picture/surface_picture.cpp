#include "ui/picture/surface_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "ui/picture/colours.h"
#include "ui/picture/log_ticks.h"
#include "ui/picture/shapes.h"
#include "ui/picture/text_metrics.h"
#include "ui/picture/ticks.h"

namespace asperity {
namespace {

struct LabelledTick {
  double value;  // on the axis, logarithmic axes in decades
  std::string label;
};

/// One set of axes: a box of pixels, the range it shows, its ticks and titles.
struct Axes {
  Box box;
  double left, right, bottom, top;
  std::vector<LabelledTick> along, up;
  std::string titleAlong, titleUp;

  float px(double x) const {
    return box.x + static_cast<float>((x - left) / (right - left)) * box.width;
  }
  float py(double y) const {
    return box.bottom() - static_cast<float>((y - bottom) / (top - bottom)) * box.height;
  }
};

class SurfacePicture {
 public:
  SurfacePicture(const Scene& scene, const Line& line, const FourierLine& modes,
                 const SurfacePictureOptions& options)
      : scene_(scene), line_(line), modes_(modes), theme_(options.theme), unit_(options.scale) {
    list_.width = options.width;
    list_.height = options.height;
    list_.background = theme_.background;
  }

  DrawList compose() {
    addHeader();
    const bool hasSpectrum = !modes_.coefficients.empty() && line_.rmsHeight > 0;
    const float top = 76 * unit_, bottom = static_cast<float>(list_.height) - 54 * unit_;
    const float middle = top + (bottom - top) * (hasSpectrum ? 0.44F : 1.0F);
    addLinePanel(panelBox(top, middle));
    if (hasSpectrum) addSpectrumPanel(panelBox(middle + 76 * unit_, bottom));
    return std::move(list_);
  }

 private:
  Box panelBox(float top, float bottom) const {
    const float left = 86 * unit_, right = static_cast<float>(list_.width) - 24 * unit_;
    return {left, top, right - left, bottom - top};
  }

  void text(std::string utf8, Place at, float size, const Rgba& colour,
            TextAnchor anchor = TextAnchor::Left, bool bold = false, float angle = 0) {
    list_.texts.push_back(
        {std::move(utf8), std::round(at.x), std::round(at.y), size, anchor, angle, bold, colour});
  }

  void addHeader() {
    const float left = 24 * unit_;
    text(scene_.title.empty()
             ? "Rigid line"
             : elided(scene_.title, 18 * unit_, true, static_cast<float>(list_.width) - 2 * left),
         {left, 30 * unit_}, 18 * unit_, theme_.text, TextAnchor::Left, true);
    std::string facts = "one period L = " + quantity(line_.length, "m") +
                        "     rms height h = " + quantity(line_.rmsHeight, "m") +
                        "     rms slope = " + shortNumber(line_.rmsSlope);
    if (scene_.surface.kind == SurfaceKind::SelfAffine)
      facts += "     Hurst exponent H = " + shortNumber(scene_.surface.hurst);
    text(elided(facts, 13 * unit_, false, static_cast<float>(list_.width) - 2 * left),
         {left, 54 * unit_}, 13 * unit_, theme_.faintText);
  }

  void addFrame(const Axes& axes) {
    DrawLayer layer;
    const Box& box = axes.box;
    for (const LabelledTick& tick : axes.up)
      addLine(layer, {{box.x, axes.py(tick.value)}, {box.right(), axes.py(tick.value)}}, unit_,
              theme_.grid);
    for (const LabelledTick& tick : axes.along)
      addLine(layer, {{axes.px(tick.value), box.y}, {axes.px(tick.value), box.bottom()}}, unit_,
              theme_.grid);
    addLine(layer,
            {{box.x, box.y},
             {box.right(), box.y},
             {box.right(), box.bottom()},
             {box.x, box.bottom()},
             {box.x, box.y}},
            unit_, theme_.axis);
    list_.layers.push_back(std::move(layer));
    const float small = 12 * unit_;
    for (const LabelledTick& tick : axes.along)
      text(tick.label, {axes.px(tick.value), box.bottom() + 18 * unit_}, small, theme_.faintText,
           TextAnchor::Centre);
    for (const LabelledTick& tick : axes.up)
      text(tick.label, {box.x - 8 * unit_, axes.py(tick.value) + 4 * unit_}, small,
           theme_.faintText, TextAnchor::Right);
    text(axes.titleAlong, {box.x + box.width / 2, box.bottom() + 40 * unit_}, small, theme_.text,
         TextAnchor::Centre);
    text(axes.titleUp, {24 * unit_, box.y + box.height / 2}, small, theme_.text, TextAnchor::Centre,
         false, std::numbers::pi_v<float> / 2);
  }

  static std::vector<LabelledTick> linear(const AxisTicks& ticks) {
    std::vector<LabelledTick> labelled;
    for (const Tick& tick : ticks.ticks) labelled.push_back({tick.value, tick.label});
    return labelled;
  }
  static std::vector<LabelledTick> logarithmic(double from, double to, int most) {
    std::vector<LabelledTick> labelled;
    for (const int exponent : decades(from, to, most))
      labelled.push_back({static_cast<double>(exponent), powerOfTen(exponent)});
    return labelled;
  }

  /// The lowest and highest point of each pixel column, in order.
  std::vector<Place> linePlaces(const Axes& axes) const {
    const std::size_t n = line_.nodes();
    const auto columns = static_cast<std::size_t>(std::max(1.0F, axes.box.width));
    std::vector<Place> places;
    const std::size_t block = std::max<std::size_t>(1, n / (2 * columns));
    for (std::size_t i = 0; i < n; i += block) {
      const auto first = line_.height.begin() + static_cast<std::ptrdiff_t>(i);
      const auto last = line_.height.begin() + static_cast<std::ptrdiff_t>(std::min(n, i + block));
      auto [low, high] = std::minmax_element(first, last);
      if (low > high) std::swap(low, high);
      for (const auto& extreme : {low, high}) {
        const double x = static_cast<double>(extreme - line_.height.begin()) * line_.spacing;
        places.push_back({axes.px(x), axes.py(*extreme)});
        if (low == high) break;
      }
    }
    places.push_back({axes.px(line_.length), axes.py(line_.height.front())});
    return places;
  }

  void addLinePanel(const Box& box) {
    const auto [low, high] = std::minmax_element(line_.height.begin(), line_.height.end());
    const double margin = std::max(0.08 * (*high - *low), 1e-12);
    Axes axes{box, 0, line_.length, *low - margin, *high + margin, {}, {}, "", ""};
    const AxisTicks along = linearTicks(axes.left, axes.right, 11, "m");
    const AxisTicks up = linearTicks(axes.bottom, axes.top, 6, "m");
    axes.along = linear(along);
    axes.up = linear(up);
    axes.titleAlong = "position (" + along.unit + ")";
    axes.titleUp = "height (" + up.unit + ")";
    addFrame(axes);
    DrawLayer layer;
    layer.clip = {box.x, box.y, box.width, box.height};
    const std::vector<Place> places = linePlaces(axes);
    for (std::size_t i = 1; i < places.size(); ++i) {  // the rigid body is above
      const auto corner = [&](Place place) { return DrawVertex{place.x, place.y, theme_.rigid}; };
      addQuad(layer, corner({places[i - 1].x, box.y}), corner({places[i].x, box.y}),
              corner(places[i]), corner(places[i - 1]));
    }
    addLine(layer, places, 1.5F * unit_, theme_.rigidEdge);
    list_.layers.push_back(std::move(layer));
    text("rigid body", {box.x + 12 * unit_, box.y + 20 * unit_}, 13 * unit_, theme_.text,
         TextAnchor::Left, true);
  }

  void addSpectrumPanel(const Box& box) {
    const double lowest = 2 * std::numbers::pi / line_.length;
    std::vector<std::pair<double, double>> points;  // decades of q (1/m) and C (m^3)
    for (std::size_t j = 0; j < modes_.coefficients.size(); ++j) {
      const double density = std::norm(modes_.coefficients[j]) / lowest;
      if (density > 0)
        points.push_back({std::log10(lowest * static_cast<double>(j + 1)), std::log10(density)});
    }
    if (points.size() < 2) return;
    double low = points[0].second, high = low;
    for (const auto& point : points) {
      low = std::min(low, point.second);
      high = std::max(high, point.second);
    }
    Axes axes{box,
              points.front().first - 0.1,
              points.back().first + 0.1,
              std::max(low, high - 20) - 0.5,
              high + 0.5,
              {},
              {},
              "wave number q (1/m)",
              "power spectral density C (m³)"};
    axes.along = logarithmic(std::pow(10, axes.left), std::pow(10, axes.right), 10);
    axes.up = logarithmic(std::pow(10, axes.bottom), std::pow(10, axes.top), 8);
    addFrame(axes);
    DrawLayer layer;
    layer.clip = {box.x, box.y, box.width, box.height};
    std::vector<Place> places;
    for (const auto& point : points) {
      const Place place{axes.px(point.first), axes.py(point.second)};
      if (places.empty() || place.x - places.back().x > 0.5F || points.size() < 200)
        places.push_back(place);
    }
    addLine(layer, places, 2 * unit_, theme_.highlight);
    list_.layers.push_back(std::move(layer));
    if (scene_.surface.kind == SurfaceKind::SelfAffine)
      text("C ∝ q⁻²ᴴ⁻¹, cut off at π over the element spacing",
           {box.right() - 12 * unit_, box.y + 22 * unit_}, 13 * unit_, theme_.text,
           TextAnchor::Right);
  }

  const Scene& scene_;
  const Line& line_;
  const FourierLine& modes_;
  Theme theme_;
  float unit_;
  DrawList list_;
};

}  // namespace

DrawList composeSurface(const Scene& scene, const Line& line, const FourierLine& modes,
                        const SurfacePictureOptions& options) {
  return SurfacePicture(scene, line, modes, options).compose();
}

}  // namespace asperity
