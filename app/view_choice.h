// What a user says about where to look in a contact picture: the part along and up, the end of the
// colours, the crosshair, the magnifier. Main thread; applying it any thread.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/run/frame.h"
#include "ui/contact/contact_picture.h"

namespace CLI {
class App;
}

namespace asperity {

/// As written on the command line; empty: not said, and fitted to the scene.
struct ViewChoice {
  std::string along;                   // FROM:TO, m
  std::string heights;                 // FROM:TO, m
  std::optional<double> exaggeration;  // of heights against lengths
  std::optional<double> coloursTo;     // N/m, s or W/m, after the overlay
  std::optional<double> probe;         // m
  std::optional<double> magnified;     // m

  /// One that is said; null where none is.
  const char* firstOption() const;
  /// m, of the line that is shown; 0: one period.
  double width() const;
  /// m, in which a picture has its details: less where one place is read.
  double finest() const;
  /// What frames have to hold for a picture with that overlay.
  FrameFields fields(ContactOverlay overlay) const;
  /// What of it changes a picture, for its provenance; keys are added to `picture`.
  void addTo(nlohmann::ordered_json& picture) const;
};

void addViewOptions(CLI::App& verb, ViewChoice& choice);

/// Throws InputError naming the option where it cannot be meant so. length: of the period, m.
void checkView(const ViewChoice& choice, ContactOverlay overlay, double length);

/// Into options that have everything else; their view is fitted to the frame where nothing is said.
void applyView(const ViewChoice& choice, const Frame& frame, ContactPictureOptions& options);

}  // namespace asperity
