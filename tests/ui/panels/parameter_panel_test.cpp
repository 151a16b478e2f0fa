// The panel as a person uses it: keys, mouse, text; every row of the table.
#include "ui/panels/parameter_panel.h"

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/scene/parameters.h"
#include "tests/ui/panels/parameter_panel_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/language/language.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_text.h"
#include "ui/panels/profile_defaults.h"
#include "ui/panels/value_entry.h"
#include "ui/panels/value_slider.h"

namespace asperity {
namespace {

QString controlOf(const Parameter& parameter) {
  if (std::holds_alternative<ChoiceField>(parameter.field)) return "choice:";
  if (std::holds_alternative<ArmsField>(parameter.field)) return "arms:";
  if (std::holds_alternative<ShiftTableField>(parameter.field)) return "shifts:";
  if (parameter.key == "elastomer.material") return "material:";
  if (isList(parameter)) return "list:";
  return parameter.key == "description" ? "text:" : "entry:";
}

TEST_F(ParameterPanelTest, EveryApplicableRowHasItsControlsForEveryKind) {
  for (const Scene& scene : scenesOfEveryKind()) {
    panel_.setScene(scene);
    for (const Parameter& row : parameters()) {
      if (row.key == "sweep.key") continue;  // is chosen at the chart
      const QString key = fromUtf8(row.key);
      const bool applies = isApplicable(row, scene);
      EXPECT_EQ(isShown(controlOf(row) + key), applies) << row.key;
      if (isNumber(row)) {
        const bool hasSlider = zeroText(row).isEmpty();
        EXPECT_EQ(isShown("slider:" + key), applies && hasSlider) << row.key;
      }
    }
  }
  EXPECT_EQ(spy_.count(), 0);
}

TEST_F(ParameterPanelTest, ControlsSayWhatTheyAre) {
  for (const Scene& scene : scenesOfEveryKind()) panel_.setScene(scene);
  panel_.setScene(Scene{});  // the words of its motion and the formulas of its elements
  for (const Parameter& row : parameters()) {
    const QString key = fromUtf8(row.key);
    for (QWidget* widget : panel_.findChildren<QWidget*>(QRegularExpression(
             "^(slider|entry|choice|arms|shifts|material|text):" + QRegularExpression::escape(key) +
             "$"))) {
      EXPECT_TRUE(widget->accessibleName().startsWith(fromUtf8(row.label))) << row.key;
      EXPECT_TRUE(widget->accessibleDescription().contains(fromUtf8(row.sentence))) << row.key;
      if (controlOf(row) == "arms:" || controlOf(row) == "shifts:")
        continue;  // its parts have their own
      EXPECT_TRUE(widget->toolTip().contains(fromUtf8(row.sentence).toHtmlEscaped())) << row.key;
    }
  }
}

/// A number without its unit would be another one: 200 mN would be heard as 200 N.
TEST_F(ParameterPanelTest, ScreenReadersHearTheUnitThatIsShown) {
  Scene scene;
  scene.load.normalForce = 0.2;
  panel_.setScene(scene);
  auto& entry = *panel_.findChild<ValueEntry*>("entry:load.normal_force");
  auto& slider = *panel_.findChild<ValueSlider*>("slider:load.normal_force");
  EXPECT_EQ(entry.text(), "200");
  EXPECT_EQ(entry.accessibleName(), "normal force (mN)");
  EXPECT_TRUE(slider.accessibleDescription().startsWith("200 mN. "))
      << slider.accessibleDescription().toStdString();
  scene.load.normalForce = 2;
  panel_.setScene(scene);
  EXPECT_EQ(entry.accessibleName(), "normal force (N)");
  EXPECT_TRUE(slider.accessibleDescription().startsWith("2 N. "));
}

/// What is wrong with a value stands below it, and is heard with the control that has the focus.
TEST_F(ParameterPanelTest, ScreenReadersHearWarningsAndErrors) {
  panel_.showError("load.normal_force", "too much for this line");
  const auto& entry = *panel_.findChild<ValueEntry*>("entry:load.normal_force");
  EXPECT_TRUE(entry.accessibleDescription().contains("too much for this line"));
  panel_.clearErrors();
  EXPECT_FALSE(entry.accessibleDescription().contains("too much for this line"));
}

/// Returns the names of the visible controls in the order of the Tab key, or of their place on the
/// screen.
std::string controlsInOrder(ParameterPanel& panel, bool byTab) {
  std::vector<std::pair<int, QString>> controls;
  int number = 0;
  for (QWidget* each = panel.nextInFocusChain(); each != &panel; each = each->nextInFocusChain())
    if (each->focusPolicy() & Qt::TabFocus && each->isVisibleTo(&panel))
      controls.emplace_back(byTab ? number++ : each->mapTo(&panel, QPoint()).y(),
                            each->objectName());
  std::ranges::sort(controls);
  QStringList names;
  for (const auto& [place, name] : controls) names += name;
  return names.join(' ').toStdString();
}

/// Rows are made when a scene needs them, which must not be seen: they stand where they would be in
/// a panel that was made for this scene.
TEST_F(ParameterPanelTest, RowsThatComeLaterHaveTheirPlace) {
  static const QRegularExpression row("^row:");
  EXPECT_EQ(control<QWidget>("row:surface.amplitude"), nullptr);
  const auto before = panel_.findChildren<QWidget*>(row).size();
  auto count = before;
  for (const Scene& scene : scenesOfEveryKind()) {
    panel_.setScene(scene);
    if (count == panel_.findChildren<QWidget*>(row).size()) continue;
    count = panel_.findChildren<QWidget*>(row).size();
    ParameterPanel fresh(scene);
    fresh.setView(panel_.view());
    fresh.resize(panel_.size());
    fresh.show();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    for (const bool byTab : {false, true})
      EXPECT_EQ(controlsInOrder(panel_, byTab), controlsInOrder(fresh, byTab));
  }
  EXPECT_GT(count, before);
}

TEST_F(ParameterPanelTest, KeysOnASliderChangeTheScene) {
  for (const char* key : {"load.normal_force", "sliding.velocity", "elastomer.shear_modulus",
                          "elastomer.relaxation_time", "surface.hurst", "surface.rms_height",
                          "surface.length", "surface.elements", "ensemble.realizations"}) {
    const Parameter& row = *findParameter(key);
    const ParameterValue before = parameterValue(row, panel_.scene());
    spy_.clear();
    QTest::keyClick(&slider(key), Qt::Key_Right);
    EXPECT_EQ(spy_.count(), 1) << key;
    const ParameterValue after = parameterValue(row, panel_.scene());
    EXPECT_GT(after, before) << key;
    const QString unit = control<QLabel>("unit:" + QString(key))->text();
    const QString text = inShownUnit(entry(key).text(), unit);
    EXPECT_EQ(toPlainNumber(text, numberRule(row)), valueText(after)) << key;
    EXPECT_EQ(spy_.back().front().value<Scene>(), panel_.scene());
  }
}

TEST_F(ParameterPanelTest, APressOnTheGrooveTakesTheHandleThere) {
  ValueSlider& force = slider("load.normal_force");
  QTest::mouseClick(&force, Qt::LeftButton, {}, QPoint(force.width() - 3, force.height() / 2));
  EXPECT_GT(panel_.scene().load.normalForce, 100);
}

TEST_F(ParameterPanelTest, AcceptsExactNumbers) {
  type("elastomer.shear_modulus", "3.25e6 Pa");
  EXPECT_EQ(panel_.scene().elastomer.shearModulus, 3.25e6);
  type("elastomer.shear_modulus", " 1e8 Pa ");
  EXPECT_EQ(panel_.scene().elastomer.shearModulus, 1e8);
  type("surface.elements", "777");
  EXPECT_EQ(panel_.scene().surface.elements, 777);
  type("load.normal_force", "1e-9 N");  // beyond the slider, within the range
  EXPECT_EQ(panel_.scene().load.normalForce, 1e-9);
  EXPECT_EQ(spy_.count(), 4);
}

TEST_F(ParameterPanelTest, ANumberAloneIsInTheUnitBesideIt) {
  const auto* unit = control<QLabel>("unit:elastomer.shear_modulus");
  EXPECT_EQ(unit->text(), "MPa");
  type("elastomer.shear_modulus", "20");
  EXPECT_EQ(panel_.scene().elastomer.shearModulus, 2e7);
  type("elastomer.shear_modulus", "500 kPa");
  EXPECT_EQ(panel_.scene().elastomer.shearModulus, 5e5);
  EXPECT_EQ(entry("elastomer.shear_modulus").text(), "500");
  EXPECT_EQ(unit->text(), "kPa");
  type("elastomer.shear_modulus", "-2");  // refused: the unit stays with what was typed
  EXPECT_EQ(unit->text(), "kPa");
}

TEST_F(ParameterPanelTest, RefusesBadTextAndKeepsTheOldValue) {
  const Scene before = panel_.scene();
  for (const char* bad : {"abc", "1.4", "nan", "inf", "-1", "0.5x", ""}) {
    type("surface.hurst", bad);
    EXPECT_TRUE(entry("surface.hurst").property("refused").toBool()) << bad;
    EXPECT_TRUE(complaint("surface.hurst").contains("0 to 1")) << bad;
    EXPECT_TRUE(isShown("error:surface.hurst"));
  }
  EXPECT_EQ(panel_.scene(), before);
  EXPECT_EQ(spy_.count(), 0);

  type("surface.hurst", "0.9");
  EXPECT_FALSE(entry("surface.hurst").property("refused").toBool());
  EXPECT_FALSE(isShown("error:surface.hurst"));
  EXPECT_EQ(panel_.scene().surface.hurst, 0.9);
}

TEST_F(ParameterPanelTest, RefusalsNameTheRangeInReadableUnits) {
  type("elastomer.shear_modulus", "-2");
  EXPECT_EQ(complaint("elastomer.shear_modulus"), "-2 MPa is outside 1 \u00B5Pa to 1 PPa");
  type("surface.length", "40 °C");
  EXPECT_EQ(complaint("surface.length"),
            "40 °C is a temperature; expected a length, such as 20 mm");
  type("elastomer.temperature", "40 °C");
  EXPECT_EQ(panel_.scene().elastomer.temperature, 313.15);
  EXPECT_TRUE(slider("surface.length").toolTip().contains("slider: 100 \u00B5m to 1 m"));
}

TEST_F(ParameterPanelTest, SentencesHaveABox) {
  auto& box = *control<TextBox>("text:description");
  panel_.activateWindow();
  box.setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return box.hasFocus(); }));
  QTest::keyClicks(&box, "Look at the left.");
  EXPECT_EQ(spy_.count(), 0);
  QTest::keyClick(&box, Qt::Key_Escape);
  EXPECT_EQ(box.toPlainText(), "");
  QTest::keyClicks(&box, "Look.");
  QTest::keyClick(&box, Qt::Key_Return);
  QTest::keyClicks(&box, "Again.");
  QTest::keyClick(&box, Qt::Key_Tab);  // goes on
  EXPECT_FALSE(box.hasFocus());
  EXPECT_EQ(panel_.scene().description, "Look. Again.");
  EXPECT_EQ(spy_.count(), 1);
  panel_.setScene({});
  EXPECT_EQ(box.toPlainText(), "");
}

