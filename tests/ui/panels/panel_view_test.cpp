// Which rows of the panel are seen: essential ones or all, sections, the filter, what a lesson
// locks and hides, warnings; and how sliders are moved finely.
#include <gtest/gtest.h>

#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "core/scene/essentials.h"
#include "core/scene/parameters.h"
#include "tests/ui/panels/parameter_panel_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/panels/panel_headers.h"

namespace asperity {
namespace {

/// Returns the scene with an elastomer whose arms have a long line in the panel.
Scene withManyArms(Scene scene) {
  scene.elastomer.rheology = Rheology::Prony;
  for (int i = 0; i < 20; ++i) scene.elastomer.arms.push_back({1e6, 1.23e-6 * std::pow(4.0, i)});
  return scene;
}

class PanelViewTest : public ParameterPanelTest {
 protected:
  PanelViewTest() {
    panel_.setView(ParameterPanel::defaultView());
    panel_.activateWindow();
  }

  int rowsShown() {
    int count = 0;
    for (const Parameter& row : parameters()) count += isShown("row:" + fromUtf8(row.key));
    return count;
  }
  bool hasRow(const QString& key) { return isShown("row:" + key); }
  FilterLine& filter() { return *control<FilterLine>("parameterFilter"); }
  void leavePanel() {
    panel_.setAttribute(Qt::WA_UnderMouse, false);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&panel_, &leave);
  }
  void filterBy(const QString& text) {
    filter().clear();
    QTest::keyClicks(&filter(), text);
  }
  SectionHeader& section(const QString& name) { return *control<SectionHeader>("section:" + name); }
};

TEST_F(PanelViewTest, EssentialsAreAFewRowsWithoutHeadings) {
  EXPECT_LE(rowsShown(), static_cast<int>(kMaxEssentials));
  EXPECT_TRUE(hasRow("sliding.velocity"));
  EXPECT_TRUE(hasRow("load.normal_force"));
  EXPECT_FALSE(hasRow("surface.seed"));
  EXPECT_FALSE(isShown("section:load"));
  Scene scene;
  scene.load.kind = LoadKind::Indentation;
  panel_.setScene(scene);
  EXPECT_TRUE(hasRow("load.depth"));
  EXPECT_FALSE(hasRow("load.normal_force"));
}

TEST_F(PanelViewTest, TheButtonAllShowsTheRestInSections) {
  QTest::mouseClick(control<QToolButton>("showAllParameters"), Qt::LeftButton);
  EXPECT_TRUE(panel_.view().showsAll);
  EXPECT_TRUE(hasRow("surface.seed"));
  EXPECT_TRUE(hasRow("elastomer.shift.c1"));
  EXPECT_TRUE(isShown("section:surface"));
  EXPECT_FALSE(hasRow("accuracy.scheme")) << "folded at first";
}

TEST_F(PanelViewTest, SectionsFoldByMouseAndKeysAndSayWhatIsChangedInside) {
  panel_.setView({true, {}});
  SectionHeader& load = section("load");
  QTest::mouseClick(&load, Qt::LeftButton);
  EXPECT_FALSE(hasRow("load.normal_force"));
  EXPECT_EQ(panel_.view().folded, QStringList{"load"});
  QTest::keyClick(&load, Qt::Key_Right);
  EXPECT_TRUE(hasRow("load.normal_force"));
  QTest::keyClick(&load, Qt::Key_Left);
  EXPECT_FALSE(hasRow("load.normal_force"));
  EXPECT_EQ(load.accessibleDescription(), "folded section");
  Scene scene;
  scene.load.normalForce *= 2;
  panel_.setScene(scene);
  EXPECT_EQ(load.accessibleDescription(), "folded section, 1 changed");
}

TEST_F(PanelViewTest, TheFilterFindsLabelsKeysSymbolsAndUnits) {
  filterBy("force");
  EXPECT_TRUE(hasRow("load.normal_force"));
  EXPECT_FALSE(hasRow("sliding.velocity"));
  filterBy("surface.se");
  EXPECT_TRUE(hasRow("surface.seed"));
  EXPECT_FALSE(hasRow("surface.hurst"));
  filterBy("kPa");
  EXPECT_TRUE(hasRow("elastomer.shear_modulus"));
  EXPECT_FALSE(hasRow("load.normal_force"));
  filterBy("mN");
  EXPECT_TRUE(hasRow("load.normal_force"));
  EXPECT_FALSE(hasRow("elastomer.shear_modulus"));
  filter().setText(QStringLiteral("τ"));  // no key of a test has it
  EXPECT_TRUE(hasRow("elastomer.relaxation_time"));
  EXPECT_EQ(rowsShown(), 1);
  filterBy("rms height");  // both words
  EXPECT_EQ(rowsShown(), 1);
  filterBy("scheme");  // also in a section that is folded
  EXPECT_TRUE(hasRow("accuracy.scheme"));
}

/// A beginner knows none of the names.
TEST_F(PanelViewTest, TheFilterFindsEverydayWordsInTheSentences) {
  for (const auto& [word, key] :
       {std::pair{"rough", "surface.rms_height"}, std::pair{"speed", "sliding.velocity"},
        std::pair{"stiff", "elastomer.shear_modulus"}, std::pair{"slope", "surface.hurst"},
        std::pair{"slow", "sliding.velocity"}, std::pair{"soft", "elastomer.shear_modulus"}}) {
    filterBy(word);
    EXPECT_TRUE(hasRow(key)) << word;
  }
  filterBy("oft");  // words of sentences are found by their beginnings
  EXPECT_EQ(rowsShown(), 0);
  filterBy("seed");  // the name of a row
  EXPECT_EQ(rowsShown(), 1);
}

TEST_F(PanelViewTest, TheArrowDownLeavesTheFilterForTheFirstRowThatIsFound) {
  panel_.focusFilter();
  ASSERT_TRUE(QTest::qWaitFor([&] { return filter().hasFocus(); }));
  filterBy("normal force");
  QTest::keyClick(&filter(), Qt::Key_Down);
  EXPECT_TRUE(slider("load.normal_force").hasFocus());
  filterBy("scheme");
  QTest::keyClick(&filter(), Qt::Key_Return);
  EXPECT_TRUE(control<QWidget>("choice:accuracy.scheme")->hasFocus());
}

TEST_F(PanelViewTest, AFilterThatFindsNothingSaysSoAndEscapeClearsIt) {
  filterBy("xyz");
  EXPECT_EQ(rowsShown(), 0);
  EXPECT_TRUE(isShown("noParameterFound"));
  EXPECT_TRUE(control<QLabel>("noParameterFound")->text().contains("xyz"));
  QTest::keyClick(&filter(), Qt::Key_Escape);
  EXPECT_TRUE(filter().text().isEmpty());
  EXPECT_FALSE(isShown("noParameterFound"));
  EXPECT_GT(rowsShown(), 3);
}

TEST_F(PanelViewTest, EscapeLeavesTheFilterWithAndWithoutWords) {
  QSignalSpy left(&panel_, &ParameterPanel::filterLeft);
  for (const char* words : {"force", ""}) {
    panel_.focusFilter();
    ASSERT_TRUE(QTest::qWaitFor([&] { return filter().hasFocus(); }));
    filterBy(words);
    QTest::keyClick(&filter(), Qt::Key_Escape);  // returns the keys to the window
    EXPECT_FALSE(filter().hasFocus()) << words;
    EXPECT_TRUE(filter().text().isEmpty()) << words;
  }
  EXPECT_EQ(left.count(), 2);
}

TEST_F(PanelViewTest, EscapeInARowClearsTheFilter) {
  filterBy("force");
  QTest::keyClick(&slider("load.normal_force"), Qt::Key_Escape);
  EXPECT_TRUE(filter().text().isEmpty());
}

/// A search belongs to the scene in which it was typed; a change of this scene leaves it.
TEST_F(PanelViewTest, AFilterStaysUntilItIsCleared) {
  filterBy("seed");
  EXPECT_FALSE(hasRow("load.normal_force"));
  Scene scene;
  scene.load.normalForce = 0.02;
  panel_.setScene(scene);
  EXPECT_FALSE(hasRow("load.normal_force"));
  panel_.clearFilter();
  EXPECT_TRUE(filter().text().isEmpty());
  EXPECT_TRUE(hasRow("load.normal_force"));
}

TEST_F(PanelViewTest, ATooltipHasTheFormulaOfTheElements) {
  const auto tip = [this] {
    return slider("sliding.velocity").toolTip().replace(QChar::Nbsp, QChar::Space);
  };
  Scene scene;
  panel_.setScene(scene);
  EXPECT_TRUE(tip().contains(QStringLiteral("η v z")));
  scene.elastomer.rheology = Rheology::StandardSolid;
  panel_.setScene(scene);
  EXPECT_FALSE(tip().contains(QStringLiteral("η v z")));
  EXPECT_TRUE(tip().contains("G<sub>i</sub>"));
}

TEST_F(PanelViewTest, RowsAreLockedAndHiddenByKeySectionAndForAll) {
  panel_.setRowAccess({{"*", RowAccess::Hidden},
                       {"elastomer", RowAccess::Locked},
                       {"surface.seed", RowAccess::Free}});
  EXPECT_TRUE(hasRow("surface.seed")) << "named as free";
  EXPECT_TRUE(slider("surface.seed").isEnabled());
  EXPECT_FALSE(hasRow("sliding.velocity"));
  EXPECT_TRUE(hasRow("elastomer.shear_modulus"));
  EXPECT_FALSE(slider("elastomer.shear_modulus").isEnabled());
  const Scene before = panel_.scene();
  QTest::keyClick(&slider("elastomer.shear_modulus"), Qt::Key_Right);
  EXPECT_EQ(panel_.scene(), before);
  panel_.setRowAccess({});
  EXPECT_TRUE(hasRow("sliding.velocity"));
  EXPECT_TRUE(slider("elastomer.shear_modulus").isEnabled());
  EXPECT_FALSE(hasRow("surface.seed"));
}

TEST_F(PanelViewTest, WhatIsWrongIsSeenWhateverIsFolded) {
  panel_.showError("accuracy.scheme", "not so");
  EXPECT_TRUE(hasRow("accuracy.scheme"));
  panel_.clearErrors();
  EXPECT_FALSE(hasRow("accuracy.scheme"));
}

TEST_F(PanelViewTest, NotesAreWarningsAtTheirRows) {
  NoteSet notes;
  notes.add(Note::SlopeAbove);
  notes.add(Note::FewContacts);
  leavePanel();
  panel_.showNotes(notes);
  EXPECT_TRUE(control<QLabel>("warning:surface.rms_height")->text().contains("0.3"));
  EXPECT_TRUE(isShown("warning:load.normal_force"));
  EXPECT_FALSE(isShown("warning:sliding.velocity"));
  panel_.showNotes({});
  EXPECT_FALSE(isShown("warning:surface.rms_height"));
  EXPECT_FALSE(isShown("warning:load.normal_force"));
}

/// A slider that is dragged stays under the pointer.
TEST_F(PanelViewTest, RemarksWaitWhileASliderIsHeld) {
  QTest::qWait(1);  // the layout is made with the first events
  ValueSlider& held = slider("elastomer.shear_modulus");
  const QPoint middle = held.rect().center();
  QTest::mousePress(&held, Qt::LeftButton, {}, middle);
  ASSERT_TRUE(held.isSliderDown());
  const QPoint before = held.mapTo(&panel_, QPoint());
  NoteSet notes;
  notes.add(Note::FewContacts);
  panel_.showNotes(notes);
  panel_.showError("sliding.velocity", "too fast for this line, which has too few elements");
  QTest::qWait(1);
  EXPECT_EQ(held.mapTo(&panel_, QPoint()), before);
  EXPECT_FALSE(isShown("warning:load.normal_force"));
  QTest::mouseRelease(&held, Qt::LeftButton, {}, middle);
  leavePanel();
  EXPECT_TRUE(isShown("warning:load.normal_force"));
  EXPECT_TRUE(isShown("error:sliding.velocity"));
  QTest::mousePress(&held, Qt::LeftButton, {}, held.rect().center());
  panel_.showNotes({});
  panel_.clearErrors();
  EXPECT_TRUE(isShown("warning:load.normal_force"));
  QTest::mouseRelease(&held, Qt::LeftButton, {}, held.rect().center());
  leavePanel();
  EXPECT_FALSE(isShown("warning:load.normal_force"));
  EXPECT_FALSE(isShown("error:sliding.velocity"));
}

/// The next click after a slider is released hits the row that the pointer was going to.
TEST_F(PanelViewTest, AWarningWaitsUntilThePointerLeaves) {
  const auto enterPanel = [this] { panel_.setAttribute(Qt::WA_UnderMouse); };
  NoteSet notes;
  notes.add(Note::FewContacts);
  enterPanel();
  QTest::qWait(1);  // the layout is made with the first events
  const int place = control<QWidget>("row:elastomer.shear_modulus")->y();
  panel_.showNotes(notes);
  panel_.showError("elastomer.relaxation_time", "too long");
  QTest::qWait(1);
  EXPECT_FALSE(isShown("warning:load.normal_force"));
  EXPECT_TRUE(isShown("error:elastomer.relaxation_time")) << "an error is shown at once";
  EXPECT_EQ(control<QWidget>("row:elastomer.shear_modulus")->y(), place);
  leavePanel();
  EXPECT_TRUE(isShown("warning:load.normal_force"));
  enterPanel();
  panel_.showNotes({});
  EXPECT_TRUE(isShown("warning:load.normal_force"));
  EXPECT_TRUE(QTest::qWaitFor([this] { return !isShown("warning:load.normal_force"); }, 10000))
      << "or until it rests";
  leavePanel();
}

/// Where the rows can be scrolled, the one with the focus does not move.
TEST_F(PanelViewTest, RemarksAboveDoNotMoveTheRowInUse) {
  panel_.setView({true, {}});
  panel_.activateWindow();
  auto* row = control<QWidget>("row:surface.hurst");
  panel_.reveal("surface.hurst");
  ASSERT_TRUE(QTest::qWaitFor([&] { return slider("surface.hurst").hasFocus(); }));
  const auto place = [&] {
    QTest::qWait(1);
    return row->mapTo(&panel_, QPoint()).y();
  };
  const int before = place();
  leavePanel();
  NoteSet notes;
  notes.add(Note::FewContacts);
  panel_.showNotes(notes);
  ASSERT_TRUE(isShown("warning:load.normal_force"));
  EXPECT_EQ(place(), before);
  panel_.showError("sliding.velocity", "too fast for this line, which has too few elements");
  EXPECT_EQ(place(), before);
  panel_.showNotes({});
  panel_.clearErrors();
  EXPECT_EQ(place(), before);
}

TEST_F(PanelViewTest, ItsWidthDoesNotDependOnTheVisibleRows) {
  QTest::qWait(1);
  const int few = panel_.minimumWidth();
  panel_.setView({true, {}});
  QTest::qWait(1);
  EXPECT_EQ(panel_.minimumWidth(), few);
}

/// A scene with a long line about its arms widens a narrow panel, and leaves it as it was.
TEST_F(PanelViewTest, AWideRowOfOneSceneDoesNotWidenTheNext) {
  const Scene plain = panel_.scene();
  QTest::qWait(1);
  const int before = panel_.minimumWidth();
  panel_.resize(before, panel_.height());
  QSignalSpy released(&panel_, &ParameterPanel::widthReleased);
  const Scene wide = withManyArms(plain);
  panel_.setScene(wide);
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel_.minimumWidth() > before; }));
  panel_.setScene(plain);
  EXPECT_TRUE(QTest::qWaitFor([&] { return panel_.minimumWidth() == before; }))
      << panel_.minimumWidth() << ", not " << before;
  ASSERT_EQ(released.count(), 1);
  EXPECT_EQ(released.front().front().toInt(), before);
}

