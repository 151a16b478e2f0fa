// Help > Guide: which file it opens, and what it says where there is none.
#include <gtest/gtest.h>

#include <QDesktopServices>
#include <QDir>
#include <QTemporaryDir>
#include <QUrl>

#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/main/help_commands.h"

namespace asperity {
namespace {

/// Stands for the browser while it lives.
class Browser : public QObject {
  Q_OBJECT

 public:
  Browser() { QDesktopServices::setUrlHandler("file", this, "show"); }
  ~Browser() override { QDesktopServices::unsetUrlHandler("file"); }
  QList<QUrl> shown;

 public slots:
  void show(const QUrl& url) { shown << url; }
};

void write(const QString& file) {
  ASSERT_TRUE(QDir().mkpath(QFileInfo(file).path()));
  QFile out(file);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write("<!DOCTYPE html>");
}

TEST(Guide, IsFoundBesideAnInstalledProgramAndInABuildFolder) {
  QTemporaryDir folder;
  const QDir root(QFileInfo(folder.path()).canonicalFilePath());
  ASSERT_TRUE(root.mkpath("bin"));
  EXPECT_TRUE(guideFile(root.filePath("bin")).isEmpty());
  write(root.filePath("resources/guide/guide.html"));
  EXPECT_EQ(guideFile(root.filePath("bin")), root.filePath("resources/guide/guide.html"));
  write(root.filePath("share/asperity/guide.html"));
  EXPECT_EQ(guideFile(root.filePath("bin")), root.filePath("share/asperity/guide.html"));
}

TEST(Guide, OpensInTheBrowser) {
  QTemporaryDir folder(QDir::tempPath() + "/a guide with blanks XXXXXX");
  const QDir root(QFileInfo(folder.path()).canonicalFilePath());
  ASSERT_TRUE(root.mkpath("bin"));
  write(root.filePath("share/asperity/guide.html"));
  Browser browser;
  EXPECT_TRUE(openGuideFile(root.filePath("bin")).isEmpty());
  ASSERT_EQ(browser.shown.size(), 1);
  EXPECT_EQ(browser.shown.front().toLocalFile(), root.filePath("share/asperity/guide.html"));
  EXPECT_TRUE(openGuideFile(root.filePath("bin"), "eq-11").isEmpty());
  EXPECT_EQ(browser.shown.back().fragment(), "eq-11");
}

TEST_F(MainWindowTest, SaysWhereThereIsNoGuide) {
  // The test program lies in no folder with a guide beside it.
  Browser browser;
  auto* action = window_.findChild<QAction*>("guide");
  ASSERT_TRUE(action);
  action->trigger();
  EXPECT_TRUE(browser.shown.isEmpty());
  auto* messages = window_.findChild<MessageBar*>();
  ASSERT_TRUE(messages);
  EXPECT_TRUE(messages->isVisible());
  EXPECT_TRUE(messages->text().contains("not part of this build"));
}

}  // namespace
}  // namespace asperity

#include "guide_test.moc"
