// What all pages have that import a file: its beginning while it is refused, progress that can be
// stopped, and how the page is left.
#include "ui/window/import/import_page.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLayout>
#include <QPlainTextEdit>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <future>
#include <string>
#include <utility>

#include "tests/ui/window/import/surface_import_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/figures/diagram_view.h"

namespace asperity {
namespace {

using ImportPageTest = SurfaceImportTest;

TEST_F(ImportPageTest, CancelLeavesEverything) {
  const Scene before = scene();
  openPage(sineFile());
  ASSERT_TRUE(waitForPage());
  choose("surface.form", "parabola");
  ASSERT_TRUE(waitForPage());
  click("importCancel");
  ASSERT_TRUE(waitFor([&] { return page_.isNull(); }));
  EXPECT_EQ(scene(), before);
  EXPECT_EQ(window_.document().history().count(), 0);
}

TEST_F(ImportPageTest, ReturnPressesTheButtonWithTheFocus) {
  const Scene before = scene();
  openPage(sineFile());
  ASSERT_TRUE(waitForPage());
  auto& entry = inPage<ValueEntry>("entry:surface.short_wave_cut");
  entry.setFocus();
  QTest::keyClick(&entry, Qt::Key_Return);
  EXPECT_TRUE(page_->isVisible());
  inPage<QPushButton>("importCancel").setFocus();
  QTest::keyClick(&inPage<QPushButton>("importCancel"), Qt::Key_Return);
  EXPECT_FALSE(page_->isVisible());
  EXPECT_EQ(scene(), before);
}

/// A person sees what was refused: whole lines of a text, and nothing of what is none.
TEST_F(ImportPageTest, ShowsHowARefusedFileBegins) {
  std::string text = "Höhe in μm, ohne Zahlen\n";
  while (text.size() < 10000) text += "these are words and no numbers\n";
  openPage(write("words.csv", text));
  ASSERT_TRUE(waitForPage());
  auto& beginning = inPage<QPlainTextEdit>("importBeginning");
  EXPECT_TRUE(beginning.isVisibleTo(page_));
  const QString shown = beginning.toPlainText();
  EXPECT_TRUE(shown.startsWith(QStringLiteral("Höhe in μm, ohne Zahlen\nthese are words")));
  EXPECT_TRUE(shown.endsWith(QStringLiteral("no numbers\n")));
  EXPECT_LT(shown.size(), 5000);
  EXPECT_FALSE(inPage<DiagramView>("surfaceProfile").isVisibleTo(page_));
}

TEST_F(ImportPageTest, ShowsNothingOfARefusedFileThatIsNoText) {
  openPage(write("noise.dat", std::string("\x89PNG\0\x01\x02\0\xff\0\0", 12)));
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
  // A sheet says so: the page would be half empty.
  const auto& beginning = inPage<QPlainTextEdit>("importBeginning");
  EXPECT_TRUE(beginning.isVisibleTo(page_));
  EXPECT_EQ(beginning.toPlainText(), QString());
  EXPECT_EQ(beginning.placeholderText(), "Nothing of this file can be shown.");
}

/// Where nothing of the file can be shown, its name does not move into the middle of the page.
TEST_F(ImportPageTest, TheNameOfAnEmptyFileStaysAtTheTop) {
  openPage(write("empty.csv", ""));
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(page_->errorText().contains("is empty")) << page_->errorText().toStdString();
  page_->layout()->activate();
  const auto& name = inPage<QLabel>("importFile");
  EXPECT_LE(name.geometry().bottom(), 3 * name.fontMetrics().lineSpacing() + 12);
}

TEST_F(ImportPageTest, ReadingCanBeStopped) {
  std::string text = "x [mm];z [um]\n";
  for (int i = 0; i < 300000; ++i)
    text += std::to_string(1e-3 * i) + ";" + std::to_string(std::sin(0.01 * i)) + "\n";
  openPage(write("long.csv", text));
  ASSERT_TRUE(page_->isReading());
  EXPECT_TRUE(inPage<QProgressBar>("importProgress").isVisible());
  click("importStop");
  EXPECT_FALSE(page_->isReading());
  EXPECT_FALSE(page_->isReady());
  EXPECT_FALSE(page_->errorText().isEmpty());
  click("importStop");  // reads it again
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(page_->isReady()) << page_->errorText().toStdString();
}

/// A page whose work cannot be stopped, but for a gate.
class GatedPage : public ImportPage {
 public:
  GatedPage(std::shared_future<void> gate, QWidget* parent)
      : ImportPage("gated.txt", "use", parent), gate_(std::move(gate)) {
    restart();
  }

 protected:
  void begin() override {
    work().request([gate = gate_](const BackgroundWork::Run&) { gate.wait(); }, [] {});
  }

 private:
  std::shared_future<void> gate_;
};

/// The window does not wait until the work of a page that is closed has stopped.
TEST_F(ImportPageTest, AClosedPageGoesWhenItsWorkHasStopped) {
  std::promise<void> gate;
  const QPointer<ImportPage> gated = new GatedPage(gate.get_future().share(), &window_);
  gated->open();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(gated));
  QTest::keyClick(gated, Qt::Key_Escape);
  EXPECT_FALSE(gated->isVisible());
  QTest::qWait(100);  // its deletion would wait here for ever
  ASSERT_FALSE(gated.isNull());
  // Another page opens meanwhile.
  openPage(sineFile());
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(gated.isNull());
  gate.set_value();
  EXPECT_TRUE(waitFor([&] { return gated.isNull(); }));
  EXPECT_FALSE(page_.isNull());
}

}  // namespace
}  // namespace asperity
