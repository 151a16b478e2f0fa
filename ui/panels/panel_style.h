// The style of panels, and the colours of errors and warnings everywhere in a window. GUI thread.
// Cannot fail.
#pragma once

#include <QColor>
#include <QString>
#include <QVariant>
#include <initializer_list>
#include <utility>

class QPalette;
class QWidget;

namespace asperity {

/// Returns whether the windows of a palette are dark.
bool isDark(const QPalette& palette);

/// Returns the colour of error messages, legible on the palette's background.
QColor errorColour(const QPalette& palette);
/// Returns that of warnings.
QColor warningColour(const QPalette& palette);

/// Returns the rules of a style sheet with colours in place of their names, which stand after "@":
/// "color: @text". A palette has @window, @text, @faint, @base, @edge, @accent, @error and
/// @warning; others: further ones. No name begins with another one.
QString styleSheet(QString rules, const QPalette& palette,
                   std::initializer_list<std::pair<const char*, QString>> others = {});

QString panelStyleSheet(const QPalette& palette);
/// Returns its rules for labels that are an error, a warning or a note. The style sheet of a window
/// has them, too, for its dialogs.
QString messageStyleSheet(const QPalette& palette);

/// Sets a property on which the style sheet depends.
void setStyleProperty(QWidget& widget, const char* name, const QVariant& value);

}  // namespace asperity
