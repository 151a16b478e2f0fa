// The table of parameters: every scene key is declared in one row of parameters.cpp, which scene
// files, --set, the sliders, --help and the guide all use; and the table as text for the last two.
// The table is constant; any thread may read it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/input_error.h"
#include "core/base/message.h"
#include "core/base/units.h"
#include "core/scene/scene.h"

namespace asperity {

/// The scale of a slider. LogarithmicFromNone: the first position is 0, which means none; the
/// others are logarithmic.
enum class Scale { Linear, Logarithmic, LogarithmicFromNone };

/// A real number in [minimum, maximum]; sliders cover [sliderFrom, sliderTo] on the given scale.
struct RealField {
  double& (*member)(Scene&);
  double minimum, maximum;
  double sliderFrom, sliderTo;
  Scale scale;
};

/// A whole number in [minimum, maximum]; sliders cover [sliderFrom, sliderTo] on the given scale.
struct IntegerField {
  std::int64_t& (*member)(Scene&);
  std::int64_t minimum, maximum;
  std::int64_t sliderFrom, sliderTo;
  Scale scale;
};

/// One of a few words; `member` reads and writes the enumerator's number, which indexes `choices`.
struct ChoiceField {
  int (*read)(const Scene&);
  void (*write)(Scene&, int);
  std::span<const std::string_view> choices;
};

/// What a text is: a line, several sentences, or the name of a file or of a material.
enum class TextContent { Line, Sentences, File, Material };

struct TextField {
  std::string& (*member)(Scene&);
  TextContent content = TextContent::Line;
};

/// The arms of an elastomer; their value is a JSON list of {"modulus", "relaxation_time"}.
struct ArmsField {
  std::vector<Arm>& (*member)(Scene&);
};
inline constexpr std::size_t kMaxArms = 64;

/// A table of temperature shifts; as a value: a JSON list of {"temperature", "log10_shift"}.
struct ShiftTableField {
  std::vector<ShiftPoint>& (*member)(Scene&);
};
inline constexpr std::size_t kMaxShiftPoints = 1000;

/// Any other list; as a value: JSON text.
struct ListField {
  std::string (*read)(const Scene&);
  /// Throws InputError that names the row of the list, such as KEY[1].file.
  void (*write)(Scene&, std::string_view json, const std::string& key);
  Message (*allowed)();
};

/// The effect of a change on a running simulation: it continues with the new value, or makes a new
/// line.
enum class Change { Live, Rebuild };

/// A row applies only where the choice of key `choiceKey` applies and is one of `words` (separated
/// by spaces) or, with isExcept, none of them. An empty choiceKey: the row always applies.
struct Applicability {
  std::string_view choiceKey;
  std::string_view words;
  bool isExcept = false;
};

/// What the panel of parameters shows in place of 0, where 0 leaves the value open.
enum class ZeroMeaning {
  Number,        // 0 itself
  None,          // the row's effect is absent
  NotSet,        // the value is not known
  Automatic,     // the program finds the value
  AsFileStates,  // the value that the surface's file states
  TenthOfProfile,
  AllRows,  // of a topography
  // The following hold in some scenes only.
  SizeOfFile,  // the length or number of points of the surface's file, where the line has one
  EveryRow,    // each row of a measured surface is a realization
  ChosenByScene,
};

/// The rules for a row in scene files and for other files that it is about.
struct FileRule {
  bool isOfMaterial = false;        // a material gives the value where the scene does not state it
  bool isLeftOutAtDefault = false;  // not written where it has its default, unless a material is
                                    // named that would give it another value
  bool isRequired = false;          // a scene in which it has a meaning must state it
  bool isOfReading = false;         // says how a surface's file is read, which cannot be an axis
};

struct Parameter {
  std::string_view key;       // "surface.rms_height"
  std::string_view label;     // "rms height"
  std::string_view symbol;    // "h"
  std::string_view unit;      // "m"; empty for a pure number
  std::string_view sentence;  // one sentence for a user
  Change change;
  Applicability applies;
  std::variant<RealField, IntegerField, ChoiceField, TextField, ArmsField, ShiftTableField,
               ListField>
      field;
  /// The row applies where this holds, too. An empty choiceKey: nowhere else.
  Applicability alsoApplies{};
  FileRule rule{};
  ZeroMeaning zero = ZeroMeaning::Number;
};

using ParameterValue = std::variant<double, std::int64_t, std::string>;

/// Returns all rows, in the order in which a scene file is written.
std::span<const Parameter> parameters();

/// Returns the row of a key, or null.
const Parameter* findParameter(std::string_view key);

/// Returns the row of a key. Throws InputError with the nearest known key where there is none.
const Parameter& knownParameter(std::string_view key);

/// Returns the error that tells of an unknown key and of the known one that may be meant, if any.
InputError unknownKey(std::string_view key, std::string_view nearest);

/// Returns the name of the section ("surface", "elastomer.shift") that is spelled most like a name,
/// or an empty text.
std::string_view nearestSection(std::string_view name);

/// Returns the row of a number. Throws InputError with the key where it is unknown or no number.
const Parameter& numberRow(std::string_view key);

/// Returns the known key nearest to `key` by edit distance.
std::string_view nearestKey(std::string_view key);

/// Returns whether the row has a meaning in this scene (a wedge has no Hurst exponent).
bool isApplicable(const Parameter& parameter, const Scene& scene);

/// Returns whether the row decides which others have a meaning: a kind.
bool isKind(const Parameter& parameter);

/// Returns whether its value is a list in JSON: arms, a table of shifts.
bool isList(const Parameter& parameter);

/// Returns the row as it is in this scene: the ends of an axis over another key than velocity have
/// the unit, the limits and the slider of that key, and the velocity of an oscillation is called
/// its mean. All other rows are returned unchanged.
Parameter parameterIn(const Parameter& row, const Scene& scene);

/// Returns the value in the scene; choices as their word, lists as JSON text.
ParameterValue parameterValue(const Parameter& parameter, const Scene& scene);

/// Returns the value in a new scene.
ParameterValue defaultValue(const Parameter& parameter);

/// Sets one value. Throws InputError (core/base/input_error.h) with the key and what is allowed
/// where the value is of the wrong type, outside its range or not finite.
void setValue(const Parameter& parameter, Scene& scene, const ParameterValue& value);

/// Does the same with text as a user types it ("1e7", "20mN", "cubic"); a number without a unit is
/// in SI units.
void setFromText(const Parameter& parameter, Scene& scene, std::string_view text);

/// Returns which texts are numbers of the row.
QuantityRule quantityRule(const Parameter& parameter);

/// Returns a number of the row as people type it, with or without a unit. Throws InputError with
/// the key where it is none or outside what the parameter allows.
double parseNumber(const Parameter& parameter, std::string_view text);

/// Returns the number that a real or whole parameter has in a scene.
double parameterNumber(const Parameter& parameter, const Scene& scene);

/// Sets a real or whole parameter; a whole one to the nearest whole number. Throws as setValue.
void setNumber(const Parameter& parameter, Scene& scene, double number);

/// Limits of numbers, in the row's unit; other rows have none.
struct AllowedRange {
  double minimum, maximum;
};
std::optional<AllowedRange> allowedRange(const Parameter& parameter);
inline bool isNumber(const Parameter& parameter) {
  return allowedRange(parameter).has_value();
}

/// Returns whether the row's numbers are whole.
bool isWholeNumber(const Parameter& parameter);

/// What the slider of a number covers, in the row's unit; other rows have none.
struct SliderRange {
  double from, to;
  Scale scale;
};
std::optional<SliderRange> sliderRange(const Parameter& parameter);
bool hasLogarithmicSlider(const Parameter& parameter);

/// Returns "0 to 1", "1e-6 to 1e15 Pa", "one of nodal, linear, cubic" or "text".
Message allowedText(const Parameter& parameter);

/// Returns whether this number of the parameter means "as in the surface's file": a 0 of the length
/// or the elements of a line that has a file, or of the realizations of a measured surface.
bool isTakenFromSurfaceFile(const Parameter& parameter, const Scene& scene, double number);

/// Returns one line for each key: key, allowed values, unit, default, sentence.
std::string parameterTableText();

/// Returns the text with a backslash before every character that is a mark of Markdown.
std::string escapedMarkdown(std::string_view text);

/// Returns the same as a definition list of pandoc's Markdown, in which surface.hurst has the
/// anchor key-surface-hurst.
std::string parameterListMarkdown();

}  // namespace asperity
