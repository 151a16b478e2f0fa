// The tables of an elastomer's arms and of its measured shifts in the panel, as a person uses them:
// keys, mouse, text, clipboard, undo by hand.
#include "ui/panels/elastomer_tables.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <cmath>
#include <numbers>

#include "core/base/input_error.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"

namespace asperity {
namespace {

// ---- Arms

Scene prony(std::vector<Arm> arms) {
  Scene scene;
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.arms = std::move(arms);
  return scene;
}

class ArmsEditorTest : public testing::Test {
 protected:
  ArmsEditorTest() : panel_(prony({{1e7, 1e-3}, {2e6, 0.1}})) {
    panel_.setView({true, {}});  // all rows
    panel_.resize(380, 700);
    panel_.show();
    panel_.activateWindow();
  }

  template <class Control>
  Control& control(const QString& name) {
    return *panel_.findChild<Control*>(name);
  }
  bool isShown(const QString& name) {
    auto* widget = panel_.findChild<QWidget*>(name);
    return widget && widget->isVisibleTo(&panel_);
  }
  ValueEntry& entry(const char* column, int row) {
    return control<ValueEntry>(QStringLiteral("%1:%2").arg(column).arg(row));
  }
  void type(const char* column, int row, const QString& text) {
    ValueEntry& field = entry(column, row);
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
  }
  QString complaint(int row) {
    return control<QLabel>(QStringLiteral("armError:%1").arg(row)).text();
  }
  const std::vector<Arm>& arms() { return panel_.scene().elastomer.arms; }

  ParameterPanel panel_;
};

TEST_F(ArmsEditorTest, ShowsTheArmsByTimeInEngineeringUnits) {
  panel_.setScene(prony({{2e6, 0.1}, {1e7, 1e-3}}));
  EXPECT_EQ(entry("armModulus", 0).text(), "10");
  EXPECT_EQ(entry("armModulus", 0).unit(), "MPa");
  EXPECT_EQ(entry("armTime", 0).text(), "1");
  EXPECT_EQ(entry("armTime", 0).unit(), "ms");
  EXPECT_EQ(entry("armTime", 1).text(), "100");
  EXPECT_EQ(control<QToolButton>("armsFold").text(), "2, 1 ms to 100 ms");
}

TEST_F(ArmsEditorTest, ValuesAreTypedWithTheirUnits) {
  const QSignalSpy edited(&panel_, &ParameterPanel::sceneEdited);
  type("armModulus", 0, "3,5 MPa");
  EXPECT_EQ(arms()[0].modulus, 3.5e6);
  type("armTime", 0, "20");
  EXPECT_EQ(arms()[0].relaxationTime, 0.02);
  EXPECT_EQ(edited.count(), 2);
}

TEST_F(ArmsEditorTest, AChangedTimeFindsItsPlace) {
  type("armTime", 0, "5 s");
  EXPECT_EQ(arms(), (std::vector<Arm>{{2e6, 0.1}, {1e7, 5}}));
  EXPECT_EQ(entry("armModulus", 0).text(), "2");
  EXPECT_EQ(entry("armTime", 1).text(), "5");
}

TEST_F(ArmsEditorTest, ARefusedValueSaysWhyInPlaceAndChangesNothing) {
  const Scene before = panel_.scene();
  type("armModulus", 1, "-2 MPa");
  EXPECT_EQ(complaint(1), "-2 MPa is outside 0 to 1 PPa");
  EXPECT_TRUE(entry("armModulus", 1).hasError());
  type("armTime", 0, "5 kg");
  EXPECT_EQ(complaint(0), "5 kg is a mass; expected a time, such as 1 ms");
  EXPECT_EQ(panel_.scene(), before);
  QTest::keyClick(&entry("armTime", 0), Qt::Key_Escape);
  EXPECT_FALSE(isShown("armError:0"));
  EXPECT_EQ(entry("armTime", 0).text(), "1");
  type("armModulus", 1, "4 MPa");
  EXPECT_FALSE(isShown("armError:1"));
  EXPECT_EQ(arms()[1].modulus, 4e6);
}

/// One of two refused values may be taken back before the other.
TEST_F(ArmsEditorTest, EachRefusedValueOfARowKeepsItsReason) {
  type("armModulus", 1, "-2 MPa");
  type("armTime", 1, "5 kg");
  EXPECT_TRUE(complaint(1).contains("-2 MPa is outside")) << complaint(1).toStdString();
  EXPECT_TRUE(complaint(1).contains("5 kg is a mass")) << complaint(1).toStdString();
  QTest::keyClick(&entry("armTime", 1), Qt::Key_Escape);
  EXPECT_EQ(complaint(1), "-2 MPa is outside 0 to 1 PPa");
  EXPECT_TRUE(isShown("armError:1"));
  entry("armModulus", 1).setFocus();
  QTest::keyClick(&entry("armModulus", 1), Qt::Key_Escape);
  EXPECT_FALSE(isShown("armError:1"));
}

TEST_F(ArmsEditorTest, ArmsAreAddedAndRemovedByKeys) {
  auto& add = control<QToolButton>("armsAdd");
  add.setFocus();
  QTest::keyClick(&add, Qt::Key_Space);
  ASSERT_EQ(arms().size(), 3U);
  EXPECT_EQ(arms()[2], (Arm{2e6, 1}));  // a decade on
  EXPECT_TRUE(QTest::qWaitFor([&] { return entry("armModulus", 2).hasFocus(); }));
  QTest::keyClicks(&entry("armModulus", 2), "7");
  QTest::keyClick(&entry("armModulus", 2), Qt::Key_Tab);
  EXPECT_EQ(arms()[2].modulus, 7e6);
  EXPECT_TRUE(entry("armTime", 2).hasFocus());

  auto& remove = control<QToolButton>("armRemove:0");
  EXPECT_TRUE(remove.focusPolicy() & Qt::TabFocus);
  QTest::keyClick(&remove, Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return arms().size() == 2; }));
  EXPECT_EQ(arms()[0], (Arm{2e6, 0.1}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !panel_.findChild<QWidget*>("armRemove:2"); }));
}

