// What a scene leaves open and something else says: the length and the elements of a profile are
// its file's where they are 0, an oversampling of 0 is chosen by the scene, a line that is not
// random is its only realization, and a profile without a file is no scene to run yet. Plain
// values; any thread.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/scene/parameters.h"

namespace asperity {

/// One period as it was made; 0 where not known.
struct LineSize {
  double length = 0;  // m
  std::int64_t elements = 0;

  bool operator==(const LineSize&) const = default;
};

/// Shown in place of a value of the scene.
struct Placeholder {
  QString text;                 // in pale letters
  std::optional<double> value;  // where a slider stands
  bool isFixed = false;         // there is nothing to choose
};

std::optional<Placeholder> placeholderFor(const Parameter& parameter, const Scene& scene,
                                          const LineSize& known);

/// Where the reset button goes: the default, or 0 for what a profile's file says.
ParameterValue restingValue(const Parameter& parameter, const Scene& scene);

/// Whether the scene chooses a value that is left open.
bool isChosenWhereOpen(const Parameter& parameter);

/// setValue() and setFromText(), which also take what is left open: 0, or no text.
void giveValue(const Parameter& parameter, Scene& scene, const ParameterValue& value);
void giveText(const Parameter& parameter, Scene& scene, std::string_view text);

/// Whether the parameter names a file.
bool isFile(const Parameter& parameter);

/// Whether the parameter is a text of several sentences.
bool isLongText(const Parameter& parameter);

/// What has to be given before the scene can run, and where; the text is empty where nothing is
/// missing.
struct Missing {
  std::string_view key;
  QString text;
};
Missing missingOf(const Scene& scene);

/// Length and elements of the kinds that are not on the screen: those with a file share theirs, all
/// others share theirs, and both come back with their kind.
class KeptSizes {
 public:
  explicit KeptSizes(const Surface& surface);

  /// `next` has followed `before`.
  void follow(const Surface& before, Surface& next);

 private:
  LineSize profile_, others_;
};

/// Realizations mean every row where a surface becomes a measured one, and a number again where it
/// becomes another one. `next` has followed `before`.
void followRealizations(const Scene& before, Scene& next);

}  // namespace asperity
