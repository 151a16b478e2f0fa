// The look of the page of figures, in the colours of a palette: flat and rounded, as the bars of
// the window are. Pure function; GUI thread.
#pragma once

#include <QString>

class QPalette;

namespace asperity {

QString galleryStyleSheet(const QPalette& palette);

}  // namespace asperity
