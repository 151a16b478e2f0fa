// Texts that core makes, in the current language: messages (core/base/message.h) and explanations
// (core/chart/explanations.h). Core has only English, so each text is translated where it is shown:
// its template is looked up in resources/translations/core_de.ts, where the values are written as
// %1, %2, ... Numbers get the language's decimal sign, and machine numbers such as 1e-10 are
// formatted as all others (core/base/number_text.h). Pure once the language is chosen; any thread.
#pragma once

#include <QString>
#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"
#include "core/chart/diagram.h"
#include "core/chart/explanations.h"
#include "ui/language/language.h"

namespace asperity {

/// Returns the translation; nothing where one of its templates has words but no translation.
std::optional<std::string> findTranslation(const Message& english);

/// Returns the translation; a template without one stays in English.
std::string translated(const Message& english);
QString translatedText(const Message& english);

/// Returns the translation as charts and readings show it: its numbers have groups of thousands.
QString readingText(const Message& english);

/// Returns a text with a capital letter, as entries of menus and headings begin.
QString capitalized(const QString& text);

/// Returns a text for a label of several lines: none ends between a number and its unit, or "Eq."
/// and its number.
QString keptTogether(QString text);

/// Returns a text of at most so many letters: a longer one ends with a whole word, as far as it has
/// several, and an ellipsis.
QString shortened(const QString& text, qsizetype letters);

/// Returns an error's message after the names of its subject.
QString translatedError(const std::exception& error);
LiveText liveError(const std::exception& error);

/// Returns a scene's title, description or chapter: texts of shipped scenes in the current
/// language, others unchanged.
QString sceneText(std::string_view text);
bool isTranslatedScene(std::string_view text);

/// Translate all titles, names and labels, as readingText(); they then have only their text.
DiagramSheet translated(DiagramSheet sheet);
DiagramMarker translated(DiagramMarker marker);

/// Returns a formula as rich text: "F_N" with a lowered N, "h^2" with a raised 2.
QString formulaHtml(std::string_view formula);

/// Returns a formula as plain text: "Fₙ", and "L_c" where there is no small lowered letter.
QString formulaText(std::string_view formula);

/// Returns a plain text as rich text, in which the normal force "Fₙ" has a lowered capital N and
/// the modulus "G∞" a lowered sign.
QString richText(const QString& text);

/// Returns a title for a menu or a list, which have plain text: "normal force (N)" for "normal
/// force Fₙ (N)". Charts lower a capital N there, which Unicode does not have.
QString plainTitle(QString title);

/// Returns title, sentence and formula as rich text for a tooltip, with the meaning of the
/// formula's symbols (formulaSymbols); an empty title is left out.
/// sentence: replaces the sentence of the explanation; may be empty.
QString explanationHtml(const HoverExplanation& explanation, const QString& title = {},
                        const QString& sentence = {});

/// Returns a tooltip as rich text, which Qt breaks into lines as it does not break plain text.
QString wrappedTip(const QString& text);

inline QString anchorText(const HoverExplanation& explanation) {
  return fromUtf8(explanation.guideAnchor);
}

}  // namespace asperity
