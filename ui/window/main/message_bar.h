// A bar over the views for error messages, and in other colours for notes. It is not modal, and
// closes by its button or when the error is over. A message about the scene reappears when another
// message that replaced it is removed. A limit of lines shortens a long text; a button then shows
// all of it. GUI thread; owned by its parent.
#pragma once

#include <QFrame>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/message.h"
#include "ui/language/language.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace asperity {

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  /// Shows a text, which follows the language like all texts of the bar.
  void showMessage(const LiveText& text);
  /// Shows what is no error.
  void showNote(const LiveText& text);

  /// Shows at most this many lines of a text until the user asks for more; 0: all.
  void setLineLimit(int lines);

  /// The sources of errors. end() removes a message once its source succeeds again; end() returns
  /// whether the message was visible.
  enum class Failure { None, Scene, Files, Export, Comparison };
  void showFailure(Failure source, const LiveText& text);
  /// Returns a function that does the same with the reason that it is given, for BackgroundWork.
  std::function<void(const LiveText& reason)> failureReporter(Failure source);
  bool end(Failure source);
  /// Runs what may throw: shows why it fails, or removes the message of its source. Returns whether
  /// it succeeded.
  bool succeeds(Failure source, const std::function<void()>& action);

  /// Shows an error of the scene until sceneRuns(): a key, which may be empty, and core's English
  /// message.
  void showSceneError(const QString& key, const Message& english);
  void sceneRuns();
  /// Hides every message, because another scene was opened.
  void forget();

  /// Shows an offer and a button that accepts it.
  void showOffer(const LiveText& text, const LiveText& button);
  const QString& text() const { return text_; }

 signals:
  void accepted();
  void closed();  // the user pressed the button that closes it
  /// Emitted for the parameter that a message about the scene names, with the text to show there.
  /// The text refers to the bar while the bar shows the message; otherwise it is the message.
  void sceneErrorShown(const QString& key, const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void updateSceneError();
  void markParameter();
  void showTexts();
  void showText(const LiveText& text);
  void setNote(bool isNote);
  void fitText();

  QLabel* label_;
  QToolButton* more_;
  QPushButton* accept_;
  QToolButton* close_;
  LiveText source_;  // of the text
  QString text_;
  LiveText offerButton_;
  Failure failure_ = Failure::None;
  int lineLimit_ = 0;                                      // 0: none
  bool showsAll_ = false;                                  // because the user asked for it
  std::optional<std::pair<QString, Message>> sceneError_;  // key and text
};

}  // namespace asperity
