#include "ui/panels/panel_style.h"

#include <QPalette>
#include <QStyle>
#include <QWidget>

namespace asperity {

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QColor errorColour(const QPalette& palette) {
  return isDark(palette) ? QColor(0xff, 0x7b, 0x72) : QColor(0xc6, 0x28, 0x28);
}

QColor warningColour(const QPalette& palette) {
  return isDark(palette) ? QColor(0xe3, 0xb3, 0x41) : QColor(0x8a, 0x5a, 0x00);
}

QString panelStyleSheet(const QPalette& palette) {
  const auto name = [&](QPalette::ColorRole role) { return palette.color(role).name(); };
  return QStringLiteral(R"(
    QScrollArea, #parameterRows { background: %1; }
    QLabel[role="heading"] { font-weight: bold; color: %2; }
    QLabel[role="unit"] { color: %3; }
    #panelBar { background: %1; border-bottom: 1px solid %6; }
    QToolButton[role^="segment"] { border: 1px solid %6; background: transparent; color: %3;
                                   padding: 1px 9px; min-height: 19px; }
    QToolButton[role="segmentLeft"] { border-top-left-radius: 5px;
                                      border-bottom-left-radius: 5px; }
    QToolButton[role="segmentRight"] { border-top-right-radius: 5px; border-left: none;
                                       border-bottom-right-radius: 5px; }
    QToolButton[role^="segment"]:checked { background: %5; color: %2; font-weight: bold; }
    QToolButton[role^="segment"]:hover { color: %2; }
    QToolButton[role^="segment"]:focus { color: %7; }
    QLineEdit { background: %5; border: 1px solid %6; border-radius: 5px;
                padding: 1px 5px; min-height: 19px; }
    QPlainTextEdit { background: %5; border: 1px solid %6; border-radius: 5px;
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
             .arg(name(QPalette::Window), name(QPalette::WindowText),
                  name(QPalette::PlaceholderText), errorColour(palette).name(),
                  name(QPalette::Base), name(QPalette::Mid), name(QPalette::Highlight)) +
         messageStyleSheet(palette);
}

QString messageStyleSheet(const QPalette& palette) {
  return QStringLiteral(R"(
    QLabel[role="error"] { color: %1; padding-bottom: 3px; }
    QLabel[role="note"] { color: %2; }
    QLabel[role="warning"] { color: %3; padding-bottom: 3px; }
  )")
      .arg(errorColour(palette).name(), palette.color(QPalette::Highlight).name(),
           warningColour(palette).name());
}

void setStyleProperty(QWidget& widget, const char* name, const QVariant& value) {
  if (widget.property(name) == value) return;
  widget.setProperty(name, value);
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
}

}  // namespace asperity
