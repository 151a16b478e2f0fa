// The toolbar's icons, drawn in a colour at any density. GUI thread.
#pragma once

#include <QIcon>

namespace asperity {

/// None: a command without an icon.
enum class Symbol {
  Play,
  Pause,
  Step,
  Reset,
  Scenes,
  Figures,
  Open,
  Save,
  Undo,
  Redo,
  Light,
  None
};

QIcon symbolIcon(Symbol symbol, const QColor& colour);

}  // namespace asperity
