// Lessons as JSON: reader and writer share one set of words. Private to core/lesson. Pure except
// for reading the scenes that a lesson names.
#pragma once

#include <filesystem>

#include "core/base/json_text.h"
#include "core/base/named_choices.h"
#include "core/lesson/lesson_file.h"

namespace asperity {

inline constexpr NamedChoices<PredictionKind, 3> kPredictionKinds{
    {{"choice", PredictionKind::Choice},
     {"number", PredictionKind::Number},
     {"point", PredictionKind::Point}}};
inline constexpr NamedChoices<ControlState, 3> kControlStates{{{"hidden", ControlState::Hidden},
                                                               {"locked", ControlState::Locked},
                                                               {"free", ControlState::Free}}};
/// When the friction curve of a step is hidden: never, until the prediction is made, or throughout.
enum class CurveHiding { Never, UntilAnswered, Throughout };
inline constexpr NamedChoices<CurveHiding, 3> kCurveStates{
    {{"shown", CurveHiding::Never},
     {"hidden", CurveHiding::UntilAnswered},
     {"hidden_throughout", CurveHiding::Throughout}}};

/// The members that name the column of a value, one for each kind.
inline constexpr NamedChoices<LessonValue::Kind, 3> kLessonValueKinds{
    {{"quantity", LessonValue::Kind::State},
     {"peak", LessonValue::Kind::Peak},
     {"exponent", LessonValue::Kind::Exponent}}};

/// Whether a lesson is read to be played, or to be written on.
enum class LessonReading { Complete, Draft };

/// Reads and checks a lesson. Throws InputError with the path ("steps[2].prediction.answer").
Lesson parseLesson(const nlohmann::ordered_json& root, const std::filesystem::path& folder,
                   const SceneReader& readNamed, LessonReading reading);

}  // namespace asperity
