#include "ui/window/lesson/lesson_validation.h"

#include <QRegularExpression>
#include <algorithm>
#include <string>
#include <utility>

#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/lesson/lesson_document.h"
#include "ui/window/lesson/lesson_form.h"
#include "ui/window/lesson/lesson_text.h"

namespace asperity {

namespace {

// ---- Mistakes

QString findRangeMistake(const std::vector<LessonChoice>& choices) {
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const LessonChoice& choice = choices[i];
    if (!choice.isRange())
      return LessonValidation::tr("Choice %1: needs a number in From or To, as the others have")
          .arg(i + 1);
    if (!(choice.above < choice.below))
      return LessonValidation::tr("Choice %1: From has to be less than To").arg(i + 1);
    for (std::size_t j = 0; j < i; ++j)
      if (choice.above < choices[j].below && choices[j].above < choice.below)
        return LessonValidation::tr(
                   "Choice %1: its range overlaps that of choice %2, so that one answer would make "
                   "both right")
            .arg(i + 1)
            .arg(j + 1);
  }
  return {};
}

QString findMistake(const QString& field, double tolerance) {
  if (tolerance > 0 && tolerance <= kLargestTolerance) return {};
  return LessonValidation::tr("%1: %2 is not above 0 and up to %3")
      .arg(field, percentText(tolerance), percentText(kLargestTolerance));
}

QString findMistake(const LessonStep& step) {
  if (step.text.empty()) return LessonValidation::tr("the step needs a text");
  if (!step.prediction) return {};
  const LessonPrediction& prediction = *step.prediction;
  if (prediction.question.empty()) return LessonValidation::tr("the question needs a text");
  if (prediction.kind == PredictionKind::Point && step.show.tab != "curve")
    return LessonValidation::tr(
        "a point needs the tab “Friction curve” in front, on which it lies");
  if (prediction.kind != PredictionKind::Choice) {
    if (const QString text =
            findMistake(LessonValidation::tr("Tolerance in %"), prediction.tolerance);
        !text.isEmpty())
      return text;
    return prediction.kind == PredictionKind::Point && !prediction.x
               ? findMistake(LessonValidation::tr("Tolerance of the place in %"),
                             prediction.xTolerance)
               : QString();
  }
  if (prediction.choices.size() < 2) return LessonValidation::tr("Choices: write at least two");
  if (prediction.answer) return findRangeMistake(prediction.choices);
  if (std::ranges::count_if(prediction.choices, &LessonChoice::isRight) == 1) return {};
  return LessonValidation::tr(
      "Choices: tick the right one, or write into From and To for which computed answers each is "
      "right");
}

/// Returns whether a number can be read off the curve of the step's scene.
bool isOnCurve(const LessonValue& value, const LessonStep& step) {
  const auto isAxis = [&](std::string_view key) { return key == step.scene.sweep.key; };
  return value.column == step.show.quantity &&
         std::ranges::all_of(value.set, isAxis, assignmentKey) &&
         (value.kind != LessonValue::Kind::Exponent || isAxis(value.key)) &&
         std::ranges::all_of(value.over,
                             [&](const LessonValue& under) { return isOnCurve(under, step); });
}

/// Returns the first mistake, with the number of its step; empty where there is none.
QString findMistake(const Lesson& lesson) {
  if (lesson.title.empty()) return LessonValidation::tr("The lesson needs a title");
  if (lesson.steps.empty()) return LessonValidation::tr("A lesson needs at least one step");
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    if (const QString text = findMistake(lesson.steps[i]); !text.isEmpty())
      return LessonValidation::tr("Step %1: %2").arg(i + 1).arg(text);
  return {};
}

// ---- Errors of the reader

/// Returns the name of the editor's row for a member of a lesson's file; empty where it has no row.
QString rowName(const QString& member) {
  const std::pair<const char*, QString> rows[] = {
      {"steps", LessonValidation::tr("steps")},
      {"title", LessonValidation::tr("title")},
      {"goal", LessonValidation::tr("goal")},
      {"minutes", LessonValidation::tr("minutes")},
      {"notes", LessonValidation::tr("notes for teachers")},
      {"text", LessonValidation::tr("text")},
      {"scene", LessonValidation::tr("scene")},
      {"set", LessonValidation::tr("changed")},
      {"after", LessonValidation::tr("changed with the answer")},
      {"tab", LessonValidation::tr("tab in front")},
      {"quantity", LessonValidation::tr("quantity")},
      {"controls", LessonValidation::tr("controls")},
      {"kind", LessonValidation::tr("prediction")},
      {"question", LessonValidation::tr("question")},
      {"choices", LessonValidation::tr("choices")},
      {"above", LessonValidation::tr("from")},
      {"below", LessonValidation::tr("to")},
      {"answer", LessonValidation::tr("computed answer")},
      {"tolerance", LessonValidation::tr("tolerance")},
      {"x", LessonValidation::tr("place on the axis")},
      {"right", LessonValidation::tr("if right")},
      {"wrong", LessonValidation::tr("if wrong")},
      {"reveal", LessonValidation::tr("said with the answer")},
      {"values", LessonValidation::tr("values of the texts")}};
  for (const auto& [name, row] : rows)
    if (member == QLatin1String(name)) return row;
  return {};
}

/// Returns a key of a lesson's file in the words of the editor:
/// "steps[1].prediction.choices[0].text" is step 2, choice 1, text. Parts without a row, such as
/// "show", are left out.
QString keyText(const QString& key) {
  static const QRegularExpression numbered(QStringLiteral(R"(^(\w+)\[(\d+)\]$)"));
  QStringList words;
  const QStringList members = key.split('.');
  for (qsizetype i = 0; i < members.size(); ++i) {
    const QString rest = members.mid(i).join('.');
    if (const Parameter* row = findParameter(rest.toStdString()); row && rest.contains('.')) {
      words += QStringLiteral("“%1”").arg(labelText(*row));
      break;
    }
    if (const auto found = numbered.match(members[i]); found.hasMatch()) {
      const int number = found.captured(2).toInt() + 1;
      if (found.captured(1) == QLatin1String("steps"))
        words += LessonValidation::tr("step %1").arg(number);
      else if (found.captured(1) == QLatin1String("choices"))
        words += LessonValidation::tr("choice %1").arg(number);
    } else if (const QString row = rowName(members[i]); !row.isEmpty()) {
      words += row;
    }
  }
  return words.join(QStringLiteral(", "));
}

/// Returns an error with its key in the words of the editor, where there are such words.
QString inEditorWords(const InputError& error) {
  const QString text = translatedText(InputError("", error.key(), error.message()).message());
  QString key = keyText(QString::fromStdString(error.key()));
  return key.isEmpty() ? text : key.replace(0, 1, key[0].toUpper()) + ": " + text;
}

// ---- Computed answers

/// Returns whether the program computes what a step asks for.
bool asksForNumber(const LessonStep& step) {
  return step.prediction &&
         (step.prediction->answer || step.prediction->kind == PredictionKind::Point);
}

/// Returns a step that asks for the number alone: what its texts and choices are has no influence.
LessonStep numberAsked(const LessonStep& step) {
  LessonStep asked;
  asked.scene = step.scene;
  LessonPrediction& prediction = asked.prediction.emplace();
  prediction.answer = step.prediction->answer;
  prediction.kind = PredictionKind::Number;
  if (step.prediction->kind != PredictionKind::Point) return asked;
  prediction.kind = PredictionKind::Point;
  prediction.x = step.prediction->x;
  asked.show.quantity = step.show.quantity;
  return asked;
}

/// Returns whether the picture of a step does not change with its answer, although the answer is
/// computed after changes of the scene.
bool keepsPicture(const LessonStep& step) {
  return step.prediction && step.prediction->answer && !step.prediction->answer->set.empty() &&
         step.after.empty();
}

}  // namespace

