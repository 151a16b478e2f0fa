#include "app/pictures/picture_composer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/progress_bar.h"
#include "core/base/input_error.h"
#include "core/base/named_choices.h"
#include "core/chart/curve_diagram.h"
#include "core/chart/curve_regions.h"
#include "core/run/transient_diagram.h"
#include "ui/draw/shapes.h"

namespace asperity {
namespace {

// Sizes of texts in strips, which are low and would make their texts small. Where a strip is lower
// than several heights of a number, the texts get smaller still, so that they fit.
constexpr float kStripText = 0.8F, kMinStripText = 0.5F;
constexpr float kGoodStrip = 3, kMinStrip = 2;
// The smallest part of the height that the contact keeps above its chart: with letters of a given
// size, and with letters that follow the size of the picture.
constexpr double kMinContactPart = 0.35, kMinFreeContactPart = 0.46;
constexpr float kGoodChart = 9;  // height of the chart's frame in heights of a number

constexpr NamedChoices<PictureLayout, 4> kLayouts{{{"contact", PictureLayout::Contact},
                                                   {"curve", PictureLayout::Curve},
                                                   {"both", PictureLayout::Both},
                                                   {"transient", PictureLayout::Transient}}};

}  // namespace

PictureLayout layoutFrom(const std::string& name, const char* key) {
  return chosen(kLayouts, name, key);
}

void checkPanels(const DiagramSheet& sheet, const PictureSettings& settings, int above) {
  if (sheet.diagrams.size() < 2 || settings.isOnPaper) return;  // on paper the height follows
  const int available = settings.height - above;
  DiagramOptions options = settings.diagramOptions();
  options.height = available;
  const int needed = heightForAll(sheet, options);
  if (needed == available) return;
  const std::string given = fmt::format("{}x{}", settings.width, settings.height);
  if (needed == 0)
    throw InputError("", "--size", given + " is too narrow for the curve and the difference");
  const int least = 10 * ((needed * settings.height / available + 19) / 10);
  tellNeededHeight(settings.height, least);
  throw InputError("", "--size",
                   message("{} leaves no room for the difference under the curve; {}x{} does",
                           given, settings.width, least));
}

FigureStyle styleOfPlan(FigureStyle style) {
  style.labels.clear();
  style.curves.clear();
  return style;
}

void checkPlannedPanels(DiagramSheet sheet, const PictureSettings& settings, int above) {
  if (!sheet.diagrams.front().blank.empty()) return;  // of a quantity that is not planned
  DiagramSheet withNotes = sheet;
  withNotes.note = sentences({sheet.note, kFewContactsSentence});
  sheet.note = {};
  try {
    checkPanels(sheet, settings, above);
  } catch (const InputError&) {
    checkPanels(withNotes, settings, above);
    throw;
  }
}

PictureComposer::PictureComposer(const PictureSettings& settings, PictureContent content)
    : settings_(settings), content_(std::move(content)) {
  if (settings_.transparent) settings_.theme.background.a = 0;
}

DrawList PictureComposer::compose(const Frame& frame) {
  const FigureStyle& style = settings_.style;
  Frame renamed;
  if (!style.title.empty() && frame.scene) {
    Scene scene = *frame.scene;
    scene.title = style.title;
    renamed = frame;
    renamed.scene = std::make_shared<const Scene>(std::move(scene));
  }
  DrawList list = composeParts(renamed.scene ? renamed : frame);
  if (style.isGrey) removeColours(list);
  return list;
}

DrawList PictureComposer::composeParts(const Frame& frame) {
  const PictureLayout layout = content_.layout;
  if (layout == PictureLayout::Contact) return contact(frame, settings_.height);
  if (layout == PictureLayout::Curve)
    return composeDiagrams(curveWithMarker(frame), optionsFor(settings_.height, 0));
  const int above = contactHeight(), below = settings_.height - above;
  DiagramOptions options = optionsFor(below, 0);
  options.above = FrameAbove{};
  DiagramSheet sheet;
  if (layout == PictureLayout::Transient) {
    const auto samples = frame.transient ? *frame.transient : std::vector<TransientSample>{};
    sheet = withoutCrowding(
        styled(transientSheet(*frame.scene, samples, frame.spacing, frame.length), settings_.style),
        optionsFor(below, kStripText));
    options.minTextSize = stripText(sheet, below);
  } else if (below_ && !frame.transient) {
    return stacked(contact(frame, above), *below_);
  } else {
    sheet = curveWithMarker(frame);
    sheet.title = {};  // the title is drawn above the contact
    if (!hasNote_) sheet.note = {};
    options.above->unit = contactUnit(contactOptions(above));
  }
  plotLeft_ = 0;
  setContact(frame, above);
  const Box area = contactPlotArea(frame, contact_);
  options.above->left = area.x;
  options.above->right = area.x + area.width;
  // The numbers of the chart may need more space than those of the contact.
  plotLeft_ = static_cast<float>(diagramFrames(sheet, options).front().area.left());
  options.above->left = plotLeft_;
  DrawList diagram = composeDiagrams(sheet, options);
  if (layout == PictureLayout::Both) below_ = diagram;
  return stacked(contact(frame, above), std::move(diagram));
}

int PictureComposer::contactHeight() const {
  if (above_) return *above_;
  const bool hasDifference = content_.layout == PictureLayout::Both && content_.curves.difference;
  return static_cast<int>(
      std::lround((hasDifference ? kContactPartOfThree : kContactPart) * settings_.height));
}

float PictureComposer::stripText(const DiagramSheet& strips, int height) const {
  float text = kStripText;
  while (text > kMinStripText && lowestFrame(strips, optionsFor(height, text)) < kGoodStrip)
    text -= 0.1F;
  return std::max(text, kMinStripText);
}

void PictureComposer::checkStrips(const Scene& scene) {
  if (content_.layout != PictureLayout::Transient) return;
  if (settings_.isOnPaper) return growFor(styled(transientSheet(scene, {}, 0, 0), settings_.style));
  const auto fits = [&](int height) {
    const DiagramSheet strips =
        withoutCrowding(transientSheet(scene, {}, 0, 0), optionsFor(height, kStripText));
    return lowestFrame(strips, optionsFor(height, stripText(strips, height))) >= kMinStrip;
  };
  int height = settings_.height - contactHeight();
  if (fits(height)) return;
  constexpr int kHighest = 20000, kStep = 10;
  while (height < kHighest && !fits(height)) height += kStep;
  const std::string given = fmt::format("{}x{}", settings_.width, settings_.height);
  if (height >= kHighest)
    throw InputError("", "--size", given + " is too narrow for strips over time");
  const int least = kStep * (static_cast<int>(height / (1 - kContactPart)) / kStep + 1);
  tellNeededHeight(settings_.height, least);
  throw InputError("", "--size",
                   message("{} leaves no room for the strips over time; {}x{} does", given,
                           settings_.width, least));
}

DiagramSheet PictureComposer::sheetOfCurves(const FigureStyle& style) const {
  DiagramSheet sheet = styled(curveSheet(content_.curves), style);
  if (content_.layout == PictureLayout::Both) sheet.title = {};
  return sheet;
}

void PictureComposer::checkPlanned() const {
  const int above = content_.layout == PictureLayout::Both ? contactHeight() : 0;
  checkPlannedPanels(sheetOfCurves(styleOfPlan(settings_.style)), settings_, above);
}

void PictureComposer::fitHeight(const Scene& scene) {
  checkStrips(scene);
  if (!showsCurve(content_.layout)) return;
  DiagramSheet sheet = sheetOfCurves(settings_.style);
  const int above = content_.layout == PictureLayout::Both ? contactHeight() : 0;
  checkPanels(sheet, settings_, above);
  if (!settings_.isOnPaper && above == 0) return;
  // The marker comes with the frame; its entry in the legend and its label are included in the
  // layout now.
  if (const auto& points = content_.curves.present.points;
      settings_.style.hasMarker && !points.empty()) {
    const CurvePoint& middle = points[points.size() / 2];
    DiagramMarker marker{"this motion, now", message("v = {} m/s", middle.velocity)};
    marker.x = middle.velocity;
    marker.y = middle.mu;
    sheet.diagrams.front().marker = std::move(marker);
  }
  if (settings_.isOnPaper || settings_.format.fontSize > 0)
    growFor(sheet);
  else
    shareHeight(std::move(sheet));
}

void PictureComposer::shareHeight(DiagramSheet sheet) {
  if (sheet.diagrams.size() > 1) return;
  const int most = contactHeight();
  const int least = static_cast<int>(std::lround(kMinFreeContactPart * settings_.height));
  const auto isGood = [&](int above) {
    DiagramOptions options = optionsFor(settings_.height - above, 0);
    options.above = FrameAbove{0, 0, contactUnit(contactOptions(above))};
    return isWhole(sheet, options) && lowestFrame(sheet, options) >= kGoodChart;
  };
  for (const bool hasNote : {true, false}) {
    if (!hasNote) sheet.note = {};
    hasNote_ = hasNote;
    constexpr int kStep = 4;
    for (int above = most; above >= least; above -= kStep) {
      above_ = above;
      if (isGood(above)) return;
    }
  }
}

void PictureComposer::growFor(const DiagramSheet& sheet) {
  const int above = content_.layout == PictureLayout::Curve ? 0 : contactHeight();
  DiagramOptions options = optionsFor(settings_.height - above, 0);
  if (above > 0) options.above = FrameAbove{};
  const int needed = heightInPrint(sheet, options);
  if (!settings_.isOnPaper) {  // the size is that of a screen
    const int least = static_cast<int>(std::lround(kMinContactPart * settings_.height));
    above_ = std::clamp(settings_.height - needed, std::min(least, above), above);
    return;
  }
  settings_.height = above + needed;
  if (above > 0) above_ = above;  // the contact does not grow with its chart
}

ContactPictureOptions PictureComposer::contactOptions(int height) const {
  ContactPictureOptions options;
  options.width = settings_.width;
  options.height = height;
  options.scale = settings_.scale;
  options.theme = settings_.theme;
  options.overlay = content_.overlay;
  options.fontSize = settings_.format.fontSize;
  options.lineWidth = settings_.format.lineWidth;
  options.title = settings_.style.hasTitle;
  options.plotLeft = plotLeft_;
  return options;
}

void PictureComposer::setContact(const Frame& frame, int height) {
  contact_ = contactOptions(height);
  view_ = fittedView(frame, view_);
  contact_.view = *view_;
  applyView(content_.view, frame, content_.isFilm, contact_);
}

DrawList PictureComposer::contact(const Frame& frame, int height) {
  setContact(frame, height);
  return composeContact(frame, contact_);
}

DiagramOptions PictureComposer::optionsFor(int height, float minTextSize) const {
  DiagramOptions options = settings_.diagramOptions(minTextSize);
  options.height = height;
  return options;
}

/// Returns the curve with the line, the marker at the frame's velocity, and the trace of a motion.
DiagramSheet PictureComposer::curveWithMarker(const Frame& frame) const {
  DiagramSheet sheet = styled(curveSheet(content_.curves), settings_.style);
  if (settings_.style.hasMarker)
    sheet.diagrams.front().marker = frameMarker(frame, content_.curves.axes, content_.curves.y);
  return sheet;
}

}  // namespace asperity
