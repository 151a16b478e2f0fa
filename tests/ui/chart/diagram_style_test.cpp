#include "ui/chart/diagram_style.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ui/draw/draw_list.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

using Vector = std::array<double, 3>;

Vector linear(const Rgba& c) {
  const auto channel = [](double s) {
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  return {channel(c.r), channel(c.g), channel(c.b)};
}

double luminance(const Rgba& c) {
  const Vector v = linear(c);
  return 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2];
}

/// WCAG 2: 1 to 21.
double contrast(const Rgba& a, const Rgba& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// CIE L*a*b*, D65.
Vector lab(const Vector& rgb) {
  const double x = (0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505;
  const double y = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  const double z = (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Machado, Oliveira and Fernandes (2009), severity 1; linear RGB.
using Matrix = std::array<Vector, 3>;
constexpr Matrix kNormal = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kProtan = {{{0.152286, 1.052583, -0.204868},
                             {0.114503, 0.786281, 0.099216},
                             {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeutan = {{{0.367322, 0.860646, -0.227968},
                             {0.280085, 0.672501, 0.047413},
                             {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kVisions[] = {kNormal, kProtan, kDeutan};

Vector seen(const Matrix& vision, const Rgba& c) {
  const Vector v = linear(c);
  Vector out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = std::clamp(vision[i][0] * v[0] + vision[i][1] * v[1] + vision[i][2] * v[2], 0.0, 1.0);
  return lab(out);
}

const Theme* const kThemes[] = {&lightTheme(), &darkTheme(), &printTheme()};

TEST(DiagramColours, StandOutFromEveryBackground) {
  for (const Theme* theme : kThemes) {
    for (int i = 0; i < kDistinctColours; ++i)
      EXPECT_GT(contrast(seriesColour(i, *theme), theme->background), 2.5) << i;
    for (int k = 0; k <= 20; ++k)
      EXPECT_GT(contrast(rampColour(k / 20.0, *theme), theme->background), 1.75) << k;
    EXPECT_GT(contrast(theme->text, theme->background), 7);
  }
}

TEST(DiagramColours, AreToldApartByEveryColourVision) {
  for (const Theme* theme : kThemes)
    for (const Matrix& vision : kVisions)
      for (int i = 0; i < kDistinctColours; ++i)
        for (int k = 0; k < i; ++k)
          EXPECT_GT(distance(seen(vision, seriesColour(i, *theme)),
                             seen(vision, seriesColour(k, *theme))),
                    10)
              << i << " and " << k;
}

TEST(DiagramColours, TheRampRisesInLightness) {
  for (const Theme* theme : kThemes)
    for (const Matrix& vision : kVisions)
      for (int k = 0; k < 20; ++k)
        EXPECT_GT(seen(vision, rampColour((k + 1) / 20.0, *theme))[0],
                  seen(vision, rampColour(k / 20.0, *theme))[0])
            << k;
}

/// A map printed in grey, as are lines, texts and the ground.
TEST(DiagramColours, GreyPicturesHaveGreyFields) {
  DrawList list;
  DrawLayer layer;
  layer.fields.push_back(
      {{0, 1}, {0, 1}, {fieldColour(0), fieldColour(0.3), fieldColour(0.6), fieldColour(1)}});
  list.layers.push_back(layer);
  removeColours(list);
  const std::vector<Rgba>& colours = list.layers[0].fields[0].colours;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    EXPECT_EQ(colours[i].r, colours[i].g);
    EXPECT_EQ(colours[i].g, colours[i].b);
    if (i == 0) continue;
    EXPECT_GT(colours[i].r, colours[i - 1].r);  // lighter where the value is larger
  }
}

/// The cross of a map has a contrast of 3 with every colour of the field (WCAG 1.4.11): its core
/// with its edge, and one of them with the field.
TEST(DiagramColours, ALineIsSeenOnEveryColourOfAField) {
  for (int k = 0; k <= 100; ++k) {
    const Rgba field = fieldColour(0.01 * k);
    const Rgba edge = mix(field, withAlpha(kEdgeOnField, 1), kEdgeOnField.a);
    EXPECT_GE(contrast(kLineOnField, edge), 3) << k;
    EXPECT_GE(std::max(contrast(kLineOnField, field), contrast(edge, field)), 3) << k;
  }
}

TEST(DiagramColours, BearAnyNumber) {
  const Theme& theme = lightTheme();
  EXPECT_EQ(seriesColour(kDistinctColours, theme).r, seriesColour(0, theme).r);
  EXPECT_EQ(seriesColour(-5, theme).r, seriesColour(0, theme).r);
  EXPECT_EQ(rampColour(-1, theme).r, rampColour(0, theme).r);
  EXPECT_EQ(rampColour(7, theme).b, rampColour(1, theme).b);
  EXPECT_EQ(rampColour(std::nan(""), theme).g, rampColour(0, theme).g);
}

}  // namespace
}  // namespace asperity
