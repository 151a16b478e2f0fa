// The control with which a student answers the question of a step: choices, or a number with its
// unit. It holds what is entered and not checked yet. GUI thread; owned by its parent. Cannot fail.
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "core/lesson/lesson_answers.h"

class QButtonGroup;
class QLineEdit;

namespace asperity {

class AnswerInput : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  /// Returns what is entered, which may be no answer yet; empty where nothing is. enter() enters it
  /// again, in a control for the same question, which may be in another language.
  virtual QString entry() const = 0;
  virtual void enter(const QString& entry) = 0;
  /// Returns the answer; nothing where the entry cannot be read, for which refusal() has the
  /// reason.
  virtual std::optional<GivenAnswer> answer() const = 0;
  virtual QString refusal() const { return {}; }
  /// Returns the controls that take the focus, in their order.
  virtual QWidgetList controls() const = 0;

 signals:
  void edited();
  /// Emitted with how an entry is read that may be meant otherwise; empty for any other entry.
  void readAs(const QString& text);
  /// Emitted when the student presses Return to go on.
  void returnPressed();
};

class ChoiceInput : public AnswerInput {
  Q_OBJECT

 public:
  /// answer, given: once the answer is known, the right choice and a wrong given one are marked,
  /// and none can be chosen; null before.
  ChoiceInput(const LessonPrediction& prediction, const LessonAnswer* answer,
              const GivenAnswer* given);

  QString entry() const override;
  void enter(const QString& entry) override;
  std::optional<GivenAnswer> answer() const override;
  QWidgetList controls() const override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void setStyle();

  QButtonGroup* choices_;
};

class NumberInput : public AnswerInput {
  Q_OBJECT

 public:
  explicit NumberInput(const std::string& unit);

  QString entry() const override;
  void enter(const QString& entry) override;
  std::optional<GivenAnswer> answer() const override;
  QString refusal() const override;
  QWidgetList controls() const override;

 private:
  QString reading(const QString& typed) const;

  QLineEdit* number_;
  std::string unit_;
  QString entry_;  // as it was read when it was typed: with a decimal point, without groups
};

}  // namespace asperity
