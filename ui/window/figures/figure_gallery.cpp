#include "ui/window/figures/figure_gallery.h"

#include <utility>

#include "ui/panels/number_text.h"

namespace asperity {

QString figureLabel(FigureName name) {
  if (name == FigureName::Master) return FigureGallery::tr("Master curve");
  if (name == FigureName::Spacing) return FigureGallery::tr("Spacing");
  return FigureGallery::tr("Figure %1").arg(fromUtf8(figureEntry(name).word));
}

FigureGallery::FigureGallery(FigureMaker maker, QObject* parent)
    : QObject(parent), statuses_(figureEntries().size()), maker_(std::move(maker)) {}

void FigureGallery::compute(FigureName name, std::int64_t realizations) {
  FigureStatus& status = of(name);
  if (status.work != FigureStage::None) return;
  status.work = FigureStage::Waiting;
  waiting_.push_back({name, realizations});
  emit changed(name);
  startNext();
}

/// Cancels the present computation; its thread ends within one pass over a line.
void FigureGallery::cancel() {
  work_.cancel();
  const std::deque<Job> forgotten = std::exchange(waiting_, {});
  for (const Job& job : forgotten) {
    of(job.name).work = FigureStage::None;
    emit changed(job.name);
  }
  if (computing_) end(*computing_);
}

void FigureGallery::startNext() {
  if (computing_ || waiting_.empty()) return;
  const Job job = waiting_.front();
  waiting_.pop_front();
  computing_ = job.name;
  FigureStatus& status = of(job.name);
  status.work = FigureStage::Computing;
  status.part = 0;
  status.error.clear();
  const auto progressed = [this, name = job.name](double part) {
    of(name).part = part;
    emit changed(name);
  };
  work_.request(
      [maker = maker_, job, progressed](const BackgroundWork::Run& run) {
        return computeFigure(run, maker, job.name, job.realizations, progressed);
      },
      [this, name = job.name](std::shared_ptr<const ComputedFigure> made) {
        of(name).made = std::move(made);
        end(name);
      },
      [this, name = job.name](const QString& reason) {
        of(name).error = reason;
        end(name);
      });
  emit changed(job.name);
}

void FigureGallery::end(FigureName name) {
  of(name).work = FigureStage::None;
  computing_.reset();
  emit changed(name);
  startNext();
}

}  // namespace asperity
