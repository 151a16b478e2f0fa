#include "ui/window/lesson/lesson_document.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/scene_assignments.h"
#include "core/scene/scene_file.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

const QString kDraft = QStringLiteral("lessonDraft");

/// Returns the assignments of two lists, of which the second one replaces those of the same keys.
std::vector<std::string> joined(std::vector<std::string> set,
                                const std::vector<std::string>& more) {
  for (const std::string& one : more) {
    std::erase_if(set,
                  [&](const std::string& old) { return assignmentKey(old) == assignmentKey(one); });
    set.push_back(one);
  }
  return set;
}

}  // namespace

bool LessonDocument::isChanged() const {
  return writeLesson(saved_) != writeLesson(lesson);
}

/// Returns the folder of the lesson's file, in which its scenes are. Without a file it is that of
/// the shipped scenes for a shipped lesson, and empty for a new one, which names no scenes.
std::filesystem::path LessonDocument::folder() const {
  const bool isShipped = file_.isEmpty() && findShipped(shippedLessons(), lesson.name);
  return isShipped ? std::filesystem::path(kShippedFolder)
                   : std::filesystem::path(file_.toStdString()).parent_path();
}

Lesson LessonDocument::read() const {
  return readLesson(writeLesson(lesson), lesson.name, folder(), readNamedScene);
}

void LessonDocument::updateScenes() {
  try {
    takeScenes(read());
  } catch (const InputError&) {
    try {
      takeScenes(readDraft(writeLesson(lesson), lesson.name, folder(), readNamedScene));
    } catch (const InputError&) {
      // The scenes stay as they are.
    }
    throw;
  }
}

void LessonDocument::takeScenes(const Lesson& read) {
  for (std::size_t i = 0; i < read.steps.size(); ++i) {
    lesson.steps[i].scene = read.steps[i].scene;
    lesson.steps[i].revealedScene = read.steps[i].revealedScene;
  }
}

// ---- Steps

/// Gives a step that goes on from the one before a scene of its own, so that it stays the same
/// wherever it stands; its changes stay changes.
void LessonDocument::keepOwnScene(std::size_t step) {
  if (step == 0 || step >= lesson.steps.size() || lesson.steps[step].hasOwnScene()) return;
  lesson.steps[step].sceneJson = writeScene(lesson.steps[step - 1].revealedScene);
}

void LessonDocument::insertStep(std::size_t place, LessonStep step) {
  bool isExpressed = false;
  if (place > 0) {
    Scene before = lesson.steps[place - 1].revealedScene, scene = step.scene;
    if (before.folder == kShippedFolder) before.folder.clear();  // it holds no files
    scene.title = before.title;
    scene.description = before.description;
    scene.chapter = before.chapter;
    step.set = differingAssignments(before, scene);
    try {
      isExpressed = withKeys(before, step.set) == scene && before.folder == scene.folder;
    } catch (const InputError&) {
      // The step has a scene of its own.
    }
  }
  if (!isExpressed) {
    step.set.clear();
    step.sceneJson = writeScene(step.scene);
  }
  keepOwnScene(place);  // the next step would go on from another scene now
  lesson.steps.insert(lesson.steps.begin() + static_cast<std::ptrdiff_t>(place), std::move(step));
}

void LessonDocument::removeStep(std::size_t place) {
  const LessonStep removed = lesson.steps[place];
  const bool isContinued =
      place + 1 < lesson.steps.size() && !lesson.steps[place + 1].hasOwnScene();
  keepOwnScene(place + 1);
  lesson.steps.erase(lesson.steps.begin() + static_cast<std::ptrdiff_t>(place));
  if (!isContinued) return;
  LessonStep& after = lesson.steps[place];
  const LessonStep own = after;
  after.sceneName = removed.sceneName;
  after.sceneJson = removed.sceneJson;
  after.set = joined(joined(removed.set, removed.after), own.set);
  try {
    if (read().steps[place].scene == own.scene) return;
  } catch (const InputError&) {
    // It has a scene of its own.
  }
  after = own;
}

/// Steps that went on from the one before keep the scenes that they had.
void LessonDocument::swapSteps(std::size_t one, std::size_t other) {
  const std::size_t first = std::min(one, other);
  for (std::size_t i = first; i < first + 3; ++i) keepOwnScene(i);
  std::swap(lesson.steps[one], lesson.steps[other]);
}

void LessonDocument::setScene(std::size_t place, const Scene& scene) {
  keepOwnScene(place + 1);
  LessonStep& step = lesson.steps[place];
  step.sceneName.clear();
  step.sceneJson = writeScene(scene);
  step.set.clear();
}

// ---- Undo and redo

bool LessonDocument::remember(int row, const QString& field) {
  if (writeLesson(states_[state_].lesson) == writeLesson(lesson)) return false;
  const bool isSameEdit = !field.isEmpty() && state_ > 0 && states_[state_].field == field &&
                          states_[state_].row == row;
  states_.resize(state_ + (isSameEdit ? 0 : 1));
  states_.push_back({lesson, row, field});
  state_ = states_.size() - 1;
  return true;
}

int LessonDocument::undo() {
  const int row = states_[state_].row;
  restore(state_ - 1);
  return row;
}

int LessonDocument::redo() {
  restore(state_ + 1);
  return states_[state_].row;
}

void LessonDocument::restore(std::size_t state) {
  state_ = state;
  states_[state_].field.clear();  // what is typed now is another edit
  lesson = states_[state_].lesson;
}

// ---- Files

void LessonDocument::open(const QString& file) {
  *this = LessonDocument(readDraftFile(file.toStdString(), readNamedScene), file);
}

void LessonDocument::save(const QString& file) {
  const std::filesystem::path path = std::filesystem::absolute(file.toStdString());
  const std::string text = writeLesson(lesson);
  readDraft(text, path.string(), path.parent_path(), readNamedScene);
  writeFileAtomically(path, text);
  file_ = file;
  saved_ = lesson;
}

void LessonDocument::keep() const {
  if (!isChanged()) return forgetDraft();
  const std::string text = writeLesson(lesson);
  try {
    readDraft(text, lesson.name, folder(), readNamedScene);
  } catch (const InputError&) {
    return;
  }
  QSettings settings;
  settings.beginGroup(kDraft);
  settings.setValue("lesson", QString::fromStdString(text));
  settings.setValue("saved", QString::fromStdString(writeLesson(saved_)));
  settings.setValue("name", QString::fromStdString(lesson.name));
  settings.setValue("file", file_.isEmpty() ? QString() : QFileInfo(file_).absoluteFilePath());
  settings.setValue("folder", QString::fromStdString(folder().string()));
  settings.sync();  // to the disk at once: the program may be killed
}

std::optional<LessonDocument> keptDraft() {
  QSettings settings;
  settings.beginGroup(kDraft);
  const auto text = [&](const char* key) { return settings.value(key).toString().toStdString(); };
  const auto read = [&](const char* key) -> std::optional<Lesson> {
    try {
      return readDraft(text(key), text("name"), text("folder"), readNamedScene);
    } catch (const InputError&) {
      return std::nullopt;
    }
  };
  const std::optional<Lesson> draft = text("lesson").empty() ? std::nullopt : read("lesson");
  if (!draft) return std::nullopt;
  // Where the saved lesson cannot be read any more, the draft differs from it.
  LessonDocument document(read("saved").value_or(Lesson{}), settings.value("file").toString());
  document.lesson = *draft;
  return document;
}

void forgetDraft() {
  QSettings settings;
  settings.remove(kDraft);
  settings.sync();
}

}  // namespace asperity
