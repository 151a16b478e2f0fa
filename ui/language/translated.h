// Texts that core makes, in the language in use. Core knows English alone, so each is translated
// where it is shown; what it says is in resources/translations/core_de.ts. A text with values in it
// stands there with %1, %2, ... for its numbers and their units ("mean of %1 lines"). Pure once the
// language is chosen; any thread.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <string_view>

#include "core/chart/diagram.h"

namespace asperity {

/// As it stands, or with its numbers left out, or sentence by sentence, or a list item by item;
/// numbers get the language's decimal sign. Nothing where a part of it is not known.
std::optional<std::string> translationOf(std::string_view english);

/// The same; in English, or where there is no translation, the text itself. What follows a name
/// that nobody knows and a semicolon or a colon is translated alone. Numbers like 1e-10 are printed
/// as all others are (core/base/printed_number.h), from 1e5 on and below 1e-3 as powers of ten.
std::string translated(std::string_view english);
QString translatedText(std::string_view english);

/// A scene's own title, description or chapter: that of a shipped scene in the language in use,
/// another as it is, but for its numbers.
QString sceneText(std::string_view text);
bool isTranslatedScene(std::string_view text);

/// With all its titles, names and labels.
DiagramSheet translated(DiagramSheet sheet);

}  // namespace asperity
