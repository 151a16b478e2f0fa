#include "ui/chart/tick_label.h"

namespace asperity {

QString labelWithUnit(const Tick& tick, const AxisTicks& axis) {
  const QString label = QString::fromStdString(tick.label);
  const QString unit = QString::fromStdString(axis.unit);
  if (!unit.startsWith(QStringLiteral("10"))) return (label + ' ' + unit).trimmed();
  if (tick.value != 0) return label + QStringLiteral("×") + unit;
  return (QStringLiteral("0 ") + unit.section(' ', 1)).trimmed();
}

}  // namespace asperity
