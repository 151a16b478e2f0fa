// What a user says about pictures: size, density, theme, library, the same options at every verb
// that draws; and where to look in a contact: the part along and up, the end of the colours, the
// crosshair, the magnifier. Main thread; applying the view on any thread.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/run/frame.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/pixel_context.h"

namespace CLI {
class App;
}

namespace asperity {

/// As written on the command line.
struct PictureArguments {
  std::string size;     // WxH in pixels; empty: the verb's own at this scale
  std::string scale;    // empty: 1
  std::string theme;    // empty: the verb's own
  std::string backend;  // empty: auto
  bool transparent = false;
};

/// Read and found good.
struct PictureSettings {
  int width = 0, height = 0;  // pixels
  float scale = 1;            // pixels to one at 96 per inch
  std::string themeName;
  Theme theme;
  bool transparent = false;
  PixelBackend backend = PixelBackend::Automatic;

  /// What of it changes a picture, for its provenance.
  nlohmann::ordered_json json() const;
};

struct PictureDefaults {
  int width, height;  // at scale 1
  std::string theme;
};

void addPictureOptions(CLI::App& verb, PictureArguments& arguments, const std::string& defaultSize,
                       const std::string& defaultTheme);

/// Throws InputError where an option is given that none of the files has a use for.
void checkUseful(const PictureArguments& arguments, const std::vector<std::string>& files);

/// The language of all texts from now on. Throws InputError naming --language.
void chooseLanguage(const std::string& code);

/// Throws InputError naming the option.
PictureSettings pictureSettings(const PictureArguments& arguments, const PictureDefaults& defaults);

/// As written on the command line; empty: not said, and fitted to the scene.
struct ViewArguments {
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

void addViewOptions(CLI::App& verb, ViewArguments& arguments);

/// Throws InputError naming the option where it cannot be meant so. length: of the period, m.
void checkView(const ViewArguments& arguments, ContactOverlay overlay, double length);

/// Into options that have everything else; their view is fitted to the frame where nothing is said.
void applyView(const ViewArguments& arguments, const Frame& frame, ContactPictureOptions& options);

}  // namespace asperity
