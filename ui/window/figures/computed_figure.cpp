#include "ui/window/figures/computed_figure.h"

#include <algorithm>
#include <string>
#include <thread>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/provenance.h"
#include "ui/chart/figure_drawing.h"
#include "ui/draw/png_file.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/window/main/picture_files.h"

namespace asperity {

std::shared_ptr<const ComputedFigure> computeFigure(const BackgroundWork::Run& run,
                                                    const FigureMaker& maker, FigureName name,
                                                    std::int64_t realizations,
                                                    const std::function<void(double)>& progressed) {
  FigureOptions options;
  options.realizations = realizations;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  options.stop = run.stop();
  options.progress = [&run, progressed, lastStep = -1](double part) mutable {
    const int step = static_cast<int>(std::clamp(part, 0.0, 1.0) * 1000);
    if (step == lastStep) return;
    lastStep = step;
    run.post([progressed, step] { progressed(step / 1000.0); });
  };
  ComputedFigure made{maker(name, options), realizations, nullptr};
  made.contact = contactFrame(made.figure);
  return std::make_shared<const ComputedFigure>(std::move(made));
}

namespace {

/// Returns the provenance that `asperity figure` writes, so that the file opens as its scene.
std::string originOf(const Figure& figure) {
  return pictureOrigin("figure", figure.scene);
}

}  // namespace

QString figureFile(FigureName name, const QString& extension) {
  return "figure_" + fromUtf8(figureEntry(name).word) + extension;
}

void writeFigurePicture(const std::filesystem::path& file, const ComputedFigure& made) {
  const Figure& figure = made.figure;
  writePicture(file, composeFigure(figure, made.contact.get(), printOptions(figure.sheet)),
               {translated(figure.sheet.title), originOf(figure)});
}

void writeFigureData(const std::filesystem::path& file, const ComputedFigure& made) {
  const std::string extension = file.extension().string();
  if (extension == ".csv")
    writeFileAtomically(file, provenanceComment("figure", made.figure.scene) + made.figure.csv);
  else if (extension == ".json")
    writeFileAtomically(file, claimsJson({&made.figure, 1}));
  else
    throw unknownExtension(file.string(), extension, {".csv", ".json"});
}

}  // namespace asperity
