// What a user says about pictures: size, density, colours, library; the same options at every verb
// that draws. Main thread.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ui/contact/contact_picture.h"
#include "ui/draw/pixel_context.h"

namespace CLI {
class App;
}

namespace asperity {

/// As written on the command line.
struct PictureChoice {
  std::string size;     // WxH in pixels; empty: the verb's own at this scale
  std::string scale;    // empty: 1
  std::string theme;    // empty: the verb's own
  std::string backend;  // empty: auto
  bool transparent = false;
};

/// Read and found good.
struct PictureStyle {
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

void addPictureOptions(CLI::App& verb, PictureChoice& choice, const std::string& defaultSize,
                       const std::string& defaultTheme);

/// Throws InputError where an option is given that none of the files has a use for.
void checkUseful(const PictureChoice& choice, const std::vector<std::string>& files);

/// The language of all texts from now on. Throws InputError naming --language.
void chooseLanguage(const std::string& code);

/// Throws InputError naming the option.
PictureStyle styleOf(const PictureChoice& choice, const PictureDefaults& defaults);

}  // namespace asperity
