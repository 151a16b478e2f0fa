// Where tips are shown: beside what they explain, so that they do not cover it. GUI thread. Cannot
// fail.
#pragma once

#include <QPoint>
#include <QString>

class QRect;
class QWidget;

namespace asperity {

/// Returns where to show a tip with this text so that it stands above a place, a rectangle on the
/// screen, or on its left, and does not cover it; on the other side where there is no room.
QPoint tipAbove(const QString& text, const QRect& place, int x);
QPoint tipBeside(const QString& text, const QRect& place);
/// Returns where to show a tip below a place.
QPoint tipBelow(const QRect& place, int x);

/// Shows the tips of what is in the widget now beside the widget, so that they do not cover what is
/// below it, to which the pointer moves next.
void keepTipsBeside(QWidget& widget);

}  // namespace asperity
