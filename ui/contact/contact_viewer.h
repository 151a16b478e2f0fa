// How somebody looks at the contact: the place zoomed to, the crosshair, the magnifier, the
// colours. Frames go in, the options of their pictures come out. Knows no widget: places come as
// shares of the plot. One thread at a time.
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
  /// Heights and colours stay fitted and steady from frame to frame; a line of another length is
  /// shown as a whole.
  void setFrame(std::shared_ptr<const Frame> frame);
  const std::shared_ptr<const Frame>& frame() const { return frame_; }

  /// Of a picture of the frame, but for size, scale and theme; there has to be a frame.
  ContactPictureOptions options() const;

  /// What frames have to hold for it.
  FrameFields fields() const;

  const ViewNavigation& navigation() const { return navigation_; }
  /// One step of zoom: enlarges along, and heights by less, as a self-affine line looks the same at
  /// every scale where heights grow with length to the power H.
  void zoom(const ViewPlace& at, double steps);
  void exaggerate(const ViewPlace& at, double steps);
  void pan(double along, double up);
  void fit();
  void fitHeights();
  void follow(bool follows);

  /// The crosshair under a cursor at that place, or none.
  void pointAt(std::optional<ViewPlace> place);
  /// By so many elements, from where it is or from the middle; it then belongs to its element.
  void movePointer(int elements);
  /// Where the crosshair is, in m; none without one.
  std::optional<double> pointer() const;
  std::optional<ProbeReading> reading() const;

  /// Around the crosshair, else around the asperity pressed most.
  void magnify(bool magnifies);
  bool magnifies() const { return magnifies_; }

  void setOverlay(ContactOverlay overlay) { overlay_ = overlay; }
  ContactOverlay overlay() const { return overlay_; }

 private:
  ContactView view() const;
  double finest() const;
  void followPeak(const Frame* last);

  std::shared_ptr<const Frame> frame_;
  std::optional<ContactView> fitted_;
  ViewNavigation navigation_;
  std::optional<ViewPlace> cursor_;  // of the crosshair, or
  std::optional<double> element_;    // m, the element it was moved to
  double peak_ = 0;                  // m, the asperity last found pressed most
  bool magnifies_ = false;
  ContactOverlay overlay_ = ContactOverlay::Pressure;
};

}  // namespace asperity