TEST_F(ArmsEditorTest, TabGoesThroughTheTableAsItStands) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));
  for (const int count : {2, 3}) {
    if (count == 3) QTest::mouseClick(&control<QToolButton>("armsAdd"), Qt::LeftButton);
    control<QToolButton>("armsFold").setFocus();
    QStringList expected, reached;
    for (int i = 0; i < count; ++i)
      for (const char* name : {"armModulus:%1", "armTime:%1", "armRemove:%1"})
        expected += QString(name).arg(i);
    expected += {"armsAdd", "armsPaste", "entry:elastomer.temperature"};
    while (reached.size() < expected.size()) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      reached += QApplication::focusWidget()->objectName();
    }
    EXPECT_EQ(reached.join(' ').toStdString(), expected.join(' ').toStdString());
  }
}

/// The focus goes into a field after an arm was added or removed.
TEST_F(ArmsEditorTest, AFieldClaimsTheKeyOfUndoOnlyForWhatIsBeingTyped) {
  control<QToolButton>("armsAdd").click();
  ValueEntry& field = entry("armModulus", 2);
  const auto claims = [&] {
    QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    key.ignore();
    QApplication::sendEvent(&field, &key);
    return key.isAccepted();
  };
  EXPECT_FALSE(claims());
  const QString before = field.text();
  QTest::keyClicks(&field, "7");
  EXPECT_TRUE(claims());
  QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(field.text(), before);
  EXPECT_FALSE(claims());
}

TEST_F(ArmsEditorTest, AllMayGoAndTheFirstComesBack) {
  for (std::size_t left = 2; left > 0; --left) {
    control<QToolButton>("armRemove:0").click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return arms().size() == left - 1; }));
  }
  EXPECT_EQ(control<QToolButton>("armsFold").text(), "none");
  control<QToolButton>("armsAdd").click();
  EXPECT_EQ(arms(), std::vector<Arm>(1));
}

TEST_F(ArmsEditorTest, AStandardSolidKeepsItsOne) {
  Scene scene = prony(std::vector<Arm>(1));
  scene.elastomer.rheology = Rheology::StandardSolid;
  panel_.setScene(scene);
  EXPECT_FALSE(control<QToolButton>("armsAdd").isEnabled());
  EXPECT_FALSE(control<QToolButton>("armRemove:0").isEnabled());
  scene.elastomer.arms.resize(3);
  panel_.setScene(scene);  // two too many
  EXPECT_TRUE(control<QToolButton>("armRemove:0").isEnabled());
}

TEST_F(ArmsEditorTest, AFullListTakesNoMore) {
  panel_.setScene(prony(std::vector<Arm>(kMaxArms)));
  EXPECT_FALSE(control<QToolButton>("armsAdd").isEnabled());
}

