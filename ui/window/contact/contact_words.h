// The state of the contact in words (core/run/contact_report.h) in a small window: screen readers
// read it when it opens, and it can be copied. It describes the moment at which it was requested;
// another request updates it. Qt 6.4 has no accessible announcements, so the text is also the
// accessible description of the picture. GUI thread; owned by its parent.
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
  static void showFor(const Session& session, ContactCanvas& canvas, QWidget& window);

  /// Returns one sentence in each line.
  QString text() const;

 private:
  ContactWords(const Session& session, ContactCanvas& canvas, QWidget* parent);
  void refresh();

  const Session& session_;
  ContactCanvas& canvas_;
  QPlainTextEdit* text_;
};

}  // namespace asperity
