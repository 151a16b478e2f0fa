// Draws pictures in memory on a thread of its own, with the only OSMesa context there.
// Threading: the constructor, the destructor (which joins) and request() on any one thread;
// the callbacks come on the worker's thread. The newest request wins, older ones are dropped.
// Failure: where there is no OSMesa or a picture cannot be made, `failed` is called once and the
// thread ends.
#pragma once

#include <QImage>
#include <QString>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "ui/draw/draw_list.h"

namespace asperity {

struct PictureJob {
  std::function<DrawList()> compose;  // called on the worker's thread
  double scale = 1;                   // device pixels for one of the window system's
};

struct PictureWorkerEvents {
  std::function<void(QImage)> finished;
  std::function<void(QString)> failed;
};

class PictureWorker {
 public:
  explicit PictureWorker(PictureWorkerEvents events);
  ~PictureWorker();
  PictureWorker(const PictureWorker&) = delete;
  PictureWorker& operator=(const PictureWorker&) = delete;

  void request(PictureJob job);

 private:
  std::unique_ptr<PictureJob> next();
  void run();
  void drawAll();

  PictureWorkerEvents events_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::unique_ptr<PictureJob> pending_;
  bool stopping_ = false;
  std::thread thread_;  // last: starts when all of the above is there
};

}  // namespace asperity