/// Returns a scene with a description of so many words.
Scene describedScene(int words) {
  Scene scene;
  for (int i = 0; i < words; ++i) scene.description += "roughness ";
  return scene;
}

TEST_F(ParameterPanelTest, ABoxIsAsHighAsItsSentences) {
  auto& box = *control<TextBox>("text:description");
  const double line = std::ceil(QFontMetricsF(box.font()).lineSpacing());
  const int low = box.height();
  const auto describe = [&](int words) { panel_.setScene(describedScene(words)); };
  const auto growsBy = [&](double lines, bool isWhole) {
    return QTest::qWaitFor([&] {
      return std::abs(box.height() - low - lines * line) <= 1 &&
             (box.verticalScrollBar()->maximum() == 0) == isWhole;
    });
  };
  describe(1000);
  EXPECT_TRUE(growsBy(6, false)) << "a book is scrolled";
  describe(1);
  EXPECT_TRUE(growsBy(0, true));
  const int across = box.viewport()->width() / box.fontMetrics().horizontalAdvance("roughness ");
  describe(6 * across);
  EXPECT_TRUE(growsBy(2, true) || growsBy(3, true)) << box.height();
  panel_.resize(3 * panel_.width(), panel_.height());
  EXPECT_TRUE(growsBy(0, true)) << "in a wide panel";
}

