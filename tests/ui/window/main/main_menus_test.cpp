// The menus of the window in each language: every entry has a letter of its own, and no menu is
// empty, or too long for a small screen.
#include <gtest/gtest.h>

#include <QMenu>
#include <QMenuBar>
#include <map>

#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/window_in.h"

namespace asperity {
namespace {

/// In lower case; null where there is none.
QChar letterOf(QString text) {
  text.replace(QStringLiteral("&&"), QStringLiteral("  "));
  const qsizetype mark = text.indexOf(u'&');
  return mark < 0 ? QChar() : text[mark + 1].toLower();
}

class MenusInEachLanguage : public testing::TestWithParam<const char*> {};

TEST_P(MenusInEachLanguage, EveryEntryOfEveryMenuHasALetterOfItsOwn) {
  WindowIn window(GetParam());
  ASSERT_TRUE(window.waitForCurve());
  window->findChild<QAction*>("pinCurve")->trigger();
  QList<QMenu*> menus = window->menuBar()->findChildren<QMenu*>();
  EXPECT_GT(menus.size(), 12);
  const auto expectOwnLetters = [](const QList<QAction*>& entries) {
    std::map<QChar, QString> owners;
    for (const QAction* entry : entries) {
      if (entry->isSeparator() || !entry->isVisible()) continue;
      const QChar letter = letterOf(entry->text());
      EXPECT_FALSE(letter.isNull()) << entry->text().toStdString();
      EXPECT_FALSE(owners.contains(letter))
          << entry->text().toStdString() << " and " << owners[letter].toStdString();
      owners[letter] = entry->text();
    }
  };
  expectOwnLetters(window->menuBar()->actions());
  for (QMenu* menu : menus) {
    emit menu->aboutToShow();
    expectOwnLetters(menu->actions());
  }
}

TEST_P(MenusInEachLanguage, EveryMenuHasAnEntryAndFitsBelowItsTitle) {
  constexpr int kLowScreen = 700;  // pixels
  WindowIn window(GetParam());
  const int below = kLowScreen - window->menuBar()->height();
  for (QMenu* menu : window->menuBar()->findChildren<QMenu*>()) {
    const std::string title = menu->title().toStdString();
    emit menu->aboutToShow();
    EXPECT_FALSE(menu->isEmpty()) << title;
    EXPECT_TRUE(menu->isEnabled()) << title;
    EXPECT_LE(menu->sizeHint().height(), below) << title;
  }
}

INSTANTIATE_TEST_SUITE_P(Mnemonics, MenusInEachLanguage, testing::Values("en", "de"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace asperity
