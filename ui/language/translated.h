// Texts that core makes (core/base/message.h), in the current language. Core has only English, so
// each text is translated where it is shown: its template is looked up in
// resources/translations/core_de.ts, where the values are written as %1, %2, ... Numbers get the
// language's decimal sign, and machine numbers such as 1e-10 are formatted as all others
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

/// Returns the translation; nothing where one of its templates has words but no translation.
std::optional<std::string> findTranslation(const Message& english);

/// Returns the translation; a template without one stays in English.
std::string translated(const Message& english);
QString translatedText(const Message& english);

/// Returns a text with a capital letter, as entries of menus and headings begin.
QString capitalized(const QString& text);

/// Returns a text for a label of several lines: none ends between a number and its unit, or "Eq."
/// and its number.
QString keptTogether(QString text);

/// Returns an error's message after the names of its subject.
QString translatedError(const std::exception& error);

/// Returns a scene's title, description or chapter: texts of shipped scenes in the current
/// language, others unchanged.
QString sceneText(std::string_view text);
bool isTranslatedScene(std::string_view text);

/// Translates all titles, names and labels, which then have only their text.
DiagramSheet translated(DiagramSheet sheet);

}  // namespace asperity
