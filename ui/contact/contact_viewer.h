// The user's view of the contact: the zoomed part, the crosshair, the magnifier, the colours. It
// takes frames and returns the options of their pictures. It uses no widget: positions are relative
// to the plot. One thread at a time.
#pragma once

#include <memory>
#include <optional>

#include "core/run/frame.h"
#include "ui/contact/contact_overlay.h"
#include "ui/contact/contact_probe.h"
#include "ui/contact/view_navigation.h"

namespace asperity {

class ContactViewer {
 public:
  static constexpr double kZoomStep = 1.25;  // enlargement by one step

  /// Sets the frame. Heights and colours stay fitted and steady from frame to frame; a line of
  /// another length is shown as a whole.
  void setFrame(std::shared_ptr<const Frame> frame);
  const std::shared_ptr<const Frame>& frame() const { return frame_; }

  /// Keeps at least this part of the plot above the line free for labels, from labelSpace().
  void setLabelSpace(double part);

  /// Returns the options of the frame's picture without size, scale and theme; there must be a
  /// frame.
  ContactPictureOptions options() const;

  /// Returns the optional values that frames need for it.
  FrameFields fields() const;

  const ViewNavigation& navigation() const { return navigation_; }
  /// Sets the view, as it was in an earlier run of the program.
  void setNavigation(const ViewNavigation& navigation) { navigation_ = navigation; }
  /// Zooms by steps. One step enlarges x, and heights by less: a self-affine line has the same
  /// appearance at every scale if heights grow with length to the power H.
  void zoom(const ViewPosition& at, double steps);
  void exaggerate(const ViewPosition& at, double steps);
  void pan(double dx, double dy);
  void fit();
  void fitHeights();
  void follow(bool follows);

  /// Sets the crosshair to the position of a cursor, or removes it.
  void pointAt(std::optional<ViewPosition> position);
  /// Moves the crosshair by this many elements, from its position or the middle; it then stays on
  /// its element.
  void movePointer(int elements);
  /// Returns the position of the crosshair, m; none without one.
  std::optional<double> pointer() const;
  std::optional<ProbeReading> reading() const;

  /// Switches the magnifier, around the crosshair or, without one, around the asperity with the
  /// greatest pressure.
  void magnify(bool magnifies);
  bool magnifies() const { return magnifies_; }

  void setOverlay(ContactOverlay overlay) { overlay_ = overlay; }
  ContactOverlay overlay() const { return overlay_; }

 private:
  ContactView view() const;
  double finest() const;
  void fitHeightsToFrame();
  void navigate(const ViewNavigation& navigation);
  void followPeak(const Frame* last);
  double magnified(const ContactView& seen) const;

  std::shared_ptr<const Frame> frame_;
  std::optional<ContactView> fitted_;
  ViewNavigation navigation_;
  std::optional<ViewPosition> cursor_;  // of the crosshair, or
  std::optional<double> element_;       // m, the element to which it was moved
  double peak_ = 0;                     // m, the asperity with the greatest pressure at last
  bool magnifies_ = false;
  ContactOverlay overlay_ = ContactOverlay::Pressure;
  double labelSpace_ = 0;  // part of the plot's height
};

}  // namespace asperity
