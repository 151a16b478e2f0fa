// The texts of a picture, and whether they lie on it and none over another. Needs a
// QGuiApplication.
#pragma once

#include <QRectF>
#include <string>

#include "ui/draw/draw_list.h"

namespace asperity {

/// All texts of a picture, each with a | behind it.
std::string allTexts(const DrawList& list);

/// The pixels a text covers.
QRectF inkOf(const DrawText& text);

/// Fails the running test for every text that leaves the picture or covers another.
void expectTidy(const DrawList& list, const std::string& where);

}  // namespace asperity
