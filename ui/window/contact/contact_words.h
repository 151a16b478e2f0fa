// The state of the contact in words (core/run/contact_state.h) in a small window: a screen reader
// speaks it when it opens, and anybody can copy it. It belongs to the moment at which it was asked
// for; asking again renews it. Qt 6.4 has no announcements of its own, so the words are also the
// description of the picture. GUI thread; belongs to its parent.
#pragma once

#include <QDialog>
#include <QString>

class QPlainTextEdit;

namespace asperity {

class ContactCanvas;
class Session;

class ContactWords : public QDialog {
  Q_OBJECT

 public:
  /// Shows the state of the present frame over `window`, in the window that is open or a new one;
  /// nothing before the first frame.
  static void speak(const Session& session, ContactCanvas& canvas, QWidget& window);

  /// Returns one sentence in each line.
  QString text() const;

 private:
  ContactWords(const Session& session, ContactCanvas& canvas, QWidget* parent);
  void renew();

  const Session& session_;
  ContactCanvas& canvas_;
  QPlainTextEdit* text_;
};

}  // namespace asperity
