// The table of explanations that the window shows under the pointer: symbols, quantities, regions,
// legend entries and numbered equations, each with its formula, a sentence and its anchor in the
// guide. Parameters, regions and theories have their sentences in their own tables, which are used
// here. Constant; any thread.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/base/message.h"
#include "core/material/elastomer.h"

namespace asperity {

struct HoverExplanation {
  std::string_view id;           // scene key, column, "region IV", text of a legend, "Eq. (11)"
  std::string_view formula;      // in printed letters, the same in every language; may be empty
  std::string_view sentence;     // English; its German is in core_de.ts
  std::string_view guideAnchor;  // of the guide's page: "law", "eq-11"
  std::string_view formulaOfArms = {};  // of elements with arms; empty: the same formula
};

/// Returns the explanation with this id; nothing where there is none. Every scene key has one.
std::optional<HoverExplanation> findExplanation(std::string_view id);

/// Returns the explanation of a text of a chart, by its English template; nothing where there is
/// none, as for a curve that a user named.
std::optional<HoverExplanation> findExplanation(const Message& text);

/// Returns the explanation with the formula of the elements of an elastomer: that of a spring and
/// a dashpot, or that of arms.
HoverExplanation withFormulaFor(HoverExplanation explanation, Rheology rheology);

/// A symbol of formulas that no row and no number of the window has beside its name.
struct FormulaSymbol {
  std::string_view symbol;   // as in formulas: "L_c"
  std::string_view meaning;  // English; its German is in core_de.ts
};
std::span<const FormulaSymbol> formulaSymbols();

/// Returns all explanations of the table itself, for tests and the guide.
std::span<const HoverExplanation> explanations();

}  // namespace asperity