/// Qt breaks lines earlier beside a scroll bar, which a box that is still low would have.
TEST_F(ParameterPanelTest, ATextThatFitsHasNoScrollBarHoweverItCame) {
  auto& box = *control<TextBox>("text:description");
  const auto isScrolled = [&](int words) {
    panel_.setScene(describedScene(words));
    QTest::qWait(10);
    return box.verticalScrollBar()->isVisible();
  };
  int words = 1;
  while (words < 1000 && !isScrolled(words)) ++words;
  ASSERT_GT(words, 10);
  ASSERT_LT(words, 1000) << "a book is scrolled";
  EXPECT_FALSE(isScrolled(1));
  EXPECT_FALSE(isScrolled(words - 1)) << words - 1 << " words at once";
}

TEST_F(ParameterPanelTest, NamesAndSymbolsAreAsPeopleWriteThem) {
  const auto label = [&](const char* key) {
    for (const QLabel* found :
         panel_.findChild<QWidget*>("row:" + QString(key))->findChildren<QLabel*>())
      if (found->textFormat() == Qt::RichText) return found->text();
    return QString();
  };
  Scene solid;
  solid.elastomer.rheology = Rheology::StandardSolid;
  panel_.setScene(solid);
  EXPECT_EQ(label("elastomer.equilibrium_modulus"),
            QStringLiteral("equilibrium modulus&nbsp;&nbsp;<i>G</i><sub>∞</sub>"));
  EXPECT_EQ(label("elastomer.shift.c1"), "constant&nbsp;&nbsp;<i>C</i><sub>1</sub>");
  auto* rheology = control<QComboBox>("choice:elastomer.rheology");
  EXPECT_EQ(rheology->itemText(rheology->findData("kelvin")), "Kelvin");
  EXPECT_EQ(rheology->itemText(rheology->findData("standard_solid")), "standard solid");
}

