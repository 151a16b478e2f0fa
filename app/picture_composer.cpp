#include "app/picture_composer.h"

#include <fmt/format.h>

#include <cmath>

#include "app/command_options.h"
#include "core/base/input_error.h"
#include "core/chart/curve_diagram.h"
#include "core/run/transient_diagram.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_overlay.h"
#include "ui/draw/stroke_pattern.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

// Told from the means, in front of which it may stand.
constexpr int kPresentColour = 1;

// Strips are low, which would make their texts small; where they are lower than so many heights of
// a number, the texts make room for them all the same.
constexpr float kStripText = 0.8F, kLeastStripText = 0.5F;
constexpr float kGoodStrip = 3, kLeastStrip = 2;

constexpr NamedChoices<PictureLayout, 4> kLayouts{{{"contact", PictureLayout::Contact},
                                                   {"curve", PictureLayout::Curve},
                                                   {"both", PictureLayout::Both},
                                                   {"transient", PictureLayout::Transient}}};

DiagramSeries ringAround(DiagramSeries series) {
  series.name = {};
  series.mark = SeriesMark::Ring;
  return series;
}

}  // namespace

PictureLayout layoutFrom(const std::string& name, const char* key) {
  return chosenFrom(kLayouts, name, key);
}

ContactOverlay overlayFrom(const std::string& name) {
  NamedChoices<ContactOverlay, 4> all{{{{}, ContactOverlay::None},
                                       {{}, ContactOverlay::Pressure},
                                       {{}, ContactOverlay::Relaxation},
                                       {{}, ContactOverlay::Power}}};
  for (auto& [word, overlay] : all) word = wordFor(overlay);
  return chosenFrom(all, name, "--overlay");
}

void checkPanels(const DiagramSheet& sheet, const PictureStyle& style, int above) {
  if (sheet.diagrams.size() < 2) return;
  const int room = style.height - above;
  const int needed = heightForAll(sheet, {style.width, room, style.scale, style.theme});
  if (needed == room) return;
  const std::string given = fmt::format("{}x{}", style.width, style.height);
  if (needed == 0)
    throw InputError("", "--size", given + " is too narrow for the curve and the difference");
  const int least = 10 * ((needed * style.height / room + 19) / 10);
  throw InputError("", "--size",
                   message("{} leaves no room for the difference under the curve; {}x{} does",
                           given, style.width, least));
}

PictureComposer::PictureComposer(const PictureStyle& style, PictureContent content)
    : style_(style), content_(std::move(content)) {
  if (style_.transparent) style_.theme.background.a = 0;
}

DrawList PictureComposer::compose(const Frame& frame) {
  const PictureLayout layout = content_.layout;
  if (layout == PictureLayout::Contact) return contact(frame, style_.height);
  if (layout == PictureLayout::Curve) return diagram(curveWithPresent(frame), style_.height);
  const int above = contactHeight();
  if (layout == PictureLayout::Both) {
    if (!below_ || frame.transient) {
      DiagramSheet sheet = curveWithPresent(frame);
      sheet.title = {};  // it stands above
      below_ = diagram(sheet, style_.height - above);
    }
    return stacked(contact(frame, above), *below_);
  }
  const auto samples = frame.transient ? *frame.transient : std::vector<TransientSample>{};
  const DiagramSheet strips = transientSheet(*frame.scene, samples, frame.spacing, frame.length);
  const int below = style_.height - above;
  return stacked(contact(frame, above), diagram(strips, below, stripText(strips, below)));
}

int PictureComposer::contactHeight() const {
  const bool hasDifference = content_.layout == PictureLayout::Both && content_.curves.difference;
  return static_cast<int>(
      std::lround((hasDifference ? kContactPartOfThree : kContactPart) * style_.height));
}

float PictureComposer::stripText(const DiagramSheet& strips, int height) const {
  float text = kStripText;
  while (text > kLeastStripText && lowestFrame(strips, optionsFor(height, text)) < kGoodStrip)
    text -= 0.1F;
  return std::max(text, kLeastStripText);
}

void PictureComposer::checkStrips(const Scene& scene) const {
  if (content_.layout != PictureLayout::Transient) return;
  const DiagramSheet strips = transientSheet(scene, {}, 0, 0);
  const auto hasRoom = [&](int height) {
    return lowestFrame(strips, optionsFor(height, stripText(strips, height))) >= kLeastStrip;
  };
  int height = style_.height - contactHeight();
  if (hasRoom(height)) return;
  constexpr int kHighest = 20000, kStep = 10;
  while (height < kHighest && !hasRoom(height)) height += kStep;
  const std::string given = fmt::format("{}x{}", style_.width, style_.height);
  if (height >= kHighest)
    throw InputError("", "--size", given + " is too narrow for strips over time");
  const int least = kStep * (static_cast<int>(height / (1 - kContactPart)) / kStep + 1);
  throw InputError("", "--size",
                   message("{} leaves no room for the strips over time; {}x{} does", given,
                           style_.width, least));
}

void PictureComposer::checkRoom(const Scene& scene) const {
  checkStrips(scene);
  const PictureLayout layout = content_.layout;
  if (layout != PictureLayout::Curve && layout != PictureLayout::Both) return;
  DiagramSheet sheet = curveSheet(content_.curves);
  if (layout == PictureLayout::Both) sheet.title = {};
  checkPanels(sheet, style_, layout == PictureLayout::Both ? contactHeight() : 0);
}

DrawList PictureComposer::contact(const Frame& frame, int height) {
  ContactPictureOptions options;
  options.width = style_.width;
  options.height = height;
  options.scale = style_.scale;
  options.theme = style_.theme;
  options.overlay = content_.overlay;
  view_ = fittedView(frame, view_);
  options.view = *view_;
  applyView(content_.view, frame, options);
  return composeContact(frame, options);
}

DiagramOptions PictureComposer::optionsFor(int height, float leastText) const {
  return {style_.width, height, style_.scale, style_.theme, leastText};
}

DrawList PictureComposer::diagram(const DiagramSheet& sheet, int height, float leastText) const {
  return composeDiagrams(sheet, optionsFor(height, leastText));
}

/// The curve and on it the line and the velocity of the frame, and the way that a motion came.
DiagramSheet PictureComposer::curveWithPresent(const Frame& frame) const {
  DiagramSheet sheet = curveSheet(content_.curves);
  const auto [velocity, friction] = factorsOf(content_.curves.present.points, content_.curves.axes);
  std::vector<DiagramSeries>& series = sheet.diagrams.front().series;
  DiagramSeries present;
  present.mark = SeriesMark::Diamond;
  present.stroke = SeriesStroke::None;
  present.colour = kPresentColour;
  if (frame.transient) {
    DiagramSeries trace;
    trace.colour = kPresentColour;
    for (const TransientSample& sample : *frame.transient)
      trace.points.push_back({std::abs(sample.velocity) * velocity, sample.mu * friction});
    present.name = Words::tr("the motion up to here");
    if (!trace.points.empty()) present.points = {trace.points.back()};
    series.push_back(std::move(trace));
    series.push_back(ringAround(present));  // it may stand in the middle of the trace
  } else {
    present.name = Words::tr("the line shown, at its velocity");
    present.points = {{frame.scene->sliding.velocity * velocity, frame.muSteady * friction}};
  }
  series.push_back(std::move(present));
  return sheet;
}

}  // namespace asperity
