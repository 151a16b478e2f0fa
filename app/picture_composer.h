// A frame as a picture in the layout asked for: the contact, the friction curve, both, or the
// contact above strips over time. Immutable once made but for the view, which is kept steady from
// frame to frame; one thread at a time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/picture_choice.h"
#include "core/friction/curve_point.h"
#include "core/friction/diagram.h"
#include "core/run/frame.h"

namespace asperity {

enum class PictureLayout { Contact, Curve, Both, Transient };

/// Throws InputError naming the key, or the option.
PictureLayout layoutFrom(const std::string& name, const char* key = "--layout");

/// Throws InputError naming --overlay.
ContactOverlay overlayFrom(const std::string& name);

class PictureComposer {
 public:
  /// `curve`: of the scene, for the layouts that show it.
  PictureComposer(const PictureStyle& style, PictureLayout layout, std::vector<CurvePoint> curve,
                  ContactOverlay overlay = ContactOverlay::Pressure);

  DrawList compose(const Frame& frame);

 private:
  DrawList contact(const Frame& frame, int height);
  DrawList diagram(const DiagramSheet& sheet, int height, float leastText = 0) const;
  DiagramSheet curveWithPresent(const Frame& frame) const;

  PictureStyle style_;
  PictureLayout layout_;
  ContactOverlay overlay_;
  std::vector<CurvePoint> curve_;
  std::optional<ContactView> view_;
  std::optional<DrawList> below_;  // the curve, which stands still
};

}  // namespace asperity