TEST_F(ParameterPanelTest, ResetGoesBackToTheDefault) {
  type("load.normal_force", "5 N");
  auto* reset = control<QToolButton>("reset:load.normal_force");
  EXPECT_TRUE(reset->isEnabled());
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(panel_.scene(), Scene{});
  EXPECT_FALSE(reset->isEnabled());
}

TEST_F(ParameterPanelTest, TheWheelCountsOnlyWithFocus) {
  ValueSlider& force = slider("load.normal_force");
  entry("load.normal_force").setFocus();
  const auto turn = [&](QWidget& widget) {
    QWheelEvent event(QPointF(5, 5), widget.mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
  };
  turn(force);
  turn(*control<QComboBox>("choice:surface.kind"));
  EXPECT_EQ(panel_.scene(), Scene{});
  panel_.activateWindow();
  force.setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return force.hasFocus(); }));
  turn(force);
  EXPECT_GT(panel_.scene().load.normalForce, Scene{}.load.normalForce);
}

TEST_F(ParameterPanelTest, KindsBringTheirOwnRows) {
  choose("surface.kind", "wedge");
  EXPECT_EQ(panel_.scene().surface.kind, SurfaceKind::Wedge);
  EXPECT_TRUE(isShown("slider:surface.slope"));
  EXPECT_FALSE(isShown("slider:surface.hurst"));
  choose("load.kind", "indentation");
  EXPECT_TRUE(isShown("slider:load.depth"));
  EXPECT_FALSE(isShown("slider:load.normal_force"));
  EXPECT_EQ(spy_.count(), 2);
}

TEST_F(ParameterPanelTest, ShowsAnotherSceneSilently) {
  Scene scene;
  scene.load.normalForce = 0.1;
  scene.title = "another";
  panel_.setScene(scene);
  EXPECT_EQ(spy_.count(), 0);
  EXPECT_EQ(entry("load.normal_force").text(), "100");
  EXPECT_EQ(entry("title").text(), "another");
}

TEST_F(ParameterPanelTest, ShowsComplaintsOfTheRunner) {
  panel_.showError("surface.hurst", "no good");
  EXPECT_EQ(complaint("surface.hurst"), "no good");
  EXPECT_TRUE(entry("surface.hurst").hasError());
  panel_.showError("no.such.key", "ignored");
  type("surface.length", "x");
  panel_.clearErrors();
  EXPECT_EQ(complaint("surface.hurst"), "");
  EXPECT_FALSE(entry("surface.hurst").hasError());
  EXPECT_TRUE(entry("surface.length").hasError());  // still what someone typed
}

/// The scene before still runs, or fails, while somebody types.
TEST_F(ParameterPanelTest, AComplaintOfTheRunnerDoesNotHideARefusal) {
  panel_.showError("surface.hurst", "no good");
  type("surface.hurst", "x");
  const QString refusal = complaint("surface.hurst");
  EXPECT_NE(refusal, "no good");
  NoteSet notes;
  notes.add(Note::FewContacts);
  panel_.showNotes(notes);
  EXPECT_EQ(complaint("surface.hurst"), refusal);
  panel_.showError("surface.hurst", "still no good");
  EXPECT_EQ(complaint("surface.hurst"), refusal);
  entry("surface.hurst").setFocus();
  QTest::keyClick(&entry("surface.hurst"), Qt::Key_Escape);
  EXPECT_EQ(complaint("surface.hurst"), "still no good");
  panel_.clearErrors();
  EXPECT_EQ(complaint("surface.hurst"), "");
}

