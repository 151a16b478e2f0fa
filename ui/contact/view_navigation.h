// Where somebody looks in a contact picture: zoomed and moved, relative to the view that fits. As
// shares of the period and of the fitted heights, so that another scene, or a force ten times as
// great, never leaves the place chosen outside of everything. A plain value; every change gives
// another one, within limits. Pure; any thread.
#pragma once

#include "ui/contact/contact_picture.h"

namespace asperity {

/// A place in the plot as shares of it: 0, 0 is its left lower corner, 1, 1 its right upper one.
struct ViewPlace {
  double along = 0.5, up = 0.5;
};

class ViewNavigation {
 public:
  /// Shows everything.
  ViewNavigation() = default;

  /// What `fitted` (heights and colours from fittedView) becomes: period in m, distance of the line
  /// in m, which is followed where that is chosen.
  ContactView applied(const ContactView& fitted, double period, double distance) const;

  /// What is seen at that place stays there; factors above 1 enlarge. finest: the narrowest view,
  /// as a share of the period.
  ViewNavigation zoomed(const ViewPlace& at, double along, double up, double finest) const;
  /// The contents move by these shares of the plot. Along, the period goes on and on.
  ViewNavigation panned(double along, double up) const;
  /// The same view with the line or with the elastomer standing still; nothing jumps.
  ViewNavigation following(bool follows, double period, double distance) const;
  /// The whole period, fitted; follows as before.
  ViewNavigation fitted() const;
  /// Heights fitted again, the view along as it is.
  ViewNavigation withFittedHeights() const;

  bool followsLine() const { return follows_; }
  bool isFitted() const { return left_ == 0 && width_ == 1 && isFittedUp(); }
  bool isFittedUp() const { return bottom_ == 0 && top_ == 1; }
  double enlargement() const { return 1 / width_; }

  bool operator==(const ViewNavigation&) const = default;

 private:
  ViewNavigation within(double finest) const;

  double left_ = 0, width_ = 1;  // of the period; left in [0, 1)
  double bottom_ = 0, top_ = 1;  // of the fitted heights
  bool follows_ = false;         // left is measured on the line
};

}  // namespace asperity
