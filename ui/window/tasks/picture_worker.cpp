#include "ui/window/tasks/picture_worker.h"

#include <exception>
#include <utility>

#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"

namespace asperity {

PictureWorker::PictureWorker(PictureWorkerEvents events)
    : events_(std::move(events)), thread_([this] { run(); }) {}

PictureWorker::~PictureWorker() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void PictureWorker::request(PictureJob job) {
  {
    const std::lock_guard lock(mutex_);
    pending_ = std::make_unique<PictureJob>(std::move(job));
  }
  changed_.notify_one();
}

/// Waits; null when it is time to stop.
std::unique_ptr<PictureJob> PictureWorker::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return stopping_ || pending_; });
  if (stopping_) return {};
  return std::move(pending_);
}

void PictureWorker::run() {
  try {
    drawAll();
  } catch (const std::exception& error) {
    events_.failed(QString::fromUtf8(error.what()));
  }
}

void PictureWorker::drawAll() {
  const std::unique_ptr<PixelContext> context = makePixelContext();
  while (const std::unique_ptr<PictureJob> job = next()) {
    QImage image = renderImage(*context, job->compose());
    image.setDevicePixelRatio(job->scale);
    events_.finished(std::move(image));
  }
}

}  // namespace asperity
