// The answers of a lesson, computed by the program from the scenes of its steps: what a prediction
// is compared with, and the numbers of which its texts speak.
//
// Threading: functions of their arguments; computing uses several threads and gives the same bytes
// for any number of them. Failure: InputError for a scene that cannot run or an answer that none of
// the choices covers; std::runtime_error where a force balance is not met; StudyStopped where it
// was stopped.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/friction/ensemble.h"
#include "core/lesson/lesson.h"

namespace asperity {

/// A computed number in its SI unit; a ratio and an exponent have none.
struct LessonNumber {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string unit{};

  bool operator==(const LessonNumber&) const = default;
};

/// What is right in a step.
struct LessonAnswer {
  LessonNumber number{};  // of a number, of a choice that one decides, height of a point
  LessonNumber place{};   // of a point
  int choice = -1;        // of a choice, from 0
  std::vector<std::pair<std::string, LessonNumber>> values{};  // of which texts speak

  bool operator==(const LessonAnswer&) const = default;
};

/// What a student says.
struct GivenAnswer {
  int choice = -1;
  double number = std::numeric_limits<double>::quiet_NaN();  // SI; height of a point
  double place = std::numeric_limits<double>::quiet_NaN();   // of a point

  bool isGiven() const;
};

/// Computes a number over the step's scene.
LessonNumber computeLessonValue(const Scene& scene, const LessonValue& value,
                                const CurveOptions& options = {});

/// Computes what is right in a step that has a prediction, and the values of its texts.
LessonAnswer lessonAnswer(const LessonStep& step, const CurveOptions& options = {});

/// Returns the choice that is right, from 0, where a number decides that of this number. Throws
/// InputError where no range covers it.
int rightChoice(const LessonPrediction& prediction, const LessonNumber& number);

/// Returns whether a computed answer could lie in no range of the choices.
bool leavesOutNumbers(const LessonPrediction& prediction);

/// Computes the answers of the choices that leave out numbers. Throws InputError with the place in
/// the lesson ("steps[2].prediction.choices") where none of them covers the answer: a student could
/// not go on there. file: named in the error.
void checkChoices(const Lesson& lesson, const std::string& file, const CurveOptions& options = {});

/// The unit of a number that is asked for, without computing it.
std::string unitOf(const LessonValue& value, const Scene& scene);

/// Returns whether an answer is right: the right choice; a number with |given - answer| <=
/// tolerance |answer|; a point whose height, and place where it is asked, lie within a factor 1 +
/// tolerance of the answer's.
bool isRight(const LessonPrediction& prediction, const LessonAnswer& answer,
             const GivenAnswer& given);

/// Returns a text with its places "{name}", or "{name%}" in per cent, filled. textOf gives the text
/// of a number.
std::string withValues(const std::string& text, const LessonPrediction& prediction,
                       const LessonAnswer& answer, const GivenAnswer& given,
                       std::string_view language,
                       const std::function<std::string(const LessonNumber&)>& textOf);

}  // namespace asperity