TEST_F(ArmsEditorTest, ALongListIsFoldedUntilItIsOpened) {
  EXPECT_TRUE(isShown("armModulus:0"));
  panel_.setScene(prony(std::vector<Arm>(13)));
  EXPECT_FALSE(isShown("armModulus:0"));
  auto& fold = control<QToolButton>("armsFold");
  fold.setFocus();
  QTest::keyClick(&fold, Qt::Key_Space);
  EXPECT_TRUE(isShown("armModulus:12"));
  type("armModulus", 3, "2");
  EXPECT_TRUE(isShown("armModulus:12"));
}

TEST_F(ArmsEditorTest, EveryControlSaysWhatItIs) {
  EXPECT_EQ(entry("armModulus", 1).accessibleName(), "modulus of arm 2 (MPa)");
  EXPECT_EQ(entry("armTime", 0).accessibleName(), "relaxation time of arm 1 (ms)");
  EXPECT_EQ(control<QToolButton>("armRemove:1").accessibleName(), "remove arm 2");
  EXPECT_EQ(control<QToolButton>("armsFold").accessibleName(), "arms: 2, 1 ms to 100 ms");
}

TEST_F(ArmsEditorTest, ResetBringsTheDefaultBack) {
  auto& reset = control<QToolButton>("reset:elastomer.arms");
  EXPECT_EQ(reset.toolTip(), "Back to the default, one arm");
  reset.click();
  EXPECT_EQ(arms(), Elastomer{}.arms);
  EXPECT_FALSE(reset.isEnabled());
}

TEST_F(ArmsEditorTest, ComplaintsOfTheRunnerStandInTheRow) {
  panel_.showError("elastomer.arms[1].modulus", "too little");
  EXPECT_EQ(control<QLabel>("error:elastomer.arms").text(), "too little");
  panel_.clearErrors();
  EXPECT_FALSE(isShown("error:elastomer.arms"));
}

TEST_F(ArmsEditorTest, ATableFromASpreadsheetReplacesThem) {
  QGuiApplication::clipboard()->setText("1e6\t0.01\r\n2e6\t0.001\r\n3e6\t0.1\r\n");
  QTest::mouseClick(&control<QToolButton>("armsPaste"), Qt::LeftButton);
  EXPECT_EQ(arms(), (std::vector<Arm>{{2e6, 0.001}, {1e6, 0.01}, {3e6, 0.1}}));
  // Names and units, the other order, decimal commas; with the keys of pasting, in an entry.
  QGuiApplication::clipboard()->setText("tau (s)\tG (MPa)\n0,5\t1,5\n5\t2,5\n");
  entry("armModulus", 0).setFocus();
  QTest::keySequence(&entry("armModulus", 0), QKeySequence::Paste);
  EXPECT_EQ(arms(), (std::vector<Arm>{{1.5e6, 0.5}, {2.5e6, 5}}));
}

TEST_F(ArmsEditorTest, ATableThatHoldsNoArmsIsRefused) {
  const std::vector<Arm> before = arms();
  for (const char* text : {"", "words\n", "1e6\n2e6\n", "1e6\t0\n2e6\t1\n", "1e6\t-1\n2e6\t1\n"}) {
    QGuiApplication::clipboard()->setText(text);
    QTest::mouseClick(&control<QToolButton>("armsPaste"), Qt::LeftButton);
    EXPECT_EQ(arms(), before) << text;
    EXPECT_TRUE(isShown("armsRefusal")) << text;
    EXPECT_FALSE(control<QLabel>("armsRefusal").text().isEmpty()) << text;
  }
}

// ---- Shifts

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
  EXPECT_NEAR(shiftsFromTable("T (K);ln aT\n290;1\n300;0\n")[0].log10Shift, std::numbers::log10e,
              1e-12);
  EXPECT_EQ(shiftsFromTable("T (K);-log aT\n290;-1\n300;0\n")[0].log10Shift, 1);
  EXPECT_EQ(shiftsFromTable("T (K);horizontal shift factor\n290;10\n300;1\n")[0].log10Shift, 1);
  EXPECT_THROW(shiftsFromTable("290 0\n290 1\n"), InputError);
  EXPECT_THROW(shiftsFromTable("T (kg);log aT\n1;0\n2;1\n"), InputError);
  EXPECT_THROW(shiftsFromTable("temperature (K);a_T\n290;-3\n300;1\n"), InputError);
  EXPECT_THROW(shiftsFromTable(""), InputError);
}

}  // namespace
}  // namespace asperity
