// The contact at one moment as a few numbers and in words: for the picture's readings, and for
// those who hear the window or want to quote it. Pure; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/run/frame.h"
#include "core/scene/notes.h"

namespace asperity {

/// What the friction curve of the scene says about the velocity of a frame, as far as it is known.
struct CurveAtVelocity {
  double mu = kNotApplicable;     // mean over the lines
  double error = kNotApplicable;  // standard error of mu
  std::int64_t lines = 0;         // over which mu is a mean
  std::string region{};           // "III"; empty: not known
  NoteSet notes{};                // what limits these results
};

/// Returns the state as short sentences: how the line moves and presses, where the bodies touch,
/// what friction is and where it comes from, what other lines have, and, one sentence each, how far
/// this holds. Their numbers are those of the picture and of the status line.
std::vector<Message> describeContact(const Frame& frame, const CurveAtVelocity& curve = {});

}  // namespace asperity
