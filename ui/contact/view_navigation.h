// The zoomed and moved view of a contact picture, relative to the view that fits. It is stored in
// parts of the period and of the fitted heights, so that it stays useful for another scene, or a
// force ten times as great. A plain value; every change gives another one, within limits. Pure; any
// thread.
#pragma once

#include <string>

#include "ui/contact/contact_picture.h"

namespace asperity {

/// A position in the plot, relative to its size: 0, 0 is its lower left corner, 1, 1 its upper
/// right one.
struct ViewPosition {
  double x = 0.5, y = 0.5;
};

class ViewNavigation {
 public:
  /// Makes a view that shows everything.
  ViewNavigation() = default;
  /// Returns the view that a text of toText() describes; a view that shows everything where the
  /// text is none.
  static ViewNavigation fromText(const std::string& text);
  std::string toText() const;

  /// Returns the view made from `fitted` (heights and colours from fittedView): period in m,
  /// distance of the line in m, which the view follows if that is chosen.
  ContactView applied(const ContactView& fitted, double period, double distance) const;

  /// Zooms about a position, which stays fixed; factors above 1 enlarge. finest: the narrowest
  /// view, as a part of the period.
  ViewNavigation zoomed(const ViewPosition& at, double xFactor, double yFactor,
                        double finest) const;
  /// Moves the contents by these parts of the plot. In x, the line continues periodically.
  ViewNavigation panned(double dx, double dy) const;
  /// Returns the same view, fixed to the line or to the elastomer; nothing jumps.
  ViewNavigation following(bool follows, double period, double distance) const;
  /// Returns the whole period, fitted; following is unchanged.
  ViewNavigation fitted() const;
  /// Returns the view with fitted heights and the same x-range.
  ViewNavigation withFittedHeights() const;

  bool followsLine() const { return follows_; }
  bool isFitted() const { return left_ == 0 && width_ == 1 && hasFittedHeights(); }
  bool hasFittedHeights() const { return bottom_ == 0 && top_ == 1; }
  double enlargement() const { return 1 / width_; }

  bool operator==(const ViewNavigation&) const = default;

 private:
  ViewNavigation within(double finest) const;

  double left_ = 0, width_ = 1;  // in periods; left in [0, 1)
  double bottom_ = 0, top_ = 1;  // in fitted heights
  bool follows_ = false;         // left is measured on the line
};

}  // namespace asperity
