// A line over the views for what went wrong: not modal, closed by its button or when all is well
// again. GUI thread.
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

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

  /// With a button that takes up the offer.
  void showOffer(const QString& text, const QString& button);
  QString text() const;
  Failure failure() const { return failure_; }

 signals:
  void accepted();
  void closed();  // by its button

 private:
  QLabel* label_;
  QPushButton* accept_;
  Failure failure_ = Failure::None;
};

}  // namespace asperity
