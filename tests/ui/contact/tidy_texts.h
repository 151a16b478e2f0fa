// Whether the texts of a picture lie on it and none over another. Needs a QGuiApplication.
#pragma once

#include <QRectF>
#include <string>

#include "ui/draw/draw_list.h"

namespace asperity {

/// The pixels a text covers.
QRectF inkOf(const DrawText& text);

/// Fails the running test for every text that leaves the picture or covers another.
void expectTidy(const DrawList& list, const std::string& where);

}  // namespace asperity
