// The lesson in the editor as a document: as it is and as it was saved, its file, and its edits,
// which can be undone. Steps keep their scenes where others are added, moved or removed. What is in
// no file is kept in the user's settings, so that a crash does not lose it, until it is saved or
// discarded. GUI thread. Failure: InputError for what is no lesson; a kept draft that cannot be
// read again is as if it had never been kept.
#pragma once

#include <QString>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/lesson/lesson_file.h"

namespace asperity {

class LessonDocument {
 public:
  /// The lesson after an edit of the step in a row of the editor's list.
  struct State {
    Lesson lesson;
    int row = 0;
    QString field{};  // name of the field in which it was typed; empty: a button, a list or a table
  };

  /// file: the file of the lesson; empty: it has none.
  LessonDocument(const Lesson& saved, const QString& file)
      : lesson(saved), file_(file), saved_(saved), states_{{saved}} {}

  /// The lesson as it is on the page, which may still have errors.
  Lesson lesson;

  const QString& file() const { return file_; }
  /// Returns whether the lesson differs from what was saved.
  bool isChanged() const;
  /// Returns the lesson as its file would be read. Throws InputError with the first mistake.
  Lesson read() const;
  /// Gives the steps the scenes that they have in the lesson as it would be read. Throws InputError
  /// where it has a mistake; the steps then have their scenes in a draft, where it is one.
  void updateScenes();

  /// Inserts a step that begins with its scene: as changes of the scene that the step before leaves
  /// where these can express it.
  void insertStep(std::size_t place, LessonStep step);
  /// Removes a step. The one after it begins where the removed one began, with the changes of both,
  /// where that is the same scene; else it has a scene of its own.
  void removeStep(std::size_t place);
  void swapSteps(std::size_t one, std::size_t other);
  void setScene(std::size_t place, const Scene& scene);

  /// Keeps the lesson for undo. What is typed into one field without a break is one edit. Returns
  /// whether it had changed.
  bool remember(int row, const QString& field);
  bool canUndo() const { return state_ > 0; }
  bool canRedo() const { return state_ + 1 < states_.size(); }
  /// Goes back or forward by one edit, and returns the row of the step that it changed.
  int undo();
  int redo();

  /// Reads a lesson in place of the present one. Throws InputError, which leaves it as it is.
  void open(const QString& file);
  /// Writes the lesson, which may be a draft. Throws InputError or std::runtime_error.
  void save(const QString& file);

  /// Keeps a changed lesson against a crash, in place of the one before; an unchanged one is
  /// forgotten. A lesson that could not be read again is not kept: the one before stays.
  void keep() const;

 private:
  std::filesystem::path folder() const;
  void takeScenes(const Lesson& read);
  void keepOwnScene(std::size_t step);
  void restore(std::size_t state);

  QString file_;
  Lesson saved_;
  std::vector<State> states_;  // of the lesson, for undo and redo
  std::size_t state_ = 0;      // the present one
};

/// Returns the lesson of an earlier session that was changed and not saved; nothing without one.
std::optional<LessonDocument> keptDraft();
void forgetDraft();

}  // namespace asperity
