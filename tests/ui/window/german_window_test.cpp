// The window in each language at 1280 x 720: nothing is left in English, and nothing is cut off.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <memory>
#include <set>

#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/window/accuracy_panel.h"
#include "ui/window/gallery_page.h"
#include "ui/window/message_bar.h"
#include "ui/window/scene_document.h"
#include "ui/window/window_language.h"

namespace asperity {
namespace {

using testing::IsEmpty;

using Texts = std::set<std::string>;

/// A window in a language, which goes back to English with it.
class WindowIn {
 public:
  explicit WindowIn(std::string_view code, const Scene& scene = smallScene()) {
    useLanguage(code);
    window_ = std::make_unique<MainWindow>(scene);
    window_->resize(1280, 720);
    window_->show();
  }
  ~WindowIn() {
    window_.reset();
    useLanguage("en");
  }
  MainWindow& operator*() { return *window_; }
  MainWindow* operator->() { return window_.get(); }

  /// Runs until there are a frame and a curve to speak of.
  bool waitForCurve() {
    return QTest::qWaitFor([this] { return window_->session().plot().progress >= 1; },
                           kWindowPatience);
  }

 private:
  std::unique_ptr<MainWindow> window_;
};

QString plain(QString text) {
  static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
  return text.remove(tag).remove(u'&');
}

Texts itemsOf(const QAbstractItemModel& model) {
  Texts texts;
  for (int column = 0; column < model.columnCount(); ++column) {
    texts.insert(model.headerData(column, Qt::Horizontal).toString().toStdString());
    for (int row = 0; row < model.rowCount(); ++row)
      for (const int role :
           {int(Qt::DisplayRole), int(Qt::ToolTipRole), int(Qt::AccessibleTextRole)})
        texts.insert(plain(model.index(row, column).data(role).toString()).toStdString());
  }
  return texts;
}

/// Everything that a person can read or hear of a window.
Texts textsOf(const MainWindow& window) {
  Texts texts{window.windowTitle().toStdString()};
  const auto add = [&](const QString& text) { texts.insert(plain(text).toStdString()); };
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    add(widget->toolTip());
    add(widget->accessibleName());
    add(widget->accessibleDescription());
    if (const auto* label = qobject_cast<const QLabel*>(widget)) add(label->text());
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) add(button->text());
    if (const auto* menu = qobject_cast<const QMenu*>(widget)) add(menu->title());
    if (const auto* entry = qobject_cast<const QLineEdit*>(widget)) add(entry->placeholderText());
    if (const auto* box = qobject_cast<const QComboBox*>(widget))
      texts.merge(itemsOf(*box->model()));
    if (const auto* view = qobject_cast<const QAbstractItemView*>(widget))
      if (view->model()) texts.merge(itemsOf(*view->model()));
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget))
      for (int i = 0; i < tabs->count(); ++i) add(tabs->tabText(i));
  }
  for (const QAction* action : window.findChildren<QAction*>()) {
    add(action->text());
    add(action->toolTip());
  }
  return texts;
}

/// Words of both languages, names, keys of the table (which are no words), paths.
bool isTheSame(const std::string& text) {
  static const QRegularExpression word(QStringLiteral("[A-Za-z]{4}"));
  static const QRegularExpression key(QStringLiteral("^[a-z_]+\\.[a-z0-9_.]+$|^:|^/"));
  static const std::set<QString> words{"Asperity",
                                       "English",
                                       "Deutsch",
                                       "OpenGL",
                                       "Elastomer",
                                       "Plan",
                                       "Parameter",
                                       "linear",
                                       "nodal",
                                       "Radius",
                                       "Kelvin",
                                       "Prony",
                                       "Pause",
                                       "Software (OSMesa)",
                                       "software (OSMesa)",
                                       "title",
                                       "small",
                                       "small – Asperity",
                                       "small[*] – Asperity"};
  const QString whole = QString::fromStdString(text).trimmed();
  return !word.match(whole).hasMatch() || findParameter(text) || key.match(whole).hasMatch() ||
         words.contains(whole);
}