void LessonValidation::check(LessonDocument& document, int present, const QString& unreadable) {
  isComputing_ = false;
  isReadable_ = unreadable.isEmpty();
  error_ = unreadable.isEmpty() ? findMistake(document.lesson)
                                : tr("Step %1: %2").arg(present + 1).arg(unreadable);
  try {
    document.updateScenes();
    if (error_.isEmpty() && !checkAnswers(document.lesson, present)) stop();
  } catch (const InputError& error) {
    if (error_.isEmpty()) error_ = inEditorWords(error);
  }
}

QString LessonValidation::whyNotPlayed() const {
  return isComputing_ ? tr("The program computes an answer that no choice may cover…") : error_;
}

const LessonValidation::Computed* LessonValidation::computed(const LessonStep& step) const {
  if (!asksForNumber(step)) return nullptr;
  const auto found = std::ranges::find(computed_, numberAsked(step), &Computed::asked);
  return found == computed_.end() ? nullptr : &*found;
}

/// Computes the answer of a step in the background unless it is known. Returns whether it is being
/// computed.
bool LessonValidation::compute(const LessonStep& step) {
  if (!asksForNumber(step) || computed(step)) return false;
  const LessonStep asked = numberAsked(step);
  if (pending_ && pending_->asked == asked) return true;
  pending_ = Computed{asked};
  computing_.request(
      [asked](const BackgroundWork::Run& run) {
        CurveOptions options;
        options.stop = run.stop();
        return lessonAnswer(asked, options);
      },
      [this, asked](const LessonAnswer& answer) {
        keep({asked, answer});
      },
      [this, asked](const QString& reason) {
        keep({asked, {}, reason});
      });
  return true;
}

