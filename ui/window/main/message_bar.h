// A bar over the views for error messages. It is not modal, and closes by its button or when the
// error is over. A message about the scene reappears when another message that replaced it is
// removed. GUI thread; owned by its parent.
#pragma once

#include <QFrame>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/message.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace asperity {

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(const QString& text);

  /// The sources of errors. end() removes a message once its source succeeds again; end() returns
  /// whether the message was visible.
  enum class Failure { None, Scene, Files, Export, Comparison };
  void showFailure(Failure source, const QString& text);
  bool end(Failure source);

  /// Shows an error of the scene until sceneRuns(): a key, which may be empty, and core's English
  /// message.
  void showSceneError(const QString& key, const Message& english);
  void sceneRuns();
  /// Hides every message, because another scene was opened.
  void forget();

  /// Shows an offer and a button that accepts it. Both texts are requested again in another
  /// language.
  using Text = std::function<QString()>;
  void showOffer(Text text, Text button);
  const QString& text() const { return text_; }

 signals:
  void accepted();
  void closed();  // the user pressed the button that closes it
  /// Emitted with the translated message about the scene when it appears or changes.
  void sceneErrorShown(const QString& key, const QString& text);

 private:
  void updateSceneError();
  void showTexts();
  void showText(const QString& text);

  QLabel* label_;
  QPushButton* accept_;
  QToolButton* close_;
  QString text_;
  Text offer_, offerButton_;
  Failure failure_ = Failure::None;
  std::optional<std::pair<QString, Message>> sceneError_;  // key and text
};

}  // namespace asperity
