// The figures of Li et al., PRL 111, 034301 (2013), each computed anew with the paper's parameters:
// a diagram, its data, its scene, and the paper's sentences about it compared with the results. Two
// more show the collapse of Eqs. (16) and (17) and the influence of the spacing. Immutable once
// made; any thread. Equal options give equal bytes.
// Failure: InputError for assignments that do not fit the figure; std::runtime_error where a force
// balance is not met; StopRequested where `stop` was requested.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/chart/diagram.h"
#include "core/paper/claim.h"
#include "core/scene/scene.h"

namespace asperity {

enum class FigureName { Contact, Velocity, Hurst, Forces, Exponents, Plateau, Master, Spacing };

struct Figure;
struct FigureOptions;

struct FigureEntry {
  FigureName name;
  std::string_view word;      // "1" ... "6", "master", "spacing"
  std::string_view headline;  // "Dependence on velocity for six Hurst exponents"
  std::string_view scene;     // JSON: the paper's parameters that differ from a scene's defaults
  WordList ownKeys;           // scene keys that the figure sets itself
  void (*add)(Figure& figure, const FigureOptions& options);  // diagrams, table and claims
};

/// Returns all figures, in order.
std::span<const FigureEntry> figureEntries();
const FigureEntry& figureEntry(FigureName name);

struct FigureOptions {
  std::int64_t realizations = 200;
  /// Assignments to scene keys, applied to the paper's parameters: "surface.seed=2".
  std::vector<std::string> assignments{};
  int threads = 0;
  std::stop_token stop{};
  std::function<void(double part)> progress{};  // 0 to 1; from one thread at a time; may be empty
};

struct Figure {
  FigureName name = FigureName::Contact;
  Scene scene;         // for further experiments
  DiagramSheet sheet;  // without diagrams for the contact, which is a drawing
  std::string csv;
  std::vector<Claim> claims;
};

/// Returns the paper's parameters for a figure, with the assignments. Throws InputError.
Scene figureScene(FigureName name, const FigureOptions& options);

Figure makeFigure(FigureName name, const FigureOptions& options);

/// Returns claims.json: the figures made in one run, with provenance.
std::string claimsJson(std::span<const Figure> figures);

}  // namespace asperity
