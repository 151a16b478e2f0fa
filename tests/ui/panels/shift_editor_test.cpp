// The table of measured shifts in the panel, as a person uses it: keys, clipboard, undo by hand.
#include "ui/panels/shift_editor.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "core/base/input_error.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"

namespace asperity {
namespace {

Scene tabled(std::vector<ShiftPoint> table) {
  Scene scene;
  scene.elastomer.shift.kind = ShiftKind::Table;
  scene.elastomer.shift.table = std::move(table);
  return scene;
}

class ShiftEditorTest : public testing::Test {
 protected:
  ShiftEditorTest() : panel_(tabled({{263.15, 2.5}, {298.15, 0}, {323.15, -1}})) {
    panel_.setView({true, {}});  // all rows
    panel_.resize(380, 700);
    panel_.show();
    panel_.activateWindow();
  }
  template <class Control>
  Control& control(const QString& name) {
    return *panel_.findChild<Control*>(name);
  }
  void type(const char* column, int row, const QString& text) {
    auto& field = control<ValueEntry>(QStringLiteral("%1:%2").arg(column).arg(row));
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
  }
  const std::vector<ShiftPoint>& table() { return panel_.scene().elastomer.shift.table; }

  ParameterPanel panel_;
};

TEST_F(ShiftEditorTest, ShowsAndChangesEachValue) {
  EXPECT_EQ(control<ValueEntry>("shiftTemperature:0").text(), "263.15");
  EXPECT_EQ(control<ValueEntry>("shiftLog:2").text(), "-1");
  type("shiftLog", 2, "-1.25");
  EXPECT_EQ(table()[2].log10Shift, -1.25);
  type("shiftTemperature", 0, "-20 °C");
  EXPECT_NEAR(table()[0].temperature, 253.15, 1e-9);
  // The rows stay in the order of temperature.
  type("shiftTemperature", 2, "280");
  EXPECT_EQ(table()[1].temperature, 280);
  EXPECT_EQ(table()[1].log10Shift, -1.25);
}

TEST_F(ShiftEditorTest, ATemperatureThatStandsTwiceIsRefused) {
  const auto before = table();
  type("shiftTemperature", 2, "298.15");
  EXPECT_EQ(table(), before);
  EXPECT_FALSE(control<QLabel>("error:elastomer.shift.table").text().isEmpty());
}

TEST_F(ShiftEditorTest, RowsAreAddedAndRemovedDownToOne) {
  control<QToolButton>("shiftsAdd").click();
  ASSERT_EQ(table().size(), 4U);
  EXPECT_NEAR(table()[3].temperature, 333.15, 1e-9);
  EXPECT_NEAR(table()[3].log10Shift, -1.4, 1e-9);  // 0.04 a kelvin, as between the last two
  for (int left = 3; left >= 1; --left) {
    control<QToolButton>("shiftRemove:0").click();
    QCoreApplication::processEvents();
    EXPECT_EQ(table().size(), static_cast<std::size_t>(left));
  }
  EXPECT_FALSE(control<QToolButton>("shiftRemove:0").isEnabled());
}

TEST_F(ShiftEditorTest, ATableIsPasted) {
  QGuiApplication::clipboard()->setText("T (°C)\tlog aT\n-20\t3,5\n25\t0\n60\t-1,5\n");
  control<QToolButton>("shiftsPaste").click();
  ASSERT_EQ(table().size(), 3U);
  EXPECT_NEAR(table()[0].temperature, 253.15, 1e-9);
  EXPECT_EQ(table()[0].log10Shift, 3.5);
  QGuiApplication::clipboard()->setText("nothing of this kind");
  const auto before = table();
  control<QToolButton>("shiftsPaste").click();
  EXPECT_EQ(table(), before);
  EXPECT_FALSE(control<QLabel>("shiftsRefusal").text().isEmpty());
}

TEST(ShiftsFromTable, UnitsNamesAndFactors) {
  const auto kelvin = shiftsFromTable("300\t0\n290\t1\n");  // any order
  ASSERT_EQ(kelvin.size(), 2U);
  EXPECT_EQ(kelvin[0], (ShiftPoint{290, 1}));
  EXPECT_NEAR(shiftsFromTable("20 0\n40 -1\n")[0].temperature, 293.15, 1e-9);
  const auto factors = shiftsFromTable("temperature (K);a_T\n290;100\n300;1\n");
  EXPECT_NEAR(factors[0].log10Shift, 2, 1e-12);
  EXPECT_NEAR(shiftsFromTable("T (°F);log10 a_T\n68;0\n104;-1\n")[0].temperature, 293.15, 1e-9);
  EXPECT_THROW(shiftsFromTable("290 0\n290 1\n"), InputError);
  EXPECT_THROW(shiftsFromTable("T (kg);log aT\n1;0\n2;1\n"), InputError);
  EXPECT_THROW(shiftsFromTable("temperature (K);a_T\n290;-3\n300;1\n"), InputError);
  EXPECT_THROW(shiftsFromTable(""), InputError);
}

}  // namespace
}  // namespace asperity
