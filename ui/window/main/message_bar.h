// A line over the views for what went wrong: not modal, closed by its button or when all is well
// again. What is wrong with the scene comes back when another message that covered it leaves. GUI
// thread; belongs to its parent.
#pragma once

#include <QFrame>
#include <functional>
#include <optional>
#include <utility>

class QLabel;
class QPushButton;
class QToolButton;

#include "core/base/message.h"

namespace asperity {

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(const QString& text);

  /// What failed. Its message leaves with end(), once that goes well again; end() says whether it
  /// was to be seen.
  enum class Failure { None, Scene, Files, Export, Comparison };
  void showFailure(Failure of, const QString& text);
  bool end(Failure of);

  /// What is wrong with the scene, until sceneRuns(): a key, which may be empty, and core's
  /// English.
  void complain(const QString& key, const Message& english);
  void sceneRuns();
  /// Hides every message, because another scene was opened.
  void forget();

  /// Shows an offer and a button that takes it up. Both texts are asked for again in another
  /// language.
  using Text = std::function<QString()>;
  void showOffer(Text text, Text button);
  QString text() const;

 signals:
  void accepted();
  void closed();  // by its button
  /// The complaint about the scene was said, the first time or anew; translated.
  void complained(const QString& key, const QString& text);

 private:
  void showComplaint();
  void showTexts();

  QLabel* label_;
  QPushButton* accept_;
  QToolButton* close_;
  Text offer_, offerButton_;
  Failure failure_ = Failure::None;
  std::optional<std::pair<QString, Message>> complaint_;  // key and text
};

}  // namespace asperity
