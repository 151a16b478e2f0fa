#include "ui/window/figures/figure_gallery.h"

#include <utility>

#include "ui/panels/number_text.h"

namespace asperity {

QString figureLabel(FigureName name) {
  if (name == FigureName::Master) return FigureGallery::tr("Master curve");
  if (name == FigureName::Spacing) return FigureGallery::tr("Spacing");
  return FigureGallery::tr("Figure %1").arg(fromUtf8(entryOf(name).word));
}

FigureGallery::FigureGallery(FigureMaker maker, QObject* parent)
    : QObject(parent),
      statuses_(figureEntries().size()),
      worker_(workerEvents(), std::move(maker)) {}

void FigureGallery::compute(FigureName name, std::int64_t realizations) {
  FigureStatus& status = of(name);
  if (status.work != FigureStage::None) return;
  status.work = FigureStage::Waiting;
  waiting_.push_back({name, realizations});
  emit changed(name);
  startNext();
}

void FigureGallery::cancel() {
  const std::deque<FigureJob> forgotten = std::exchange(waiting_, {});
  for (const FigureJob& job : forgotten) {
    of(job.name).work = FigureStage::None;
    emit changed(job.name);
  }
  worker_.stop();
}

void FigureGallery::startNext() {
  if (computing_ || waiting_.empty()) return;
  const FigureJob job = waiting_.front();
  waiting_.pop_front();
  computing_ = job.name;
  FigureStatus& status = of(job.name);
  status.work = FigureStage::Computing;
  status.part = 0;
  status.error.clear();
  worker_.start(job);
  emit changed(job.name);
}

void FigureGallery::end(FigureName name) {
  of(name).work = FigureStage::None;
  computing_.reset();
  emit changed(name);
  startNext();
}

/// All arrive on the worker's thread and go on here; dropped once this object is gone.
FigureWorkerEvents FigureGallery::workerEvents() {
  FigureWorkerEvents events;
  events.progressed = [this](FigureName name, double part) {
    QMetaObject::invokeMethod(this, [this, name, part] {
      of(name).part = part;
      emit changed(name);
    });
  };
  events.finished = [this](std::shared_ptr<const MadeFigure> made) {
    QMetaObject::invokeMethod(this, [this, made = std::move(made)] {
      const FigureName name = made->figure.name;
      of(name).made = made;
      end(name);
    });
  };
  events.failed = [this](FigureName name, const QString& reason) {
    QMetaObject::invokeMethod(this, [this, name, reason] {
      of(name).error = reason;
      end(name);
    });
  };
  events.stopped = [this](FigureName name) {
    QMetaObject::invokeMethod(this, [this, name] { end(name); });
  };
  return events;
}

}  // namespace asperity
