// Which friction curve is to be averaged, and what came of it so far: the orders of a window and
// the updates it has not taken yet. A curve belongs to every scene that differs only in what it
// does not depend on; another scene's curve stops the one under way, and nothing of that is handed
// on. Threading: none of its own; its owner locks.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/friction/ensemble.h"
#include "core/scene/scene.h"

namespace asperity {

/// A friction curve as far as it is averaged; points with 0 realizations are not known yet.
struct CurveUpdate {
  std::shared_ptr<const Scene> scene;
  std::uint64_t sceneNumber = 0;
  std::int64_t realizationsDone = 0;
  std::int64_t realizationsTotal = 0;  // as planned so far, where the scene has a target
  std::vector<CurvePoint> points;
  bool isComplete = false;  // no more comes of this curve
};

struct PostedScene {
  std::shared_ptr<const Scene> scene;
  std::uint64_t number = 0;
};

/// A curve to be averaged until `stop` is requested.
struct CurveWork {
  PostedScene scene;
  std::uint64_t number = 0;  // of the curve, which offer() asks for
  std::stop_token stop;
};

class CurveOrders {
 public:
  /// The present scene from now on. Where its curve is the same as before it is handed over again
  /// under the scene's number; else a new one is ordered.
  void post(const PostedScene& scene);

  /// Gives up the curve that is under way or ordered; it stays as far as it is.
  void stop();
  /// The same curve from its beginning.
  void start();
  /// Nothing is averaged any more.
  void end() { working_.request_stop(); }

  /// Whether a curve was ordered after this one.
  bool hasNewerThan(std::uint64_t number) const { return number_ != number; }
  /// The newest curve, for the thread that averages it.
  CurveWork begin();

  /// Keeps an average of a curve under the newest scene that has this curve, whatever scene the
  /// update names; false, and nothing kept, where another curve was ordered since.
  bool offer(std::uint64_t number, const CurveUpdate& update);

  /// All updates of the present scene since the last call, oldest first.
  std::vector<CurveUpdate> takeUpdates();

 private:
  void order();

  PostedScene present_, ordered_;
  std::uint64_t number_ = 0;
  std::stop_source working_;
  bool isStopped_ = false;
  std::optional<CurveUpdate> last_;
  std::vector<CurveUpdate> updates_;
};

}  // namespace asperity
