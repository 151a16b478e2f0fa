#include "ui/window/lesson/kept_lessons.h"

#include <QSettings>
#include <QString>

#include "core/base/input_error.h"
#include "core/lesson/lesson_file.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

const QString kDraft = QStringLiteral("lessonDraft");

QString answersKey(const std::string& digest) {
  return QStringLiteral("lessonAnswers/") + QString::fromStdString(digest);
}

/// Writes to the disk at once: the program may be killed.
void store(const QString& key, const std::string& text) {
  QSettings settings;
  settings.setValue(key, QString::fromStdString(text));
  settings.sync();
}

/// Removes a key with those below it.
void forget(const QString& key) {
  QSettings settings;
  settings.remove(key);
  settings.sync();
}

}  // namespace

void keepAnswers(const LessonResults& results) {
  if (!results.digest.empty()) store(answersKey(results.digest), resultsJson(results));
}

std::optional<LessonResults> keptAnswers(const Lesson& lesson) {
  const QString kept = QSettings().value(answersKey(lesson.digest)).toString();
  if (lesson.digest.empty() || kept.isEmpty()) return std::nullopt;
  try {
    LessonResults results = parseResults(kept.toStdString(), {});
    if (results.digest != lesson.digest || results.results.empty()) return std::nullopt;
    for (const LessonResult& one : results.results)
      if (one.step >= static_cast<int>(lesson.steps.size()) ||
          !lesson.steps[static_cast<std::size_t>(one.step)].prediction)
        return std::nullopt;
    return results;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void forgetAnswers(const Lesson& lesson) {
  if (!lesson.digest.empty()) forget(answersKey(lesson.digest));
}

void keepDraft(const LessonDraft& draft, const std::string& folder) {
  const std::string text = writeLesson(draft.lesson);
  try {
    readDraft(text, draft.lesson.name, folder, readNamedScene);
  } catch (const InputError&) {
    return;
  }
  QSettings settings;
  settings.beginGroup(kDraft);
  settings.setValue("lesson", QString::fromStdString(text));
  settings.setValue("saved", QString::fromStdString(writeLesson(draft.saved)));
  settings.setValue("name", QString::fromStdString(draft.lesson.name));
  settings.setValue("file", QString::fromStdString(draft.file));
  settings.setValue("folder", QString::fromStdString(folder));
  settings.sync();
}

std::optional<LessonDraft> keptDraft() {
  QSettings settings;
  settings.beginGroup(kDraft);
  const auto text = [&](const char* key) { return settings.value(key).toString().toStdString(); };
  if (text("lesson").empty()) return std::nullopt;
  try {
    const auto read = [&](const char* key) {
      return readDraft(text(key), text("name"), text("folder"), readNamedScene);
    };
    LessonDraft draft{read("lesson"), {}, text("file")};
    try {
      draft.saved = read("saved");
    } catch (const InputError&) {
      // What was saved is of no use any more: the draft differs from it.
    }
    return draft;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void forgetDraft() {
  forget(kDraft);
}

}  // namespace asperity
