// Texts that core makes (core/base/message.h), in the language in use. Core knows English alone, so
// each is translated where it is shown: its template is looked up in
// resources/translations/core_de.ts, where the values stand as %1, %2, ... Numbers get the
// language's decimal sign, and such as 1e-10 are printed as all others are
// (core/base/number_text.h). Pure once the language is chosen; any thread.
#pragma once

#include <QString>
#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"
#include "core/chart/diagram.h"

namespace asperity {

/// Nothing where one of its templates has words and no translation.
std::optional<std::string> translationOf(const Message& english);

/// The same; a template without a translation stays in English.
std::string translated(const Message& english);
QString translatedText(const Message& english);

/// What an error says, behind the names of what it is about.
QString translatedError(const std::exception& error);

/// A scene's own title, description or chapter: that of a shipped scene in the language in use,
/// another as it is.
QString sceneText(std::string_view text);
bool isTranslatedScene(std::string_view text);

/// With all its titles, names and labels, which then have their text alone.
DiagramSheet translated(DiagramSheet sheet);

}  // namespace asperity