/// Steps of a lesson have scenes with other rows, which it does not show.
TEST_F(PanelViewTest, ALessonDoesNotMoveTheViewsForRowsThatItHides) {
  const Scene plain = panel_.scene();
  QTest::qWait(1);
  const int before = panel_.minimumWidth();
  const Scene wide = withManyArms(plain);
  const std::map<std::string, RowAccess> access{{"*", RowAccess::Hidden},
                                                {"sliding.velocity", RowAccess::Free}};
  panel_.planRows({{wide, access}, {plain, access}});
  panel_.setRowAccess(access);
  for (const Scene& scene : {wide, plain, wide}) {
    panel_.setScene(scene);
    QTest::qWait(1);
    EXPECT_EQ(panel_.minimumWidth(), before);
  }
  panel_.planRows({});
  panel_.setRowAccess({});
  EXPECT_TRUE(QTest::qWaitFor([&] { return panel_.minimumWidth() > before; }));
}

/// Steps of a lesson may have scenes of several kinds, whose rows need other widths.
TEST_F(PanelViewTest, TheWidthOfALessonIsThatOfItsWidestStep) {
  const Scene plain = panel_.scene();
  QTest::qWait(1);
  const int before = panel_.minimumWidth();
  const Scene wide = withManyArms(plain);
  panel_.planRows({{plain, {}}, {wide, {}}});
  const int planned = panel_.minimumWidth();
  EXPECT_GT(planned, before);
  EXPECT_EQ(panel_.scene(), plain);
  for (const Scene& scene : {wide, plain}) {
    panel_.setScene(scene);
    QTest::qWait(1);
    EXPECT_EQ(panel_.minimumWidth(), planned);
  }
  panel_.planRows({});
  EXPECT_EQ(panel_.minimumWidth(), before);
  panel_.planRows({{wide, {{"*", RowAccess::Hidden}}}});
  EXPECT_EQ(panel_.minimumWidth(), before) << "the rows are hidden";
}

