// The page on which a teacher writes a lesson: steps are added from what the window shows, and
// their texts, order, free controls and predictions are edited. Everything is checked as a file
// would be, whenever it changes; it can be tried at once. GUI thread. Failure: one line says what
// is wrong and where; nothing of it is saved meanwhile.
#pragma once

#include <QDialog>
#include <QString>
#include <functional>

#include "core/lesson/lesson_file.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QTabBar;
class QTableWidget;
class QToolButton;

namespace asperity {

class LessonEditor : public QDialog {
  Q_OBJECT

 public:
  /// file: where it is saved; empty: asks. shownNow: a step with what the window shows.
  LessonEditor(const Lesson& lesson, const QString& file, std::function<LessonStep()> shownNow,
               QWidget* parent);

  /// The lesson as it is on the page, which may not be right yet.
  const Lesson& lesson() const { return lesson_; }
  /// What is wrong; empty where nothing is.
  QString complaint() const { return complaint_; }

  void addShownStep();
  void removeStep();
  void moveStep(int by);
  /// Returns whether it was written.
  bool saveTo(const QString& file);
  /// Asks where changes would be lost.
  bool mayClose();

 signals:
  void tryWanted(const asperity::Lesson& lesson, int step);

 protected:
  void reject() override;

 private:
  QWidget* buildSteps();
  QWidget* buildHead();
  QWidget* buildStep();
  QLayout* buildFoot();
  QLineEdit* addLine(QFormLayout& form, const QString& label, const char* name);
  QPlainTextEdit* addText(QFormLayout& form, const QString& label, const char* name, int lines);
  void fillControls();
  void showList();
  void showStep();
  void showKind();
  void take();
  void check();
  Lesson checked() const;
  void openOther();
  LessonText& withLanguage(LessonText& text, const QString& written) const;
  QString inLanguage(const LessonText& text) const;
  LessonStep* present();
  void takePrediction(LessonStep& step);
  LessonValue takenValue() const;
  bool isGerman() const;

  Lesson lesson_;
  Lesson saved_;
  QString file_, complaint_;
  std::function<LessonStep()> shownNow_;
  bool isShowing_ = false;  // the page is being filled

  QListWidget* steps_;
  QTabBar* language_;
  QStackedWidget* pages_;
  QLineEdit *title_, *stepTitle_, *set_, *after_, *question_, *valueSet_, *tolerance_, *x_, *right_,
      *wrong_;
  QPlainTextEdit *goal_, *notes_, *text_, *reveal_;
  QSpinBox* minutes_;
  QComboBox *tab_, *quantity_, *kind_, *column_, *value_;
  QCheckBox* hides_;
  QToolButton* controls_;
  QTableWidget* choices_;
  QFormLayout* stepForm_;
  QLabel* said_;
  QPushButton *add_, *remove_, *up_, *down_, *try_, *open_, *save_, *close_;
};

}  // namespace asperity
