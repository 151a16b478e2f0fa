// The file of a study: a space of scene keys around a base scene, and the numbers that every
// simulation has to give. The reader checks everything that can be checked without a simulation.
// Pure except for reading the files that a study names. Failure: InputError with file, key, what is
// wrong and what is allowed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "core/scene/scene_file.h"
#include "core/study/curve_fits.h"
#include "core/study/study_space.h"

namespace asperity {

/// A number that every simulation has to give: a column of its friction curve, at the scene's own
/// velocity or (`curve.mu`) at every value of its sweep; or one that summarizes the whole curve
/// (`fit.maximum`).
struct StudyOutput {
  std::string name;    // "mu", "curve.mu", "fit.maximum"
  std::string column;  // "mu"
  bool isCurve = false;
  std::optional<CurveFit> fit{};

  bool isOfPoint() const { return !isCurve && !fit; }
};

struct ParameterStudy {
  std::string title;
  Scene base;
  StudySpace space;
  std::vector<StudyOutput> outputs;
  std::int64_t chunk = 1;  // simulations that are computed and stored together

  std::int64_t simulations() const { return space.size(); }
  std::int64_t chunks() const { return (simulations() + chunk - 1) / chunk; }
  std::int64_t sizeOfChunk(std::int64_t number) const {
    return std::min(chunk, simulations() - number * chunk);
  }

  bool wantsPoint() const;  // whether an output is at the scene's own velocity
  bool wantsCurve() const;  // for itself or for a fit
  /// Returns the values of the key over which the curves go; empty where no output needs a curve.
  std::vector<double> curveValues() const;
  /// Returns how many states of one simulation slide: one for each value of its curve, and that at
  /// the scene's own velocity.
  std::size_t states() const;
  /// Returns how many numbers of one simulation are stored: one for an output, or one for each
  /// value of the curve.
  std::size_t numbers() const;

  /// Returns the scene of a point. Throws InputError with the key where it cannot be.
  Scene sceneAt(std::span<const double> point) const;
  /// Returns the value of a column of a point as text: a number, or the word that it stands for.
  std::string textAt(std::size_t column, double value) const;

  /// The text that a store keeps: a study file with everything that influences the results, and
  /// nothing else. Equal studies have equal texts.
  std::string canonical;
  std::string digest;  // SHA-256 of that text

  bool isSlow = false;   // a point can change kinds, so that its scene has to be read anew
  std::string baseText;  // of the base scene, for such points
};

/// Describes for users what the file may contain.
extern const char* const kStudyFormat;

/// Reads a study. readNamed reads the scene that the study names; null: it is a file
/// relative to the folder of the study.
ParameterStudy readStudy(const std::filesystem::path& file, const SceneReader& readNamed = {});

/// Reads the same from a text; `name` is named in errors.
ParameterStudy readStudy(std::string_view json, const std::string& name,
                         const std::filesystem::path& folder, const SceneReader& readNamed = {});

/// Returns the first differences between two canonical texts: "space.surface.hurst.to: 1 instead of
/// 0.9".
Message describeDifference(std::string_view expected, std::string_view found);

}  // namespace asperity
