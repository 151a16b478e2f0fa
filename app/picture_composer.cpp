#include "app/picture_composer.h"

#include <cmath>

#include "app/named_choice.h"
#include "core/friction/curve_diagram.h"
#include "core/run/transient_diagram.h"
#include "ui/language/words.h"
#include "ui/picture/contact_overlay.h"
#include "ui/picture/diagram_picture.h"
#include "ui/picture/stacked.h"

namespace asperity {
namespace {

constexpr double kContactPart = 0.54;  // of the height, where a diagram stands below

constexpr float kStripText = 0.8F;  // strips are low, which would make their texts small

constexpr NamedChoices<PictureLayout, 4> kLayouts{{{"contact", PictureLayout::Contact},
                                                   {"curve", PictureLayout::Curve},
                                                   {"both", PictureLayout::Both},
                                                   {"transient", PictureLayout::Transient}}};

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

PictureComposer::PictureComposer(const PictureStyle& style, PictureLayout layout,
                                 std::vector<CurvePoint> curve, ContactOverlay overlay)
    : style_(style), layout_(layout), overlay_(overlay), curve_(std::move(curve)) {
  if (style_.transparent) style_.theme.background.a = 0;
}

DrawList PictureComposer::compose(const Frame& frame) {
  if (layout_ == PictureLayout::Contact) return contact(frame, style_.height);
  if (layout_ == PictureLayout::Curve) return diagram(curveWithPresent(frame), style_.height);
  const int above = static_cast<int>(std::lround(kContactPart * style_.height));
  if (layout_ == PictureLayout::Both) {
    if (!below_) {
      DiagramSheet sheet = curveWithPresent(frame);
      sheet.title.clear();  // it stands above
      below_ = diagram(sheet, style_.height - above);
    }
    return stacked(contact(frame, above), *below_);
  }
  const auto samples = frame.transient ? *frame.transient : std::vector<TransientSample>{};
  return stacked(contact(frame, above),
                 diagram(transientSheet(*frame.scene, samples, frame.spacing, frame.length),
                         style_.height - above, kStripText));
}

DrawList PictureComposer::contact(const Frame& frame, int height) {
  ContactPictureOptions options;
  options.width = style_.width;
  options.height = height;
  options.scale = style_.scale;
  options.theme = style_.theme;
  options.overlay = overlay_;
  view_ = fittedView(frame, view_);
  options.view = *view_;
  return composeContact(frame, options);
}

DrawList PictureComposer::diagram(const DiagramSheet& sheet, int height, float leastText) const {
  DiagramOptions options;
  options.width = style_.width;
  options.height = height;
  options.scale = style_.scale;
  options.theme = style_.theme;
  options.leastText = leastText;
  return composeDiagrams(sheet, options);
}

/// The curve and on it the line and the velocity of the frame.
DiagramSheet PictureComposer::curveWithPresent(const Frame& frame) const {
  DiagramSheet sheet = curveSheet(*frame.scene, curve_);
  DiagramSeries present;
  present.name = Words::tr("the line shown, at its velocity");
  present.mark = SeriesMark::Diamond;
  present.stroke = SeriesStroke::None;
  present.colour = 1;  // told from the means, in front of which it may stand
  present.points = {{frame.scene->sliding.velocity, frame.muSteady}};
  sheet.diagrams.front().series.push_back(std::move(present));
  return sheet;
}

}  // namespace asperity