TEST_F(PanelViewTest, ARowIsRevealedWhereverItIs) {
  panel_.reveal("accuracy.scheme");
  EXPECT_TRUE(hasRow("accuracy.scheme"));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return control<QWidget>("choice:accuracy.scheme")->hasFocus(); }));
  panel_.reveal("no.such.key");
}

TEST_F(PanelViewTest, SlidersAreAsWideAsThePanel) {
  for (const int width : {300, 380, 600}) {
    panel_.resize(width, 700);
    QTest::qWait(1);
    EXPECT_GT(slider("load.normal_force").width(), 0.85 * panel_.width()) << width;
  }
}

TEST_F(PanelViewTest, ShiftAndPageMakeSmallAndLargeSteps) {
  ValueSlider& force = slider("load.normal_force");
  const auto stepOf = [&](Qt::Key key, Qt::KeyboardModifiers modifiers) {
    panel_.setScene({});
    QTest::keyClick(&force, key, modifiers);
    return std::log10(panel_.scene().load.normalForce / Scene{}.load.normalForce);
  };
  const double usual = stepOf(Qt::Key_Right, Qt::NoModifier);
  const double fine = stepOf(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, 0.3 * usual);
  EXPECT_NEAR(stepOf(Qt::Key_PageUp, Qt::NoModifier), 1, 0.02) << "a decade";
  EXPECT_NEAR(stepOf(Qt::Key_PageDown, Qt::NoModifier), -1, 0.02);
}

