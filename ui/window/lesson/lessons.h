// Lessons in the window: their list, the editor, and the lesson that runs (lesson_player.h), with
// the answers of the student. Answers are kept in a file of the student's choice, and until then in
// the user's settings, so that a crash does not lose them. Owned by the main window; GUI thread.
// Failure: the message bar shows the reason; the lesson, or the user's scene, stays. Kept answers
// that cannot be read again are as if they had never been kept.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <exception>
#include <functional>
#include <map>
#include <optional>

#include "ui/language/language.h"
#include "ui/window/lesson/lesson_player.h"

namespace asperity {

class LessonDocument;
class LessonEditor;
class LessonList;
class MessageBar;

class Lessons : public QObject {
  Q_OBJECT

 public:
  using Parts = LessonPlayer::Parts;
  Lessons(const Parts& parts, MessageBar& messages);

  void addTo(Commands& commands);

  /// Shows the page of all lessons.
  LessonList& showList();
  /// Returns the page on which a lesson is edited, also while a trial hides it; null without one.
  LessonEditor* editor() const;
  /// Shows the page on which a lesson is edited. `file`: of the lesson; empty: it has none.
  LessonEditor& showEditor(const Lesson& lesson, const QString& file);
  /// Shows the same page, or the lesson of an earlier session that was never saved if the user
  /// wants to go on with it.
  LessonEditor& openEditor(const Lesson& lesson, const QString& file);
  /// Closes the editor, and returns what opens it again as it was, to be called in another
  /// language.
  std::function<void()> closeEditorForReopening();

  /// Reads a lesson's file, or a shipped one by its name, and begins it; returns whether it did.
  /// Answers of an earlier session are offered, and the lesson goes on where it was left. Of a
  /// student's results it shows a summary, from which a known lesson goes on.
  bool open(const QString& nameOrFile);
  /// Shows the results of a class side by side; returns whether any file has results.
  bool openResults(const QStringList& files);

  /// Learning: answers count and are kept. Trial: a teacher tries a step in the editor.
  enum class Purpose { Learning, Trial };
  /// Begins a lesson at a step; it replaces the present one.
  void start(const Lesson& lesson, int step = 0, Purpose purpose = Purpose::Learning);
  /// Keeps the results in this file from now on, together with those of this lesson that are in it
  /// already. Returns false, with the reason in the message bar, where the file cannot be used.
  bool keepResults(const QString& file);
  /// Ends the lesson and brings the user's scene back.
  void end();
  /// Asks whether answers that are in no file are to be saved; returns whether the lesson may end.
  bool mayLeave();
  /// Asks the same about answers and about the lesson in the editor; returns whether the window may
  /// close.
  bool canClose();
  /// Closes the editor without a question, and ends the lesson.
  void close();

  /// Returns the lesson that runs, if one does.
  LessonPlayer& player() { return *player_; }

 signals:
  /// Emitted when a step or its answer is shown.
  void stepShown();

 private:
  LessonEditor& makeEditor(const LessonDocument& document);
  void hideDuringLesson(LessonEditor& editor);
  /// The answer by which the user does not go on: its consequence, and the text of its button.
  struct Refusal {
    QString consequence, button;
  };
  bool wantsToGoOn(const QString& name, const QString& question, const Refusal& refusal) const;
  static Refusal discards();
  LiveText failureText(const QString& file, const std::exception& error) const;
  QString offerAnswers(const Lesson& lesson);
  QString offerSavedAnswers(const Lesson& lesson);
  void goOn(const Lesson& lesson, const LessonResults& results, const QString& file);
  bool hasUnsavedAnswers() const;
  void keepUnsavedAnswers() const;
  void leave();
  void askResults();
  void askResultsFile();
  QString resultsName() const;
  bool saveAnswers(const QString& file);
  void setResultsFile(const QString& file);
  /// Returns whether the next session goes on with the lesson: it has a file, and is no trial.
  bool isRemembered() const { return !player_->isTrial() && !player_->lesson()->digest.empty(); }

  Parts parts_;
  MessageBar& messages_;
  LessonPlayer* player_;
  Lesson written_;  // the lesson that runs, as it was written
  QString file_;    // of the lesson; empty: a shipped one, or one that was never saved
  QString resultsFile_;
  bool isSaved_ = false;  // the file has the answers, or the student does not want them
  /// Answers of lessons that were left for another scene, by the digest of the lesson.
  std::map<std::string, LessonResults> left_;
};

/// Returns the answers to this lesson that an earlier session kept; nothing where there are none.
std::optional<LessonResults> keptAnswers(const Lesson& lesson);

}  // namespace asperity
