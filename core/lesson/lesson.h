// A lesson: steps of text, scenes, free controls and predictions, with which a person learns in the
// running program. Expected answers are not written in a lesson but computed from its scenes
// (core/lesson/lesson_answers.h), so that a lesson cannot contradict the program. The exception is
// a choice that no number decides. Plain values; any thread.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

/// A text in English and German. Paragraphs are separated by an empty line; "*word*" is emphasized,
/// "**word**" is strong, and a line that begins with "- " is an item of a list; every other line
/// ends where it ends in the text. In texts that are shown after the answer, "{name}" is replaced
/// by a value of the step, "{answer}" and "{given}" by the expected and the given answer: a number,
/// or the words of a choice, which "{answer}" is only where no number decides.
struct LessonText {
  std::string english{}, german{};

  bool empty() const { return english.empty() && german.empty(); }
  /// Returns the text in a language ("de"), or in the other language where it has none in this one.
  const std::string& in(std::string_view language) const {
    const std::string& wanted = language == "de" ? german : english;
    return !wanted.empty() ? wanted : language == "de" ? english : german;
  }

  bool operator==(const LessonText&) const = default;
};

/// A number that the program computes in steady sliding from the scene of a step with other keys: a
/// column of the friction curve at `sliding.velocity` (State); the position on the axis of the
/// curve at which the column is largest (Peak); or d ln column / d ln key between two values of a
/// key (Exponent). With `over` it is the ratio of two such numbers.
struct LessonValue {
  enum class Kind { State, Peak, Exponent };

  Kind kind = Kind::State;
  std::string column = "mu";        // of a friction curve
  std::vector<std::string> set{};   // KEY=VALUE over the step's scene
  std::string key{};                // of an exponent
  double from = 0, to = 0;          // of its values, both above 0
  std::vector<LessonValue> over{};  // none or one
  bool operator==(const LessonValue&) const = default;
};

/// A value with the name that texts use for it.
struct NamedLessonValue {
  std::string name;
  LessonValue value;

  bool operator==(const NamedLessonValue&) const = default;
};

/// One of the answers to choose from. Where the answer is computed, the choice is right if the
/// answer lies in [above, below).
struct LessonChoice {
  LessonText text;
  bool isRight = false;  // where nothing is computed
  double above = -std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();

  bool isRange() const {
    return above > -std::numeric_limits<double>::infinity() ||
           below < std::numeric_limits<double>::infinity();
  }
  bool operator==(const LessonChoice&) const = default;
};

enum class PredictionKind { Choice, Number, Point };

inline constexpr double kLargestTolerance = 10;  // relative

/// A question that the student answers before the result is shown.
struct LessonPrediction {
  PredictionKind kind = PredictionKind::Choice;
  LessonText question{};
  std::vector<LessonChoice> choices{};  // of a choice
  std::optional<LessonValue> answer{};  // of a number, and of a choice that a number decides
  /// Relative, above 0: an answer is right if it differs by at most this part of the expected one;
  /// the height of a point is right up to (1 + tolerance) times as large or small.
  double tolerance = 0.1;
  /// Of a point, which is placed on the friction chart of the step's scene: its x where only the
  /// height is asked for; empty: x and height of the largest value of the curve are asked for.
  std::optional<double> x{};
  double xTolerance = 1;  // of the x of a largest value, as `tolerance`
  LessonText right{}, wrong{};

  bool operator==(const LessonPrediction&) const = default;
};

enum class ControlState { Free, Locked, Hidden };

/// The controls that a step leaves to the student, by their keys in the table of parameters.
struct LessonControls {
  std::vector<std::string> free{}, locked{}, hidden{};
  ControlState others = ControlState::Hidden;

  ControlState state(std::string_view key) const;
  bool operator==(const LessonControls&) const = default;
};

/// The appearance of the window in a step.
struct LessonView {
  std::string tab = "curve";     // one of kLessonTabs
  std::string quantity = "mu";   // of the vertical axis of the friction curve
  bool isLinearY = false;        // whether that axis is linear
  bool hidesCurve = false;       // until the prediction is made
  bool hidesCurveAfter = false;  // also afterwards, because a later step asks for what it shows
  /// Ends of the vertical axis while the curve is hidden, so that the axis does not show the
  /// answer; a linear axis may begin at 0.
  double hiddenFrom = 1e-4, hiddenTo = 10;
  /// Curves to compare with: each one is that of the step's scene with other keys, KEY=VALUE.
  std::vector<std::vector<std::string>> beside{};

  bool operator==(const LessonView&) const = default;
};

/// The tabs that a step may bring to the front.
inline constexpr std::string_view kLessonTabs[] = {"curve",      "motion",   "spectrum",
                                                   "statistics", "material", "accuracy",
                                                   "plan",       "map",      "influences"};

struct LessonStep {
  LessonText title{}, text{};
  /// The scene with which the step begins: the name of a shipped scene or of a file, or the scene
  /// itself as JSON. Both empty: the step continues with the scene of the previous step.
  std::string sceneName{}, sceneJson{};
  std::vector<std::string> set{};    // KEY=VALUE over it
  std::vector<std::string> after{};  // KEY=VALUE, done when the answer is revealed
  LessonView show{};
  LessonControls controls{};
  std::optional<LessonPrediction> prediction{};
  LessonText reveal{};                     // shown when the answer is revealed
  std::vector<NamedLessonValue> values{};  // for texts that are shown then

  // Set by the reader: the scene of the step, and the scene after its reveal.
  Scene scene{}, revealedScene{};

  /// Returns whether the step does not continue with the scene of the previous one.
  bool hasOwnScene() const { return !sceneName.empty() || !sceneJson.empty(); }
  bool operator==(const LessonStep&) const = default;
};

struct Lesson {
  std::string name{};                   // of its file, without folder and extension; not part of it
  LessonText title{}, goal{}, notes{};  // goal: what is learnt; notes: for the teacher
  int minutes = 15;
  std::vector<LessonStep> steps{};
  std::string digest{};  // SHA-256 of the canonical text, by which results know the lesson

  bool operator==(const Lesson&) const = default;
};

/// Returns the lesson as students read it: a question that is translated only in part, with its
/// choices and the texts after its answer, loses that language, so that it stands in one language.
Lesson withWholeQuestions(Lesson lesson);

/// Returns the step with this number if it asks for a prediction, else null.
const LessonStep* askingStep(const Lesson& lesson, int step);

/// Returns how many steps ask for a prediction.
int predictionCount(const Lesson& lesson);

/// Returns the name of the key of an assignment KEY=VALUE.
std::string_view assignmentKey(std::string_view assignment);

/// Returns the scene with these keys, KEY=VALUE. Throws InputError with the key.
Scene withKeys(const Scene& scene, const std::vector<std::string>& assignments);

/// Returns the keys that are not free and have another value than in the step's scene.
std::vector<std::string_view> lockedChanges(const LessonControls& controls, const Scene& step,
                                            const Scene& given);

/// Returns the given scene with the values of the step in all keys that are not free.
Scene withinControls(const LessonControls& controls, const Scene& step, const Scene& given);

}  // namespace asperity