TEST_F(PanelViewTest, ArrowsInAnEntryStepLikeTheSlider) {
  const double before = panel_.scene().load.normalForce;
  entry("load.normal_force").setFocus();
  QTest::keyClick(&entry("load.normal_force"), Qt::Key_Up);
  EXPECT_GT(panel_.scene().load.normalForce, before);
  QTest::keyClick(&entry("load.normal_force"), Qt::Key_Down);
  EXPECT_NEAR(panel_.scene().load.normalForce / before, 1, 0.02);
  type("load.normal_force", "1 N");
  entry("load.normal_force").setFocus();
  QTest::keyClick(&entry("load.normal_force"), Qt::Key_PageUp);
  EXPECT_NEAR(panel_.scene().load.normalForce, 10, 0.3);
}

TEST_F(PanelViewTest, DraggingWithShiftIsTenTimesFiner) {
  const auto drag = [&](Qt::KeyboardModifiers modifiers) {
    panel_.setScene({});
    ValueSlider& force = slider("load.normal_force");
    const int from = force.sliderPosition();
    const double x = 7.5 + (force.width() - 15.0) * from / force.maximum();
    const QPoint at(static_cast<int>(x), force.height() / 2);
    const auto send = [&](QEvent::Type type, QPoint place, Qt::MouseButton button) {
      QMouseEvent event(type, place, force.mapToGlobal(place), button, Qt::LeftButton, modifiers);
      QApplication::sendEvent(&force, &event);
    };
    send(QEvent::MouseButtonPress, at, Qt::LeftButton);
    const int grip = force.sliderPosition();
    send(QEvent::MouseMove, at, Qt::NoButton);
    send(QEvent::MouseMove, at + QPoint(60, 0), Qt::NoButton);
    const int way = force.sliderPosition() - grip;
    send(QEvent::MouseButtonRelease, at + QPoint(60, 0), Qt::LeftButton);
    return way;
  };
  const int plain = drag(Qt::NoModifier), fine = drag(Qt::ShiftModifier);
  EXPECT_GT(plain, 0);
  EXPECT_NEAR(fine, 0.1 * plain, 0.05 * plain);
}