void LessonValidation::keep(Computed known) {
  pending_.reset();
  computed_.push_back(std::move(known));
  emit answerFound();
}

/// Shows an error where no choice covers a computed answer, or where there is none. Answers that
/// are not known yet are computed one after the other: those that may be covered by no choice,
/// without which the lesson is not played, and that of the present step, which is shown. Returns
/// whether one is being computed, or may be again as soon as an error is corrected.
bool LessonValidation::checkAnswers(const Lesson& lesson, int present) {
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    const Computed* known = computed(step);
    if (known && !known->failure.isEmpty()) {
      error_ = tr("Step %1, computed answer: %2").arg(i + 1).arg(known->failure);
      return true;
    }
    if (!step.prediction || !leavesOutNumbers(*step.prediction)) continue;
    if (compute(step)) {
      isComputing_ = true;
      return true;
    }
    try {
      rightChoice(*step.prediction, known->answer.number);
    } catch (const InputError& error) {
      error_ = inEditorWords(InputError(
          "", "steps[" + std::to_string(i) + "].prediction." + error.key(), error.message()));
      return true;
    }
  }
  return present >= 0 && compute(lesson.steps[static_cast<std::size_t>(present)]);
}

/// Stops the computation of an answer that nobody needs any more.
void LessonValidation::stop() {
  if (!pending_) return;
  pending_.reset();
  computing_.cancel();
}

void LessonValidation::forget() {
  stop();
  computed_.clear();
}

QString LessonValidation::computedText(const LessonStep& step) const {
  if (!asksForNumber(step)) return {};
  QStringList sentences;
  // There is always a first sentence: what is below would move when it comes.
  const Computed* known = isReadable_ ? computed(step) : nullptr;
  const bool isComputed = known && known->failure.isEmpty();
  QString found = isComputed ? fromUtf8(numberInWords(known->answer.number)) : QString();
  if (isComputed && step.prediction->kind == PredictionKind::Point)
    found = pointInWords(known->answer.number, known->answer.x);
  sentences += isComputed ? tr("The program finds %1.").arg(found)
               : known    ? tr("The program finds no answer.")
               : error_.isEmpty()
                   ? tr("The program computes the answer…")
                   : tr("The program computes the answer when the lesson is complete.");
  const QString tolerance = isReadable_ ? toleranceText(*step.prediction) : QString();
  if (!tolerance.isEmpty()) sentences += tolerance;
  if (step.scene.ensemble.realizations > 1)
    sentences += tr("Computed answers are means over the scene's %1 lines; the picture shows one.")
                     .arg(step.scene.ensemble.realizations);
  if (keepsPicture(step))
    sentences +=
        tr("The picture stays as it is when the answer is shown: “Changed with the answer” "
           "does not have the changes of the computed answer.");
  if (showsAnswer(step)) sentences += tr("The curve, which is in sight, may show this answer.");
  return sentences.join('\n');
}

QStringList missingTexts(const Lesson& lesson, bool inGerman) {
  QStringList missing;
  bool hasAny = false;
  const auto look = [&](const LessonText& text, const QString& name) {
    hasAny = hasAny || !(inGerman ? text.german : text.english).empty();
    if (!text.empty() && (inGerman ? text.german : text.english).empty()) missing += name;
  };
  look(lesson.title, LessonValidation::tr("title"));
  look(lesson.goal, LessonValidation::tr("goal"));
  look(lesson.notes, LessonValidation::tr("notes for teachers"));
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    const auto lookInStep = [&](const LessonText& text, const QString& name) {
      look(text, LessonValidation::tr("step %1").arg(i + 1) + QStringLiteral(", ") + name);
    };
    lookInStep(step.title, LessonValidation::tr("title"));
    lookInStep(step.text, LessonValidation::tr("text"));
    if (!step.prediction) continue;
    const LessonPrediction& prediction = *step.prediction;
    lookInStep(prediction.question, LessonValidation::tr("question"));
    for (std::size_t j = 0; j < prediction.choices.size(); ++j)
      lookInStep(prediction.choices[j].text, LessonValidation::tr("choice %1").arg(j + 1));
    lookInStep(prediction.right, LessonValidation::tr("if right"));
    lookInStep(prediction.wrong, LessonValidation::tr("if wrong"));
    lookInStep(step.reveal, LessonValidation::tr("said with the answer"));
  }
  return hasAny ? missing : QStringList();
}

bool showsAnswer(const LessonStep& step) {
  return step.show.tab == "curve" && !step.show.hidesCurve && step.prediction &&
         step.prediction->answer && isOnCurve(*step.prediction->answer, step);
}

}  // namespace asperity
