#include "ui/window/main/command_words.h"

#include <QAction>

namespace asperity {

QString buttonText(QString text) {
  return QChar(0x2002) + text.remove(u'…');
}

QString wrappedTip(const QString& text) {
  return text.isEmpty() ? QString() : "<p>" + text.toHtmlEscaped() + "</p>";
}

void setCommandText(QAction& action, const QString& text) {
  action.setText(text);
  action.setIconText(buttonText(text));
  action.setToolTip(action.shortcut().isEmpty()
                        ? text
                        : QStringLiteral("%1 (%2)").arg(
                              text, action.shortcut().toString(QKeySequence::NativeText)));
}

}  // namespace asperity
