// Values that a scene leaves open. Where the length and the elements of a profile are 0, they come
// from its file; the scene chooses an oversampling of 0; a line that is not random is its only
// realization; and a profile without a file cannot run yet. Plain values; any thread.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/scene/parameters.h"

namespace asperity {

/// A text shown instead of a value of the scene.
struct Placeholder {
  QString text;                 // shown in pale letters
  std::optional<double> value;  // position of a slider
  bool isFixed = false;         // the user cannot change it
  QString unit{};               // of the text; empty: that of the parameter
};

/// known: length and elements of the present period.
std::optional<Placeholder> placeholderFor(const Parameter& parameter, const Scene& scene,
                                          const LineSize& known);

/// Returns what an entry of 0 means, such as "automatic" or "none"; empty: the number itself.
QString zeroText(const Parameter& parameter);

/// Returns the reset button's value: the default, or 0 where a profile's file gives the value.
ParameterValue resetValue(const Parameter& parameter, const Scene& scene);

/// Returns whether the scene chooses the parameter's value where it is 0.
bool isChosenWhereOpen(const Parameter& parameter);

/// Call setValue() and setFromText(), and also accept values that are left open: 0, or no text. The
/// name of a material brings all of its values (scene_files.h).
void assignValue(const Parameter& parameter, Scene& scene, const ParameterValue& value);
void assignText(const Parameter& parameter, Scene& scene, std::string_view text);

/// Returns whether the parameter names a file.
bool isFile(const Parameter& parameter);

/// Returns whether the parameter names a material: a shipped one or a file.
bool isMaterial(const Parameter& parameter);

/// Returns whether the parameter is a text of several sentences.
bool isLongText(const Parameter& parameter);

/// The value that is missing before the scene can run; the text is empty where nothing is missing.
struct Missing {
  std::string_view key;
  QString text;
};
Missing missingValue(const Scene& scene);

/// Remembers length and elements of the surface kinds that are not shown: those with a file share
/// theirs, all others share theirs, and both return with their kind.
class RememberedSizes {
 public:
  explicit RememberedSizes(const Surface& surface);

  /// Updates the memory after `next` has replaced `before`.
  void update(const Surface& before, Surface& next);

 private:
  LineSize& sizeOf(const Surface& surface);

  LineSize fromFile_, others_;
};

/// Sets the realizations of `next`, which follows `before`: to every row (0) where the surface
/// becomes a measured one, and to the default number where it becomes another one. One row is at
/// most one line.
void updateRealizations(const Scene& before, Scene& next);

}  // namespace asperity
