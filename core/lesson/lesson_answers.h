// The answers of a lesson, computed by the program from the scenes of its steps: the expected
// answers to its predictions, and the numbers in its texts.
//
// Threading: functions of their arguments, which use several threads; the bytes are the same for
// any number of them. Failure: InputError for a scene that cannot run or an answer that none of the
// choices covers; std::runtime_error where a force balance is not met; StopRequested where the
// computation was stopped.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/statistics.h"
#include "core/friction/ensemble.h"
#include "core/lesson/lesson.h"

namespace asperity {

/// A computed number in its SI unit; a ratio and an exponent have none.
struct LessonNumber {
  double value = kNaN;
  std::string unit{};

  bool operator==(const LessonNumber&) const = default;
};

/// The right answer of a step.
struct LessonAnswer {
  LessonNumber number{};  // of a number, of a choice that one decides, height of a point
  LessonNumber x{};       // of a point
  int choice = -1;        // of a choice, from 0
  std::vector<std::pair<std::string, LessonNumber>> values{};  // for the texts, by name

  bool operator==(const LessonAnswer&) const = default;
};

/// The answer of a student.
struct GivenAnswer {
  int choice = -1;
  double number = kNaN;  // SI; height of a point
  double x = kNaN;       // of a point

  bool isGiven() const;
};

/// Computes a number from the scene of its step.
LessonNumber computeLessonValue(const Scene& scene, const LessonValue& value,
                                const CurveOptions& options = {});

/// Computes the right answer of a step that has a prediction, and the values of its texts.
LessonAnswer lessonAnswer(const LessonStep& step, const CurveOptions& options = {});
/// This function, or another one in tests.
using AnswerFunction = std::function<LessonAnswer(const LessonStep&, const CurveOptions&)>;

/// Returns the right choice, counted from 0. Where a number decides, it is the choice whose range
/// contains `number`. Throws InputError where no range does.
int rightChoice(const LessonPrediction& prediction, const LessonNumber& number);

/// Returns whether a computed answer could lie in no range of the choices.
bool leavesOutNumbers(const LessonPrediction& prediction);

/// Computes the answers of the predictions whose choices leave out numbers. Throws InputError with
/// the path in the lesson ("steps[2].prediction.choices") where no choice covers the answer,
/// because a student could not go on there. file: named in the error.
void checkChoices(const Lesson& lesson, const std::string& file, const CurveOptions& options = {});

/// Returns the unit of a number without computing it.
std::string lessonValueUnit(const LessonValue& value, const Scene& scene);

/// Returns whether an answer is right: the right choice; a number with |given - answer| <=
/// tolerance |answer|; a point whose height, and x where it is asked for, lie within a factor 1 +
/// tolerance of the expected ones.
bool isRight(const LessonPrediction& prediction, const LessonAnswer& answer,
             const GivenAnswer& given);

/// Return whether the height of a point is right, and its place on the axis, which counts where the
/// question does not fix it.
bool isHeightRight(const LessonPrediction& prediction, const LessonAnswer& answer,
                   const GivenAnswer& given);
bool isPlaceRight(const LessonPrediction& prediction, const LessonAnswer& answer,
                  const GivenAnswer& given);

/// Returns a text with the values of its names "{name}", or "{name%}" in per cent. formatNumber
/// returns a number as text.
std::string withValues(const std::string& text, const LessonPrediction& prediction,
                       const LessonAnswer& answer, const GivenAnswer& given,
                       std::string_view language,
                       const std::function<std::string(const LessonNumber&)>& formatNumber);

}  // namespace asperity
