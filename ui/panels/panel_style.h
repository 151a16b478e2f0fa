// The style of panels, and the colours of errors and warnings everywhere in a window. GUI thread.
// Cannot fail.
#pragma once

#include <QColor>
#include <QString>
#include <QVariant>

class QPalette;
class QWidget;

namespace asperity {

/// Returns whether the windows of a palette are dark.
bool isDark(const QPalette& palette);

/// Returns the colour of error messages, legible on the palette's background.
QColor errorColour(const QPalette& palette);
/// Returns that of warnings.
QColor warningColour(const QPalette& palette);

QString panelStyleSheet(const QPalette& palette);
/// Returns its rules for labels that are an error, a warning or a note. The style sheet of a window
/// has them, too, for its dialogs.
QString messageStyleSheet(const QPalette& palette);

/// Sets a property on which the style sheet depends.
void setStyleProperty(QWidget& widget, const char* name, const QVariant& value);

}  // namespace asperity
