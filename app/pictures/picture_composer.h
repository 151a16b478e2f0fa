// Composes a frame in the requested layout: the contact, the friction curve, both, or the contact
// above strips over time. Immutable once made, except for the view, which is kept steady from frame
// to frame; one thread at a time.
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
inline bool showsCurve(PictureLayout layout) {
  return layout == PictureLayout::Curve || layout == PictureLayout::Both;
}

/// Returns the layout of this name. Throws InputError naming the key or the option.
PictureLayout layoutFrom(const std::string& name, const char* key = "--layout");

/// Throws InputError naming --size where several diagrams on a sheet would not fit below `above`
/// pixels of other content; those pixels grow with the picture.
void checkPanels(const DiagramSheet& sheet, const PictureSettings& settings, int above);

/// Returns the style of a sheet whose curves are planned and not yet computed (plannedCurveSet).
/// Such a sheet lacks curves and panels, so labels and styles of single curves are left out.
FigureStyle styleOfPlan(FigureStyle style);

/// Does checkPanels for a planned sheet, in which the notes below the diagrams are not known: it
/// refuses what has no room even without notes, and names a size that has room for them.
void checkPlannedPanels(DiagramSheet sheet, const PictureSettings& settings, int above);

struct PictureContent {
  PictureLayout layout = PictureLayout::Contact;
  CurveSet curves{};  // the scene's own curve and others, for layouts that show them
  ContactOverlay overlay = ContactOverlay::Pressure;
  ViewArguments view{};
  bool isFilm = false;  // several pictures of a line that moves
};

class PictureComposer {
 public:
  PictureComposer(const PictureSettings& settings, PictureContent content);

  /// Makes a picture on paper as high as the panels of its curve, or the strips over time of this
  /// scene, need. Throws InputError naming --size where they do not fit into a picture in pixels.
  void fitHeight(const Scene& scene);

  /// Does checkPlannedPanels for curves that are planned and not yet computed.
  void checkPlanned() const;

  DrawList compose(const Frame& frame);

 private:
  DiagramSheet sheetOfCurves(const FigureStyle& style) const;
  DrawList composeParts(const Frame& frame);
  int contactHeight() const;  // pixels, where a diagram is below it
  /// Sets the options of the contact in a picture of this frame.
  void setContact(const Frame& frame, int height);
  DrawList contact(const Frame& frame, int height);
  ContactPictureOptions contactOptions(int height) const;
  DiagramOptions optionsFor(int height, float minTextSize) const;
  float stripText(const DiagramSheet& strips, int height) const;
  void checkStrips(const Scene& scene);
  /// Makes a picture on paper as high as the sheet of its chart needs. In a picture in pixels the
  /// contact leaves the chart more of the height.
  void growFor(const DiagramSheet& sheet);
  /// Divides the height of a picture in pixels between the contact and its chart, so that the chart
  /// can be read. Leaves out the note under a chart that is too low even then.
  void shareHeight(DiagramSheet sheet);
  DiagramSheet curveWithMarker(const Frame& frame) const;

  PictureSettings settings_;
  PictureContent content_;
  std::optional<ContactView> view_;
  ContactPictureOptions contact_;  // options of the last frame
  float plotLeft_ = 0;             // least left edge of its axes: that of the chart below
  std::optional<int> above_;       // height of the contact, where its chart has grown
  bool hasNote_ = true;            // the chart below the contact has its note
  std::optional<DrawList> below_;  // the curve, which does not change in steady sliding
};

}  // namespace asperity
