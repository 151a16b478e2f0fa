// Command-line options for pictures: size, density, theme and library, which are the same for every
// command that draws; and for the view of a contact: ranges in x and height, the maximum of the
// colour scale, the crosshair, the magnifier. Main thread; a view can be applied on any thread.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/chart/figure_style.h"
#include "core/run/frame.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/pixel_context.h"

namespace CLI {
class App;
}

namespace asperity {

/// What a command draws where no option says otherwise.
struct PictureDefaults {
  int width = 0, height = 0;  // at scale 1
  std::string theme{};
  float scale = 1;     // where neither option nor style gives a density
  std::string size{};  // in the help, where it depends on what is drawn: "that of the figure"
};

/// The options as text from the command line.
struct PictureArguments {
  PictureDefaults defaults;
  std::string size;     // WxH in pixels; empty: the command's default at this scale
  std::string scale;    // empty: 1
  std::string theme;    // empty: the command's default
  std::string backend;  // empty: auto
  std::string style;    // shipped name or file; empty: none
  bool transparent = false;
  std::vector<std::pair<std::string, std::string>> figure;  // word and value of figureOptions()
};

/// The options after reading and checking.
struct PictureSettings {
  int width = 0, height = 0;  // pixels
  float scale = 1;            // pixels of the picture to one pixel at 96 per inch
  std::string themeName;
  Theme theme;
  bool transparent = false;
  PixelBackend backend = PixelBackend::Automatic;
  FigureStyle style;       // what the picture contains
  DiagramFormat format;    // sizes of its texts and lines, in pixels
  bool isOnPaper = false;  // its size was given as lengths

  /// Returns the size, density and format of charts. minTextSize: as in DiagramOptions.
  DiagramOptions diagramOptions(float minTextSize = 0) const;
  /// Returns what a file of such a picture keeps.
  PictureProperties properties(const std::string& title, const std::string& origin) const;

  /// Returns the settings that change a picture, for its provenance.
  nlohmann::ordered_json json() const;
};

/// Adds the options of pictures and, by `most`, those of charts and of friction curves, except
/// those that the command already has in another form. The arguments keep the defaults.
void addPictureOptions(CLI::App& command, PictureArguments& arguments, PictureDefaults defaults,
                       FigurePart most = FigurePart::Picture);

/// Throws InputError where an option of charts is given, with this reason.
void refuseChartOptions(const PictureArguments& arguments, const Message& why);

/// Returns the defaults of a printed sheet (printOptions of ui/chart).
PictureDefaults printDefaults(const DiagramSheet& sheet);

/// Draws a sheet in the style of the settings. Throws InputError where the style names what the
/// sheet does not have.
DrawList drawSheet(const DiagramSheet& sheet, const PictureSettings& settings,
                   float minTextSize = 0);

/// Throws InputError where an option is given that applies to none of the files.
void checkUseful(const PictureArguments& arguments, const std::vector<std::string>& files);

/// Sets the language of all later texts. Throws InputError naming --language.
void chooseLanguage(const std::string& code);

/// Reads and checks the options. defaults: of a picture that differs from others of the command.
/// Throws InputError naming the option.
PictureSettings pictureSettings(const PictureArguments& arguments, const PictureDefaults& defaults);
inline PictureSettings pictureSettings(const PictureArguments& arguments) {
  return pictureSettings(arguments, arguments.defaults);
}

/// The options from the command line. An empty one is not given, and is fitted to the scene.
struct ViewArguments {
  std::string xRange;                  // FROM:TO, m
  std::string heights;                 // FROM:TO, m
  std::optional<double> exaggeration;  // factor of heights relative to lengths
  std::optional<double> coloursTo;     // N/m, s or W/m, depending on the overlay
  std::optional<double> probe;         // m
  std::optional<double> magnified;     // m

  /// Returns the name of an option that is given; null where none is.
  const char* firstOption() const;
  /// Returns the length of the line that is shown, m; 0: one period.
  double width() const;
  /// Returns the length that a picture must resolve, m: a smaller one where a crosshair reads one
  /// position.
  double finest() const;
  /// Returns the optional values that frames need for a picture with this overlay.
  FrameFields fields(ContactOverlay overlay) const;
  /// Adds the options that change a picture to `picture`, for its provenance.
  void addTo(nlohmann::ordered_json& picture) const;
};

void addViewOptions(CLI::App& command, ViewArguments& arguments);

/// Throws InputError naming an option that makes no sense here. length: of the period, m.
void checkView(const ViewArguments& arguments, ContactOverlay overlay, double length);

/// Applies the view to options that are otherwise complete. Parts that are not given are fitted to
/// the frame; the heights to the part that is shown, or in a film to all that will pass by.
void applyView(const ViewArguments& arguments, const Frame& frame, bool isFilm,
               ContactPictureOptions& options);

}  // namespace asperity
