// A translucent veil over the contact, with a text in its middle that shows why the picture is not
// that of the present scene. GUI thread; owned by the canvas. Cannot fail.
#pragma once

#include <QLabel>

#include "ui/draw/theme.h"

namespace asperity {

class ContactVeil : public QLabel {
 public:
  explicit ContactVeil(QWidget& canvas);

  /// Covers the picture; an empty reason uncovers it.
  void showReason(const QString& reason);
  /// Takes the colours of the picture.
  void setTheme(const Theme& theme);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace asperity
