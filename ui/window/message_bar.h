// A line over the views for what went wrong: not modal, closed by its button or when all is well
// again. GUI thread.
#pragma once

#include <QFrame>

class QLabel;

namespace asperity {

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(const QString& text);
  QString text() const;

 private:
  QLabel* label_;
};

}  // namespace asperity