/// What a window says in a language, its sheet of shortcuts and a step of its tour included.
Texts allTextsIn(std::string_view code) {
  WindowIn window(code);
  EXPECT_TRUE(window.waitForCurve());
  Texts texts = textsOf(*window);
  for (const char* command : {"shortcuts", "tour"}) {
    window->findChild<QAction*>(command)->trigger();
    texts.merge(textsOf(*window));
  }
  return texts;
}

/// Words of one set that stand in the other, too, though they are not the same in both languages.
Texts leftOver(const Texts& shown, const Texts& other) {
  Texts left;
  for (const std::string& text : shown)
    if (other.contains(text) && !isTheSame(text)) left.insert(text);
  return left;
}

TEST(GermanWindow, HasNothingLeftInEnglish) {
  const Texts english = allTextsIn("en"), german = allTextsIn("de");
  EXPECT_GT(german.size(), 150U);
  EXPECT_THAT(leftOver(german, english), IsEmpty());
  EXPECT_TRUE(german.contains("Reibungskurve"));
}

/// Why a visible widget does not show all of its text; empty where it does.
std::string cutOff(const QWidget& widget) {
  const auto say = [&](const QString& text, QSize needed) {
    return (text + QStringLiteral(" needs %1 x %2, has %3 x %4")
                       .arg(needed.width())
                       .arg(needed.height())
                       .arg(widget.width())
                       .arg(widget.height()))
        .toStdString();
  };
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    if (label->text().isEmpty()) return {};
    if (label->wordWrap()) {
      const int height = label->heightForWidth(label->width());
      return height > label->height() ? say(label->text(), {label->width(), height}) : "";
    }
    return label->sizeHint().width() > label->width() ? say(label->text(), label->sizeHint()) : "";
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))  // a sign may be tight
    if (button->sizeHint().width() > button->width() && button->text().size() > 1)
      return say(button->text(), button->sizeHint());
  if (const auto* box = qobject_cast<const QComboBox*>(&widget))
    if (box->sizeHint().width() > box->width()) return say(box->currentText(), box->sizeHint());
  return {};
}

/// What is cut off of everything in sight, one a line, once the layout has settled.
std::string cutOffIn(const QWidget& window) {
  static const std::set<QString> tooLong{"qt_toolbar_ext_button", "qt_menubar_ext_button"};
  std::string lines;
  const auto isWhole = [&] {
    lines.clear();
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
      if (!widget->isVisible()) continue;
      if (const std::string line = cutOff(*widget); !line.empty()) lines += line + "\n";
      if (tooLong.contains(widget->objectName())) lines += "a bar is longer than the window\n";
    }
    return lines.empty();
  };
  return QTest::qWaitFor(isWhole, 2000) ? std::string() : lines;
}

class EachLanguage : public testing::TestWithParam<const char*> {};

TEST_P(EachLanguage, NothingIsCutOff) {
  WindowIn window(GetParam());
  ASSERT_TRUE(window.waitForCurve());
  auto& tabs = *window->findChild<QTabWidget*>("tabs");
  for (const bool dark : {false, true}) {
    window->setDark(dark);
    for (int tab = 0; tab < tabs.count(); ++tab) {
      tabs.setCurrentIndex(tab);
      EXPECT_EQ(cutOffIn(*window), "") << tabs.tabText(tab).toStdString();
    }
  }
}

/// At the size of a lecturer's projector, where the texts are larger.
TEST_P(EachLanguage, NothingOfTheAccuracyPanelIsCutOffInAPresentation) {
  WindowIn window(GetParam());
  ASSERT_TRUE(window.waitForCurve());
  window->findChild<QAction*>("go:accuracyPanel")->trigger();
  window->setPresenting(true);
  window->resize(1280, 720);
  auto& panel = *window->findChild<AccuracyPanel*>("accuracyPanel");
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return !panel.findChild<QLabel*>("accuracyMeasured")->text().isEmpty(); },
      kWindowPatience));
  EXPECT_EQ(cutOffIn(panel), "");
}

TEST_P(EachLanguage, NothingOfTheFiguresPageIsCutOff) {
  WindowIn window(GetParam());
  window->openFigures();
  EXPECT_EQ(cutOffIn(*window), "");
}

INSTANTIATE_TEST_SUITE_P(Window, EachLanguage, testing::Values("en", "de"),
                         [](const auto& each) { return std::string(each.param); });

