#include "ui/window/figures/figure_queue.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/provenance.h"
#include "ui/chart/figure_drawing.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

/// Makes a figure in the background. `progressed` is called on the window's thread with the
/// finished part, in steps of a thousandth or more. One processor is left for the window.
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

}  // namespace

QString figureFile(FigureName name, const QString& extension) {
  return "figure_" + fromUtf8(figureEntry(name).word) + extension;
}

void writeFigurePicture(const std::filesystem::path& file, const ComputedFigure& made) {
  const Figure& figure = made.figure;
  // With the provenance that `asperity figure` writes the file opens as its scene.
  writePicture(file, composeFigure(figure, made.contact.get(), printOptions(figure.sheet)),
               {translated(figure.sheet.title), pictureOrigin("figure", figure.scene)});
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

// ---- All figures

QString figureLabel(FigureName name) {
  if (name == FigureName::Master) return FigureQueue::tr("Master curve");
  if (name == FigureName::Spacing) return FigureQueue::tr("Spacing");
  return FigureQueue::tr("Figure %1").arg(fromUtf8(figureEntry(name).word));
}

QString figureTitle(const FigureEntry& entry) {
  const QString headline = translatedText(entry.headline);
  return entry.name < FigureName::Master
             ? QStringLiteral("%1: %2").arg(figureLabel(entry.name), headline)
             : headline;
}

FigureQueue::FigureQueue(FigureMaker maker, QObject* parent)
    : QObject(parent), statuses_(figureEntries().size()), maker_(std::move(maker)) {}

void FigureQueue::compute(FigureName name, std::int64_t realizations) {
  FigureStatus& status = of(name);
  if (status.work != FigureStage::None) return;
  status.work = FigureStage::Waiting;
  queue_.push_back(name);
  const auto progressed = [this, name](double part) {
    of(name).part = part;
    emit changed(name);
  };
  work_.request(
      [maker = maker_, name, realizations, progressed](const BackgroundWork::Run& run) {
        return computeFigure(run, maker, name, realizations, progressed);
      },
      [this, name](std::shared_ptr<const ComputedFigure> made) {
        of(name).made = std::move(made);
        end(name);
      },
      [this, name](const LiveText& reason) {
        of(name).error = reason;
        end(name);
      });
  if (queue_.size() == 1) begin(name);
  emit changed(name);
}

void FigureQueue::begin(FigureName name) {
  of(name).work = FigureStage::Computing;
  of(name).part = 0;
  of(name).error = {};
}

/// Cancels the present computation; its thread ends within one pass over a line.
void FigureQueue::cancel() {
  work_.cancel();
  for (const FigureName name : std::exchange(queue_, {})) {
    of(name).work = FigureStage::None;
    emit changed(name);
  }
}

/// Ends the first of the queue, and shows that the next one is being computed.
void FigureQueue::end(FigureName name) {
  of(name).work = FigureStage::None;
  queue_.pop_front();
  if (!queue_.empty()) begin(queue_.front());
  emit changed(name);
  if (!queue_.empty()) emit changed(queue_.front());
}

}  // namespace asperity
