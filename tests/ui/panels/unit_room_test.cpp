// Units beside the entries of the panel are read whole, whatever the value.
#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>
#include <cmath>

#include "core/scene/parameters.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"

namespace asperity {
namespace {

TEST(UnitRoom, IsEnoughForEveryUnitThatIsShown) {
  ParameterPanel panel{Scene{}};
  panel.resize(380, 700);
  panel.show();
  int shown = 0;
  for (const Parameter& parameter : parameters()) {
    const auto* field = std::get_if<RealField>(&parameter.field);
    auto* unit = panel.findChild<QLabel*>("unit:" + fromUtf8(parameter.key));
    if (!field || !unit) continue;
    const double from = std::max(field->minimum, 1e-12), to = std::min(field->maximum, 1e15);
    for (double value = from; value <= to; value *= 10) {
      Scene scene;
      field->member(scene) = value;
      panel.setScene(scene);
      EXPECT_LE(unit->sizeHint().width(), unit->width())
          << parameter.key << ' ' << unit->text().toStdString();
      ++shown;
    }
  }
  EXPECT_GT(shown, 100);
}

}  // namespace
}  // namespace asperity
