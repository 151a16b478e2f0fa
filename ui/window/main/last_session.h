// The state of the window, kept in the user's settings until the next start: the scene with its
// changes and where it came from, the front tab, the zoomed part of the contact and its colours. It
// is written at the end and, against a crash, some seconds after each change. (Size, docks and
// theme are kept by window_layout.h.) GUI thread. Failure: a scene that cannot be read again is
// left out, and the status line shows the reason.
#pragma once

#include <chrono>

namespace asperity {

class MainWindow;

/// The moment at which the session is written. End: changes of a file that are not saved by then
/// were discarded by the user, so they are not kept. Running: the program may crash before anything
/// is saved, so they are kept; what is tried out in a tour or a lesson is not.
enum class SessionMoment { End, Running };

/// Writes the state of the window to the settings, in one step: a crash leaves the state before it.
void saveLastSession(MainWindow& window, SessionMoment moment = SessionMoment::End);

/// Writes the running session after each change of the scene, at most this long after it.
inline constexpr std::chrono::milliseconds kSessionDelay{2000};
void keepLastSession(MainWindow& window);

/// Shows the scene of the last session, its part of the contact and its tab. hasScene: the command
/// line or a file gave the window its scene, so only the tab is restored. Returns false at a first
/// start.
bool restoreLastSession(MainWindow& window, bool hasScene);

}  // namespace asperity
