// The window in each language at 1280 x 720: nothing is left in English, and nothing is cut off.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
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
#include <QTreeWidget>
#include <memory>
#include <set>

#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/window/message_bar.h"
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

TEST(GermanWindow, HasNothingLeftInEnglish) {
  const Texts english = allTextsIn("en"), german = allTextsIn("de");
  EXPECT_GT(german.size(), 150U);
  Texts left;
  for (const std::string& text : german)
    if (english.contains(text) && !isTheSame(text)) left.insert(text);
  EXPECT_THAT(left, IsEmpty());
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
std::string cutOffIn(const MainWindow& window) {
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

TEST(WindowLanguageMenu, TheChoiceIsRememberedForTheNextWindow) {
  WindowIn window("en");
  auto* german = window->findChild<QAction*>("language:de");
  ASSERT_TRUE(german);
  german->trigger();
  EXPECT_EQ(windowLanguage(), "de");
  EXPECT_TRUE(window->messages().isVisible());
  EXPECT_EQ(window->messages().text(), "The language changes when Asperity is started again.");
  window->findChild<QAction*>("language:en")->trigger();
  EXPECT_EQ(windowLanguage(), "en");
  window->findChild<QAction*>("language:")->trigger();
  EXPECT_FALSE(QSettings().contains("language"));
}

}  // namespace
}  // namespace asperity
