// The state of the window when it was closed, kept in the user's settings until the next start: the
// scene with its changes and where it came from, the front tab, the zoomed part of the contact and
// its colours. (Size, docks and theme are kept by window_layout.h.) GUI thread. Failure: a scene
// that cannot be read again is left out, and the status line shows the reason.
#pragma once

namespace asperity {

class MainWindow;

/// Writes the state of the window to the settings. Changes of a file that are not saved by then
/// were discarded by the user, so they are not kept.
void saveLastSession(MainWindow& window);

/// The result of restoreLastSession().
enum class LastSession {
  None,      // a first start
  Restored,  // the scene, or only the tab
  Broken     // the scene cannot be read; the status line shows the reason
};

/// Shows the scene of the last session, its part of the contact and its tab. hasScene: the command
/// line or a file gave the window its scene, so only the tab is restored.
LastSession restoreLastSession(MainWindow& window, bool hasScene);

}  // namespace asperity
