// The look of the panels' labels, entries and small buttons, in the colours of a palette.
#pragma once

#include <QString>

class QPalette;

namespace asperity {

QString panelStyleSheet(const QPalette& palette);

}  // namespace asperity
