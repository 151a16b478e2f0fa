// A frame as a picture in the layout asked for: the contact, the friction curve, both, or the
// contact above strips over time. Immutable once made but for the view, which is kept steady from
// frame to frame; one thread at a time.
#pragma once

#include <optional>
#include <string>

#include "app/picture_options.h"
#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"
#include "core/run/frame.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_picture.h"

namespace asperity {

enum class PictureLayout { Contact, Curve, Both, Transient };

/// Throws InputError naming the key, or the option.
PictureLayout layoutFrom(const std::string& name, const char* key = "--layout");

/// Throws InputError naming --overlay.
ContactOverlay overlayFrom(const std::string& name);

/// Throws InputError naming --size where not all of several diagrams on a sheet would find room
/// under so many pixels of something else; those pixels grow with the picture.
void checkPanels(const DiagramSheet& sheet, const PictureSettings& settings, int above);

struct PictureContent {
  PictureLayout layout = PictureLayout::Contact;
  CurveSet curves{};  // the scene's own and others, for the layouts that show them
  ContactOverlay overlay = ContactOverlay::Pressure;
  ViewArguments view{};
};

class PictureComposer {
 public:
  PictureComposer(const PictureSettings& settings, PictureContent content);

  /// Throws InputError naming --size where a panel of the curve, or a strip over time of this
  /// scene, would find no room.
  void checkRoom(const Scene& scene) const;

  DrawList compose(const Frame& frame);

 private:
  int contactHeight() const;  // pixels, above a diagram
  DrawList contact(const Frame& frame, int height);
  ContactPictureOptions contactOptions(int height) const;
  DiagramOptions optionsFor(int height, float leastText) const;
  float stripText(const DiagramSheet& strips, int height) const;
  void checkStrips(const Scene& scene) const;
  DiagramSheet curveWithMarker(const Frame& frame) const;

  PictureSettings settings_;
  PictureContent content_;
  std::optional<ContactView> view_;
  ContactPictureOptions contact_;  // of the last one
  std::optional<DrawList> below_;  // the curve, which stands still in steady sliding
};

}  // namespace asperity
