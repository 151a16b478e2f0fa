// The toolbar's icons, drawn in a colour at any density. GUI thread.
#pragma once

#include <QIcon>

namespace asperity {

enum class Symbol { Play, Pause, Step, Reset, Scenes, Figures, Open, Save, Light };

QIcon symbolIcon(Symbol symbol, const QColor& colour);

}  // namespace asperity