TEST(GermanWindow, NumbersHaveACommaAndMayBeTypedWithEither) {
  WindowIn window("de");
  auto* entry = window->findChild<ValueEntry*>("entry:surface.hurst");
  EXPECT_EQ(entry->text(), "0,7");
  for (const char* text : {"0,25", "0.25"}) {
    entry->setFocus();
    entry->selectAll();
    QTest::keyClicks(entry, text);
    QTest::keyClick(entry, Qt::Key_Return);
    EXPECT_EQ(window->session().scene().surface.hurst, 0.25) << text;
    EXPECT_EQ(entry->text(), "0,25");
    EXPECT_FALSE(entry->hasError());
  }
}

TEST(GermanWindow, ARefusalIsGerman) {
  WindowIn window("de");
  auto* entry = window->findChild<ValueEntry*>("entry:surface.hurst");
  entry->setFocus();
  entry->selectAll();
  QTest::keyClicks(entry, "1,4");
  QTest::keyClick(entry, Qt::Key_Return);
  EXPECT_EQ(window->findChild<QLabel*>("error:surface.hurst")->text(),
            "1,4 liegt außerhalb von 0 bis 1");
  entry = window->findChild<ValueEntry*>("entry:load.normal_force");
  entry->setFocus();
  entry->selectAll();
  QTest::keyClicks(entry, "0.5 kg");
  QTest::keyClick(entry, Qt::Key_Return);
  EXPECT_EQ(window->findChild<QLabel*>("error:load.normal_force")->text(),
            "0,5 kg ist eine Masse; gefragt ist eine Kraft, etwa 3,4 mN");
}

TEST(LanguageSwitch, LeavesNoWordBehindInEitherDirection) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  window->findChild<QAction*>("tour")->trigger();
  ASSERT_TRUE(window.waitForCurve());
  const Texts english = textsOf(*window);
  window->setLanguage("de");
  EXPECT_EQ(presentLanguage(), "de");
  ASSERT_TRUE(window.waitForCurve());
  EXPECT_TRUE(window->isTouring());
  const Texts german = textsOf(*window);
  EXPECT_THAT(leftOver(german, english), IsEmpty());
  EXPECT_GT(german.size(), 150U);
  EXPECT_EQ(cutOffIn(*window), "");
  window->setLanguage("en");
  const Texts back = textsOf(*window);
  EXPECT_THAT(leftOver(back, german), IsEmpty());
  EXPECT_TRUE(back.contains("Friction curve"));
}

TEST(LanguageSwitch, KeepsSceneHistoryRunsAndLayout) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  Scene scene = window->session().scene();
  scene.load.normalForce = 0.01;
  window->editScene(scene);
  window->findChild<QAction*>("resetAll")->trigger();
  window->document().history().undo();
  window->setDark(true);
  window->findChild<QDockWidget*>("parameterDock")->hide();
  auto* tabs = window->findChild<QTabWidget*>("tabs");
  const QString name = tabs->widget(2)->objectName();
  tabs->setCurrentIndex(2);
  window->session().setPlaying(false);
  const auto number = window->session().sceneNumber();
  const auto actions = window->findChildren<QAction*>().size();

  for (const char* code : {"de", "en", "de"}) window->setLanguage(code);
  EXPECT_EQ(window->session().scene(), scene);
  EXPECT_EQ(window->session().sceneNumber(), number);  // nothing was begun anew
  EXPECT_FALSE(window->session().isPlaying());
  EXPECT_TRUE(window->isDark());
  EXPECT_TRUE(window->findChild<QDockWidget*>("parameterDock")->isHidden());
  tabs = window->findChild<QTabWidget*>("tabs");
  EXPECT_EQ(tabs->currentWidget()->objectName(), name);
  EXPECT_EQ(window->findChildren<QAction*>().size(), actions);
  EXPECT_EQ(window->findChild<QAction*>("play")->text(), "Start");

  QUndoStack& history = window->document().history();
  EXPECT_EQ(history.count(), 2);
  EXPECT_EQ(history.undoText(), "Normalkraft");
  EXPECT_EQ(history.redoText(), "Alle Parameter");
  window->findChild<QAction*>("undo")->trigger();
  EXPECT_EQ(window->session().scene().load.normalForce, smallScene().load.normalForce);
  EXPECT_EQ(window->panel().scene(), window->session().scene());
  QTest::keyClick(&*window, Qt::Key_F9);  // the key is no one's twice
  EXPECT_FALSE(window->findChild<QDockWidget*>("parameterDock")->isHidden());
}

