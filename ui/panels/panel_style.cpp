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

QString styleSheet(QString rules, const QPalette& palette,
                   std::initializer_list<std::pair<const char*, QString>> others) {
  const auto fill = [&rules](const char* name, const QString& value) {
    rules.replace('@' + QString(name), value);
  };
  for (const auto& [name, role] : {std::pair{"window", QPalette::Window},
                                   {"text", QPalette::WindowText},
                                   {"faint", QPalette::PlaceholderText},
                                   {"base", QPalette::Base},
                                   {"edge", QPalette::Mid},
                                   {"accent", QPalette::Highlight}})
    fill(name, palette.color(role).name());
  fill("error", errorColour(palette).name());
  fill("warning", warningColour(palette).name());
  for (const auto& [name, value] : others) fill(name, value);
  return rules;
}

QString panelStyleSheet(const QPalette& palette) {
  return styleSheet(QStringLiteral(R"(
    QScrollArea, #parameterRows { background: @window; }
    QLabel[role="heading"] { font-weight: bold; color: @text; }
    QLabel[role="unit"] { color: @faint; }
    #panelBar { background: @window; border-bottom: 1px solid @edge; }
    QToolButton[role^="segment"] { border: 1px solid @edge; background: transparent; color: @faint;
                                   padding: 1px 9px; min-height: 19px; }
    QToolButton[role="segmentLeft"] { border-top-left-radius: 5px;
                                      border-bottom-left-radius: 5px; }
    QToolButton[role="segmentRight"] { border-top-right-radius: 5px; border-left: none;
                                       border-bottom-right-radius: 5px; }
    QToolButton[role^="segment"]:checked { background: @base; color: @text; font-weight: bold; }
    QToolButton[role^="segment"]:hover { color: @text; }
    QToolButton[role^="segment"]:focus { color: @accent; }
    QLineEdit { background: @base; border: 1px solid @edge; border-radius: 5px;
                padding: 1px 5px; min-height: 19px; }
    QPlainTextEdit { background: @base; border: 1px solid @edge; border-radius: 5px;
                     padding: 0px 1px; }
    QLineEdit:focus, QPlainTextEdit:focus { border-color: @accent; }
    QLineEdit[refused="true"] { border: 2px solid @error; padding: 0px 4px; }
    QLineEdit:disabled { background: transparent; color: @faint; }
    QToolButton[role="browse"] { border: 1px solid @edge; border-radius: 5px; background: @base;
                                 color: @text; padding: 1px 7px; min-height: 19px; }
    QToolButton[role="browse"]:hover, QToolButton[role="browse"]:focus { border-color: @accent; }
    QToolButton[role="browse"]:disabled { background: transparent; color: @faint; }
    QToolButton[role="remove"] { border: 1px solid transparent; border-radius: 5px;
                                 background: transparent; color: @faint; }
    QToolButton[role="remove"]:hover { color: @error; }
    QToolButton[role="remove"]:focus { border-color: @accent; }
    QToolButton[role="remove"]:disabled { color: transparent; }
    QToolButton[role="reset"] { border: none; background: transparent; color: @faint; }
    QToolButton[role="reset"]:hover { color: @accent; }
    QToolButton[role="reset"]:disabled { color: transparent; }
  )"),
                    palette) +
         messageStyleSheet(palette);
}

QString messageStyleSheet(const QPalette& palette) {
  return styleSheet(QStringLiteral(R"(
    QLabel[role="error"] { color: @error; padding-bottom: 3px; }
    QLabel[role="note"] { color: @accent; }
    QLabel[role="warning"] { color: @warning; padding-bottom: 3px; }
  )"),
                    palette);
}

void setStyleProperty(QWidget& widget, const char* name, const QVariant& value) {
  if (widget.property(name) == value) return;
  widget.setProperty(name, value);
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
}

}  // namespace asperity
