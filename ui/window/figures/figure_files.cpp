#include "ui/window/figures/figure_files.h"

#include <initializer_list>
#include <string>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/provenance.h"
#include "ui/chart/figure_drawing.h"
#include "ui/draw/picture_origin.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/window/main/picture_files.h"

namespace asperity {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const char* known) {
  throw InputError(file.string(), "", "'" + file.extension().string() + "' is not one of " + known);
}

/// As asperity figure says it, so that the file opens as its scene.
std::string originOf(const Figure& figure) {
  return pictureOrigin("figure", figure.scene);
}

}  // namespace

QString figureFile(FigureName name, const QString& extension) {
  return "figure_" + fromUtf8(entryOf(name).word) + extension;
}

void writeFigurePicture(const std::filesystem::path& file, const MadeFigure& made) {
  const Figure& figure = made.figure;
  writePicture(file, composeFigure(figure, made.contact.get(), printOptions(figure.sheet)),
               {translated(figure.sheet.title), originOf(figure)});
}

void writeFigureData(const std::filesystem::path& file, const MadeFigure& made) {
  const std::string extension = file.extension().string();
  if (extension == ".csv")
    writeFileAtomically(file, provenanceComment("figure", made.figure.scene) + made.figure.csv);
  else if (extension == ".json")
    writeFileAtomically(file, claimsJson({&made.figure, 1}));
  else
    refuse(file, ".csv, .json");
}

}  // namespace asperity