TEST(LanguageSwitch, KeepsComplaintsComparisonsAndFigures) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  window->findChild<QCheckBox*>("comparisonWanted")->setChecked(true);
  window->openFigures();
  FigureGallery* figures = &window->gallery().gallery();
  window->setLanguage("de");
  EXPECT_TRUE(window->isShowingFigures());
  EXPECT_EQ(&window->gallery().gallery(), figures);
  window->closeFigures();
  EXPECT_TRUE(window->findChild<QCheckBox*>("comparisonWanted")->isChecked());

  Scene empty = smallScene();
  empty.elastomer.rheology = Rheology::Prony;
  empty.elastomer.equilibriumModulus = 0;
  empty.elastomer.arms.clear();
  window->editScene(empty);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->messages().isVisible(); }, kWindowPatience));
  const QString key = window->messages().text().section(':', 0, 0);
  window->setLanguage("en");
  EXPECT_TRUE(window->messages().isVisible());
  EXPECT_TRUE(window->messages().text().startsWith(key));
  EXPECT_TRUE(window->findChild<ValueEntry*>("entry:" + key)->hasError());
}

TEST(LanguageSwitch, KeepsAMessageThatIsNotAboutTheScene) {
  WindowIn window("en");
  ASSERT_TRUE(window.waitForCurve());
  window->messages().showMessage("cannot be read");
  window->setLanguage("de");
  EXPECT_TRUE(window->messages().isVisible());
  EXPECT_EQ(window->messages().text(), "cannot be read");
  window->messages().endComplaint();
  EXPECT_TRUE(window->messages().isVisible());
  window->messages().hide();
  window->setLanguage("en");
  EXPECT_FALSE(window->messages().isVisible());
}

TEST(LanguageSwitch, KeepsTheMeasuredComparisonOfMethods) {
  WindowIn window("en");
  auto* panel = window->findChild<AccuracyPanel*>("accuracyPanel");
  auto made = std::make_shared<MadeFigure>();
  made->figure.sheet.diagrams.resize(2);
  made->figure.sheet.diagrams[0].title = "region I: here";
  made->figure.sheet.diagrams[1].title = "region II: there";
  panel->showComparedMethods({window->session().scene(), made});
  ASSERT_TRUE(panel->comparedMethods());
  window->setLanguage("de");
  panel = window->findChild<AccuracyPanel*>("accuracyPanel");
  ASSERT_TRUE(panel->comparedMethods());
  EXPECT_EQ(panel->comparedMethods()->figure, made);
  EXPECT_TRUE(panel->findChild<QToolButton*>("region:1"));
  Scene other = window->session().scene();
  other.load.normalForce *= 2;
  window->editScene(other);
  EXPECT_FALSE(panel->comparedMethods());
}

TEST(WindowLanguageMenu, TheChoiceCountsAtOnceAndIsRemembered) {
  WindowIn window("en");
  auto* german = window->findChild<QAction*>("language:de");
  ASSERT_TRUE(german);
  german->trigger();
  EXPECT_EQ(windowLanguage(), "de");
  ASSERT_TRUE(QTest::qWaitFor([] { return presentLanguage() == "de"; }, kWindowPatience));
  EXPECT_TRUE(window->findChild<QAction*>("language:de")->isChecked());
  EXPECT_EQ(window->findChild<QTabWidget*>("tabs")->tabText(0), "Reibungskurve");
  window->findChild<QAction*>("language:en")->trigger();
  EXPECT_EQ(windowLanguage(), "en");
  ASSERT_TRUE(QTest::qWaitFor([] { return presentLanguage() == "en"; }, kWindowPatience));
  window->findChild<QAction*>("language:")->trigger();
  EXPECT_FALSE(QSettings().contains("language"));
}

}  // namespace
}  // namespace asperity