TEST_F(PanelViewTest, EndsOfAnotherAxisHaveItsUnitAndLimits) {
  panel_.setView({true, {}});
  Scene scene;
  scene.sweep.key = "load.normal_force";
  scene.sweep.from = 1e-3;
  scene.sweep.to = 10;
  panel_.setScene(scene);
  EXPECT_EQ(entry("sweep.from").text(), "1");
  EXPECT_EQ(control<QLabel>("unit:sweep.from")->text(), "mN");
  type("sweep.from", "20 mN");
  EXPECT_EQ(panel_.scene().sweep.from, 0.02);
  type("sweep.from", "20 mm");
  EXPECT_TRUE(complaint("sweep.from").contains("length")) << complaint("sweep.from").toStdString();
  scene.sweep.key = "elastomer.temperature";
  scene.elastomer.rheology = Rheology::Kelvin;
  scene.sweep.from = 273.15;
  scene.sweep.to = 373.15;
  panel_.setScene(scene);
  type("sweep.to", QStringLiteral("60 °C"));
  EXPECT_EQ(panel_.scene().sweep.to, 333.15);
}

TEST_F(PanelViewTest, TooltipsHaveTheFormulaAndTheMenuLeadsToTheGuide) {
  EXPECT_TRUE(slider("elastomer.relaxation_time").toolTip().contains(QStringLiteral("τ = η/G")));
  EXPECT_TRUE(slider("load.normal_force").toolTip().contains("F<sub>N</sub>"));
}

