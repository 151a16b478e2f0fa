// The requests for friction curves and their results so far: the orders of a window and the updates
// that it has not taken yet. A curve belongs to every scene that differs only in parameters on
// which the curve does not depend; a scene with another curve stops the present one, whose results
// are dropped. Threading: none of its own; its owner locks.
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

/// The present state of a friction curve; points with 0 realizations are not known yet.
struct CurveUpdate {
  std::shared_ptr<const Scene> scene;
  std::uint64_t sceneNumber = 0;
  std::int64_t realizationsDone = 0;
  std::int64_t realizationsTotal = 0;  // as planned so far, if the scene has a target
  std::vector<CurvePoint> points;
  bool isComplete = false;  // no more results follow
};

struct PostedScene {
  std::shared_ptr<const Scene> scene;
  std::uint64_t number = 0;
};

/// A curve to average until `stop` is requested.
struct CurveWork {
  PostedScene scene;
  std::uint64_t number = 0;  // number of the curve for offer()
  std::stop_token stop;
};

class CurveRequests {
 public:
  /// Sets the present scene. If its curve is the same as before, that curve is reported again under
  /// the scene's number; else a new one is requested.
  void post(const PostedScene& scene);

  /// Stops the present or requested curve; its results so far are kept.
  void stop();
  /// Starts the requested curve from its beginning.
  void start();
  /// Ends all averaging.
  void end() { working_.request_stop(); }

  /// Returns whether a curve was requested after this one.
  bool hasNewerThan(std::uint64_t number) const { return number_ != number; }
  /// Returns the newest curve, for the thread that averages it.
  CurveWork begin();

  /// Stores the state of a curve under the newest scene that has this curve, whatever scene the
  /// update names; returns false, and stores nothing, where another curve was requested since.
  bool offer(std::uint64_t number, const CurveUpdate& update);

  /// Returns all updates of the present scene since the last call, oldest first.
  std::vector<CurveUpdate> takeUpdates();

 private:
  PostedScene present_, requested_;
  std::uint64_t number_ = 0;
  std::stop_source working_;
  bool isStopped_ = false;
  std::optional<CurveUpdate> last_;
  std::vector<CurveUpdate> updates_;
};

}  // namespace asperity
