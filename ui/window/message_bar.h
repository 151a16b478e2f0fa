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

  /// Of the present scene: leaves with endComplaint(), which does nothing to other messages.
  void showComplaint(const QString& text);
  void endComplaint();

  /// With a button that takes up the offer.
  void showOffer(const QString& text, const QString& button);
  QString text() const;
  bool isComplaint() const { return isComplaint_; }

 signals:
  void accepted();
  void closed();  // by its button

 private:
  QLabel* label_;
  QPushButton* accept_;
  bool isComplaint_ = false;
};

}  // namespace asperity