/// The sentence comes first, and the key last, for those who write files.
TEST_F(PanelViewTest, TooltipsBeginWithTheSentence) {
  const QString tip = slider("sliding.velocity").toolTip();
  const qsizetype sentence = tip.indexOf("how fast or slowly it slides"),
                  formula = tip.indexOf("p = 4"), keys = tip.indexOf("Arrow keys"),
                  key = tip.indexOf("sliding.velocity");
  EXPECT_GE(sentence, 0);
  EXPECT_LT(sentence, formula);
  EXPECT_LT(formula, keys);
  EXPECT_LT(keys, key);
  EXPECT_FALSE(tip.contains("10<sup>12") || tip.contains(QStringLiteral("10¹²")))
      << tip.toStdString();
}

TEST_F(PanelViewTest, TheVelocityOfAnOscillationIsItsMean) {
  const auto label = [&] {
    for (const QLabel* found :
         panel_.findChild<QWidget*>("row:sliding.velocity")->findChildren<QLabel*>())
      if (found->textFormat() == Qt::RichText) return found->text();
    return QString();
  };
  Scene scene;
  panel_.setScene(scene);
  EXPECT_FALSE(label().contains("mean velocity"));
  scene.sliding.kind = SlidingKind::Oscillation;
  panel_.setScene(scene);
  EXPECT_TRUE(label().contains("mean velocity")) << label().toStdString();
  panel_.setScene(Scene{});
  EXPECT_FALSE(label().contains("mean velocity"));
}

}  // namespace
}  // namespace asperity
