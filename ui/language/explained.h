// The explanations of core (core/chart/explanations.h) as texts in the current language. Pure once
// the language is chosen; any thread.
#pragma once

#include <QString>
#include <string_view>

#include "core/chart/explanations.h"
#include "ui/language/language.h"

namespace asperity {

/// Returns a formula as rich text: "F_N" with a lowered N, "h^2" with a raised 2.
QString formulaHtml(std::string_view formula);

/// Returns a formula as plain text: "Fₙ", and "L_c" where there is no small lowered letter.
QString formulaText(std::string_view formula);

/// Returns a plain text as rich text, in which the normal force "Fₙ" has a lowered capital N.
QString richText(const QString& text);

/// Returns title, sentence and formula as rich text for a tooltip; an empty title is left out.
/// sentence: replaces the sentence of the explanation; may be empty.
QString explanationHtml(const HoverExplanation& explanation, const QString& title = {},
                        const QString& sentence = {});

/// Returns a tooltip as rich text, which Qt breaks into lines as it does not break plain text.
QString wrappedTip(const QString& text);

inline QString anchorText(const HoverExplanation& explanation) {
  return fromUtf8(explanation.guideAnchor);
}

}  // namespace asperity
