// The light below coloured parts of the elastomer's surface.
#include <algorithm>
#include <cmath>

#include "ui/contact/contact_parts.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr int kRows = 12;

/// Values at equidistant positions across the plot.
class Strip {
 public:
  Strip(const ContactLayout& layout, float step)
      : left_(layout.plot.x),
        step_(step),
        values_(static_cast<std::size_t>(layout.plot.width / step) + 2) {}

  std::size_t size() const { return values_.size(); }
  float place(std::size_t i) const { return left_ + static_cast<float>(i) * step_; }
  float& operator[](std::size_t i) { return values_[i]; }
  float operator[](std::size_t i) const { return values_[i]; }

  /// Returns the nearest position, limited to the strip.
  std::size_t nearest(float x) const {
    const float i = std::round((x - left_) / step_);
    return static_cast<std::size_t>(std::clamp(i, 0.0F, static_cast<float>(values_.size() - 1)));
  }
  bool covers(float x) const { return x > left_ - step_ && x < place(values_.size() - 1) + step_; }

  void soften() {
    float before = values_.front();
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const float here = values_[i];
      const float after = i + 1 < values_.size() ? values_[i + 1] : here;
      values_[i] = 0.25F * before + 0.5F * here + 0.25F * after;
      before = here;
    }
  }

 private:
  float left_, step_;
  std::vector<float> values_;
};

/// Writes the surface's pixel row at every position of the strip.
void sampleSurface(Strip& rows, const std::vector<CurveVertex>& surface,
                   const ContactLayout& layout) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const float x = rows.place(i);
    while (k + 2 < surface.size() && layout.px(surface[k + 1].x) < x) ++k;
    const CurveVertex& a = surface[k];
    const CurveVertex& b = surface[std::min(k + 1, surface.size() - 1)];
    const float xa = layout.px(a.x), xb = layout.px(b.x);
    const float t = xb > xa ? std::clamp((x - xa) / (xb - xa), 0.0F, 1.0F) : 0;
    rows[i] = layout.py(a.height) + t * (layout.py(b.height) - layout.py(a.height));
  }
}

/// Writes positions on the colour scale; positions between the vertices of a stretch are
/// interpolated.
void markStretch(Strip& shares, const std::vector<CurveVertex>& stretch,
                 const ContactLayout& layout) {
  const auto share = [&](const CurveVertex& v) {
    return std::clamp(layout.scale.position(v.value), 0.02F, 1.0F);
  };
  const auto mark = [&](float x, float value) {
    if (shares.covers(x)) {
      float& there = shares[shares.nearest(x)];
      there = std::max(there, value);
    }
  };
  mark(layout.px(stretch.front().x), share(stretch.front()));
  for (std::size_t k = 0; k + 1 < stretch.size(); ++k) {
    const float xa = layout.px(stretch[k].x), xb = layout.px(stretch[k + 1].x);
    const float pa = share(stretch[k]), pb = share(stretch[k + 1]);
    mark(xb, pb);
    if (!shares.covers(xb) && !shares.covers(xa) && (xa > 0) == (xb > 0)) continue;
    for (std::size_t i = shares.nearest(xa) + 1; i < shares.nearest(xb); ++i) {
      const float t = (shares.place(i) - xa) / (xb - xa);
      shares[i] = std::max(shares[i], pa + t * (pb - pa));
    }
  }
}

/// The position of the light (weight) and its brightness (weighted share), smoothed row by row.
struct Light {
  Strip weight, share;
  Rgba colour(std::size_t i, int row) const {
    const float w = weight[i];
    const float t = w > 0 ? share[i] / w : 0;
    const float fade = 1 - static_cast<float>(row) / kRows;
    // Like embers, the light gets redder with depth: yellow over the elastomer's blue would turn
    // green.
    const float warmth = t * (0.25F + 0.6F * fade * fade);
    return withAlpha(pressureColour(warmth), std::pow(w, 0.7F) * fade * fade * (0.45F + 0.5F * t));
  }
};

}  // namespace

float glowDepth(const ContactLayout& layout) {
  return 0.2F * layout.plot.height;
}

void addGlow(DrawLayer& layer, const std::vector<CurveVertex>& surface,
             const std::vector<std::vector<CurveVertex>>& contacts, const ContactLayout& layout) {
  if (contacts.empty() || surface.empty()) return;
  const float step = std::max(1.0F, 2 * layout.sizes.unit);
  Strip rows(layout, step);
  sampleSurface(rows, surface, layout);
  Light light{Strip(layout, step), Strip(layout, step)};
  for (const auto& stretch : contacts) markStretch(light.share, stretch, layout);
  for (std::size_t i = 0; i < light.weight.size(); ++i)
    light.weight[i] = light.share[i] > 0 ? 1.0F : 0.0F;

  const float rowHeight = glowDepth(layout) / kRows;
  Light next = light;
  for (int row = 0; row < kRows; ++row, light = next) {
    next.weight.soften();
    next.share.soften();
    const float down = static_cast<float>(row) * rowHeight;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      if (light.weight[i] + light.weight[i + 1] + next.weight[i] + next.weight[i + 1] < 0.004F)
        continue;
      const float x0 = rows.place(i), x1 = rows.place(i + 1);
      const float y0 = rows[i] + down, y1 = rows[i + 1] + down;
      addQuad(layer, {x0, y0, light.colour(i, row)}, {x1, y1, light.colour(i + 1, row)},
              {x1, y1 + rowHeight, next.colour(i + 1, row + 1)},
              {x0, y0 + rowHeight, next.colour(i, row + 1)});
    }
  }
}

}  // namespace asperity