/// Qt makes the list of a box when it opens; screen readers then know what it is.
TEST_F(ParameterPanelTest, TheListOfABoxHasItsNameOnceItOpens) {
  auto& box = *control<QComboBox>("choice:surface.kind");
  EXPECT_EQ(box.findChild<QAbstractItemView*>(), nullptr) << "made before it is needed";
  panel_.show();
  box.showPopup();
  QCoreApplication::processEvents();
  EXPECT_FALSE(box.accessibleName().isEmpty());
  EXPECT_EQ(box.view()->accessibleName(), box.accessibleName());
  box.hidePopup();
}

/// A screen reader asks for the list of a box that nobody opened.
TEST_F(ParameterPanelTest, TheListOfAClosedBoxHasItsName) {
  auto& box = *control<QComboBox>("choice:surface.kind");
  box.view();
  QCoreApplication::processEvents();
  EXPECT_FALSE(box.accessibleName().isEmpty());
  EXPECT_EQ(box.view()->accessibleName(), box.accessibleName());
}

/// Another kind of load hides the row that had the note.
TEST_F(ParameterPanelTest, ANoteStandsAtOnceAtTheRowThatTheNewSceneHas) {
  const auto warning = [this](const char* key) { return remark("warning", key); };
  NoteSet notes;
  notes.add(Note::FewContacts);
  panel_.showNotes(notes);
  EXPECT_FALSE(warning("load.normal_force").isEmpty());
  choose("load.kind", "pressure");
  EXPECT_FALSE(warning("load.nominal_pressure").isEmpty());
  EXPECT_TRUE(warning("load.normal_force").isEmpty());
}

TEST_F(ParameterPanelTest, ASliderContainsTheScenesValue) {
  auto& slider = *panel_.findChild<ValueSlider*>("slider:surface.rms_height");
  Scene scene;
  scene.surface.rmsHeight = 1.8e-4;
  panel_.setScene(scene);
  EXPECT_LT(slider.value(), slider.maximum());
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Left);
  EXPECT_GT(panel_.scene().surface.rmsHeight, 1.4e-4);
  EXPECT_LT(panel_.scene().surface.rmsHeight, 1.8e-4);
}

/// What is said of a row stands beside it, so that the row below is in sight.
TEST_F(ParameterPanelTest, TheTipOfARowDoesNotCoverItsNeighbours) {
  panel_.move(600, 0);
  for (const char* part : {"entry:elastomer.shear_modulus", "slider:elastomer.shear_modulus"}) {
    auto& child = *control<QWidget>(part);
    ASSERT_FALSE(child.toolTip().isEmpty());
    const QPoint at = child.rect().center();
    QHelpEvent help(QEvent::ToolTip, at, child.mapToGlobal(at));
    QApplication::sendEvent(&child, &help);
    ASSERT_EQ(QToolTip::text(), child.toolTip());
    const QWidgetList all = QApplication::topLevelWidgets();
    const auto tip = std::ranges::find_if(
        all, [](const QWidget* each) { return each->objectName() == "qtooltip_label"; });
    ASSERT_NE(tip, all.end());
    const auto& row = *control<QWidget>("row:elastomer.shear_modulus");
    EXPECT_LE((*tip)->geometry().right(), row.mapToGlobal(QPoint()).x()) << part;
  }
  QToolTip::hideText();
}

/// A value in a message has its unit, as in its row.
TEST(WithLabels, AnAssignmentIsShownAsItsRowShowsIt) {
  EXPECT_EQ(withLabels("scenes need elastomer.temperature=293.15"),
            "scenes need “temperature” = 293.15 K");
  EXPECT_EQ(withLabels("surface.outliers=6 replaces them"), "“outlier limit” = 6 replaces them");
  EXPECT_EQ(withLabels("see load.normal_force."), "see “normal force”.");
  EXPECT_EQ(withLabels("elastomer.shear_modulus=2e7, no.such.key=3"),
            "“shear modulus” = 20 MPa, no.such.key=3");
}

/// The numbers of a translated message are those of its language.
TEST(WithLabels, AnAssignmentIsReadWithADecimalComma) {
  useLanguage("de");
  EXPECT_EQ(withLabels("gilt bei elastomer.temperature=293,15, nicht sonst"),
            "gilt bei „Temperatur“ = 293,15 K, nicht sonst");
  useLanguage("en");
}

}  // namespace
}  // namespace asperity
