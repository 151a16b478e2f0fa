#include "ui/panels/panel_style.h"

#include <QPalette>

namespace asperity {

QString panelStyleSheet(const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightness() < 128;
  const auto name = [&](QPalette::ColorRole role) { return palette.color(role).name(); };
  return QStringLiteral(R"(
    QScrollArea, #parameterRows { background: %1; }
    QLabel[role="heading"] { font-weight: bold; color: %2; }
    QLabel[role="unit"] { color: %3; }
    QLabel[role="error"] { color: %4; }
    QLabel[role="note"] { color: %7; }
    QLineEdit { background: %5; color: %2; border: 1px solid %6; border-radius: 5px;
                padding: 1px 5px; min-height: 19px; }
    QPlainTextEdit { background: %5; color: %2; border: 1px solid %6; border-radius: 5px;
                     padding: 0px 1px; }
    QLineEdit:focus, QPlainTextEdit:focus { border-color: %7; }
    QLineEdit[refused="true"] { border: 2px solid %4; padding: 0px 4px; }
    QLineEdit:disabled { background: transparent; color: %3; }
    QToolButton[role="browse"] { border: 1px solid %6; border-radius: 5px; background: %5;
                                 color: %2; padding: 1px 7px; min-height: 19px; }
    QToolButton[role="browse"]:hover, QToolButton[role="browse"]:focus { border-color: %7; }
    QToolButton[role="browse"]:disabled { background: transparent; color: %3; }
    QToolButton[role="remove"] { border: 1px solid transparent; border-radius: 5px;
                                 background: transparent; color: %3; }
    QToolButton[role="remove"]:hover { color: %4; }
    QToolButton[role="remove"]:focus { border-color: %7; }
    QToolButton[role="remove"]:disabled { color: transparent; }
    QToolButton[role="reset"] { border: none; background: transparent; color: %3; }
    QToolButton[role="reset"]:hover { color: %7; }
    QToolButton[role="reset"]:disabled { color: transparent; }
  )")
      .arg(name(QPalette::Window), name(QPalette::WindowText), name(QPalette::PlaceholderText),
           dark ? QStringLiteral("#ff7b72") : QStringLiteral("#c62828"), name(QPalette::Base),
           name(QPalette::Mid), name(QPalette::Highlight));
}

}  // namespace asperity
