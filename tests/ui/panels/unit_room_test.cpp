// Values and units in the panel are read whole, whatever they are.
#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>
#include <cmath>

#include "core/scene/parameters.h"
#include "tests/ui/panels/parameter_panel_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"

namespace asperity {
namespace {

TEST(UnitRoom, IsEnoughForEveryUnitThatIsShown) {
  ParameterPanel panel{Scene{}};
  panel.setView({true, {}});
  panel.resize(380, 700);
  panel.show();
  for (const Scene& scene : scenesOfEveryKind()) panel.setScene(scene);  // makes all rows
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

TEST(UnitRoom, LeavesTheLargestWholeNumberItsLastDigit) {
  Scene scene;
  scene.surface.elements = 16777216;
  ParameterPanel panel{scene};
  panel.setView({true, {}});
  panel.resize(380, 700);
  panel.show();
  auto& entry = *panel.findChild<ValueEntry*>("entry:surface.elements");
  ASSERT_EQ(entry.text(), "16777216");
  const auto cursorAt = [&entry](int place) {
    entry.setCursorPosition(place);
    entry.grab();  // it scrolls when it is painted
    return entry.inputMethodQuery(Qt::ImCursorRectangle).toRectF().center().x();
  };
  const double seen = cursorAt(8);  // from where it scrolls to
  EXPECT_NEAR(seen - cursorAt(0), entry.fontMetrics().horizontalAdvance("16777216"), 2);
}

}  // namespace
}  // namespace asperity
