// The gallery of scenes: every shipped scene has a card, with a picture that Asperity drew; keys,
// filter and mouse; the cache of pictures.
#include "ui/window/gallery/scene_gallery.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolButton>
#include <algorithm>
#include <map>
#include <set>

#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/gallery/card_list.h"
#include "ui/window/gallery/scene_cards.h"
#include "ui/window/gallery/scene_thumbnails.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

/// The number of different colours of a picture, up to 50.
int colours(const QImage& image) {
  std::set<QRgb> found;
  for (int y = 0; y < image.height() && found.size() < 50; y += 3)
    for (int x = 0; x < image.width(); x += 3) found.insert(image.pixel(x, y));
  return static_cast<int>(std::min<std::size_t>(found.size(), 50));
}

TEST(SceneCards, EveryShippedSceneHasOneWithASentence) {
  std::set<QString> scenes, cards;
  for (const LibraryScene& entry : libraryScenes()) scenes.insert(entry.name);
  for (const SceneCard& card : sceneCards()) {
    EXPECT_TRUE(cards.insert(card.scene).second) << card.scene << " twice";
    const QString sentence = cardSentence(card);
    EXPECT_TRUE(sentence.endsWith('.')) << card.scene;
    EXPECT_LE(sentence.size(), 110) << card.scene;
  }
  EXPECT_EQ(cards, scenes);
  EXPECT_EQ(findCard("no such scene"), nullptr);
}

TEST(ScenePicture, EverySceneHasOneInBothThemes) {
  std::set<QByteArray> all;
  for (const LibraryScene& entry : libraryScenes())
    for (const Theme& theme : {lightTheme(), darkTheme()}) {
      const QImage image = drawScenePicture(entry.scene, findCard(entry.name)->view, theme);
      EXPECT_EQ(image.size(), kScenePicture) << entry.name.toStdString();
      EXPECT_GE(colours(image), 8) << entry.name.toStdString();
      const bool isNew = all.insert(QByteArray(reinterpret_cast<const char*>(image.constBits()),
                                               static_cast<qsizetype>(image.sizeInBytes())))
                             .second;
      EXPECT_TRUE(isNew) << entry.name.toStdString() << " looks like another scene";
    }
}

/// Returns how much darker than the ground the strongest grid line is that these pixels cross, as a
/// sum over its width.
int inkOfGridLine(const std::vector<int>& values) {
  const int ground = std::ranges::max(values);
  int ink = 0, most = 0;
  for (const int value : values) {
    ink = value < ground ? ink + ground - value : 0;
    most = std::max(most, ink);
  }
  return most;
}

/// Grid lines of both directions are equally wide, so that marks of points are round.
TEST(ScenePicture, ACurveIsNotStretched) {
  const QImage image = drawScenePicture({}, SceneView::Curve, lightTheme());
  // The upper left corner is far from the curve, whose friction rises with velocity.
  constexpr int kEdge = 16;
  const int right = image.width() / 4, lower = image.height() / 4;
  const auto value = [&](int x, int y) { return image.pixelColor(x, y).value(); };
  int upright = 0, level = 0;
  for (int y = kEdge; y < lower; ++y) {
    std::vector<int> row;
    for (int x = kEdge; x < right; ++x) row.push_back(value(x, y));
    upright = std::max(upright, inkOfGridLine(row));
  }
  for (int x = kEdge; x < right; ++x) {
    std::vector<int> column;
    for (int y = kEdge; y < lower; ++y) column.push_back(value(x, y));
    level = std::max(level, inkOfGridLine(column));
  }
  EXPECT_GT(level, 10);
  EXPECT_NEAR(static_cast<double>(upright) / level, 1, 0.1);
}

class Thumbnails : public testing::Test {
 protected:
  static QImage plain() {
    QImage image(kScenePicture, QImage::Format_RGB32);
    image.fill(Qt::red);
    return image;
  }
  SceneThumbnails::Drawing counting() {
    return [this](const Scene&, SceneView, const Theme&, const std::stop_token&) {
      ++drawn_;
      return plain();
    };
  }
  bool finish(SceneThumbnails& thumbnails) {
    return QTest::qWaitFor([&] { return !thumbnails.isWorking(); }, kWindowPatience);
  }
  QTemporaryDir folder_;
  std::atomic<int> drawn_ = 0;
};

TEST_F(Thumbnails, AreDrawnOnceAndThenComeFromTheCache) {
  const auto count = static_cast<int>(libraryScenes().size());
  for (int i = 0; i < 2; ++i) {
    SceneThumbnails thumbnails(counting(), folder_.path());
    EXPECT_TRUE(thumbnails.picture("figure_1").isNull()) << "not before it is drawn";
    thumbnails.requestAll();
    ASSERT_TRUE(finish(thumbnails));
    EXPECT_EQ(thumbnails.picture("figure_1").toImage().pixelColor(9, 9), QColor(Qt::red));
    EXPECT_EQ(drawn_, count);
  }
  SceneThumbnails dark(counting(), folder_.path());
  dark.setTheme(darkTheme());
  dark.requestAll();
  ASSERT_TRUE(finish(dark));
  EXPECT_EQ(drawn_, 2 * count);
}

TEST_F(Thumbnails, ADamagedFileIsDrawnAgainAndAFolderThatCannotBeWrittenIsPassedOver) {
  const LibraryScene& scene = libraryScenes().front();
  const QString file =
      folder_.filePath(thumbnailName(scene.scene, findCard(scene.name)->view, lightTheme()));
  QFile damaged(file);
  ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
  damaged.write("no picture");
  damaged.close();
  for (const QString& folder : {folder_.path(), QStringLiteral("/dev/null/nowhere")}) {
    SceneThumbnails thumbnails(counting(), folder);
    thumbnails.picture(scene.name);
    ASSERT_TRUE(finish(thumbnails));
    EXPECT_FALSE(thumbnails.picture(scene.name).isNull());
  }
  EXPECT_EQ(drawn_, 2);
  EXPECT_FALSE(QImage(file).isNull());
}

TEST_F(Thumbnails, ASceneThatCannotBeDrawnHasNone) {
  SceneThumbnails thumbnails(
      [](const Scene&, SceneView, const Theme&, const std::stop_token&) -> QImage {
        throw std::runtime_error("nothing can draw");
      },
      folder_.path());
  thumbnails.requestAll();
  ASSERT_TRUE(finish(thumbnails));
  EXPECT_TRUE(thumbnails.picture("figure_1").isNull());
}

TEST_F(Thumbnails, ANameChangesWithAllThatShapesThePicture) {
  Scene scene = smallScene();
  const QString name = thumbnailName(scene, SceneView::Contact, lightTheme());
  EXPECT_EQ(thumbnailName(scene, SceneView::Contact, lightTheme()), name);
  EXPECT_NE(thumbnailName(scene, SceneView::Curve, lightTheme()), name);
  EXPECT_NE(thumbnailName(scene, SceneView::Contact, darkTheme()), name);
  scene.load.normalForce *= 2;
  EXPECT_NE(thumbnailName(scene, SceneView::Contact, lightTheme()), name);
}

class GalleryTest : public MainWindowTest {
 protected:
  void SetUp() override {
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    QTest::keyClick(&window_, Qt::Key_N, Qt::ControlModifier);
    QCoreApplication::processEvents();
  }
  SceneGallery& gallery() { return window_.pages().gallery(); }
  CardList& cards() { return gallery().cards(); }
  QLineEdit& filter() { return control<QLineEdit>("sceneFilter"); }
  void key(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
};

TEST_F(GalleryTest, CoversTheViewsUntilEscape) {
  EXPECT_TRUE(window_.pages().isShowingGallery());
  EXPECT_TRUE(cards().hasFocus());
  EXPECT_EQ(cards().cardCount(), static_cast<int>(libraryScenes().size()));
  EXPECT_TRUE(action("gallery").isChecked());
  EXPECT_FALSE(action("play").isEnabled());
  EXPECT_FALSE(control<QWidget>("parameterDock").isVisible());
  key(Qt::Key_Escape);
  EXPECT_TRUE(window_.pages().isShowingViews());
  EXPECT_FALSE(action("gallery").isChecked());
  EXPECT_TRUE(control<QWidget>("parameterDock").isVisible());
  EXPECT_EQ(session().scene(), smallScene());
}

TEST_F(GalleryTest, ArrowsAndEnterOpenASceneThatUndoTakesBack) {
  key(Qt::Key_Home);
  EXPECT_EQ(cards().chosen(), libraryScenes()[0].name);
  key(Qt::Key_Right);
  EXPECT_EQ(cards().chosen(), libraryScenes()[1].name);
  key(Qt::Key_Left);
  key(Qt::Key_Left);
  EXPECT_EQ(cards().chosen(), libraryScenes()[0].name);
  key(Qt::Key_Right);
  answer(QMessageBox::Cancel);
  key(Qt::Key_Return);
  EXPECT_EQ(asked_, 0);
  EXPECT_TRUE(window_.pages().isShowingViews());
  EXPECT_EQ(session().scene(), libraryScenes()[1].scene);
  EXPECT_EQ(window_.document().origin().shipped, libraryScenes()[1].name);
  EXPECT_EQ(window_.document().history().count(), 1);
  action("undo").trigger();
  EXPECT_EQ(session().scene(), smallScene());
}

/// Down reaches the card below over a heading, and up leads back; no key stands on a heading.
TEST_F(GalleryTest, DownAndUpGoFromLineToLine) {
  key(Qt::Key_Home);
  std::set<QString> visited;
  QString last;
  while (cards().chosen() != last) {
    last = cards().chosen();
    EXPECT_FALSE(last.isEmpty());
    EXPECT_TRUE(visited.insert(last).second);
    key(Qt::Key_Down);
  }
  EXPECT_GE(visited.size(), 7U);  // a line for each chapter at least
  for (std::size_t i = 0; i < visited.size(); ++i) key(Qt::Key_Up);
  EXPECT_EQ(cards().chosen(), libraryScenes()[0].name);
  key(Qt::Key_End);
  EXPECT_EQ(cards().chosen(), libraryScenes().back().name);
}

TEST_F(GalleryTest, AClickOpensAScene) {
  cards().choose("region_3");
  const QRect place = cards().visualRect(cards().currentIndex());
  QTest::mouseClick(cards().viewport(), Qt::LeftButton, {}, place.center());
  EXPECT_EQ(window_.document().origin().shipped, "region_3");
}

TEST_F(GalleryTest, TheFilterFindsWordsAndEnterOpensTheFirst) {
  key(Qt::Key_Slash);
  EXPECT_TRUE(filter().hasFocus());
  QTest::keyClicks(&filter(), "sandpaper");
  EXPECT_EQ(cards().cardCount(), 1);
  EXPECT_EQ(cards().chosen(), "rubber_on_sandpaper");
  filter().setText("TEMPERATURE cold");
  EXPECT_EQ(cards().chosen(), "temperature_cold");
  filter().setText("no such words");
  EXPECT_EQ(cards().cardCount(), 0);
  EXPECT_TRUE(control<QWidget>("noScene").isVisible());
  key(Qt::Key_Return);
  EXPECT_TRUE(window_.pages().isShowingGallery());
  key(Qt::Key_Escape);  // empties the filter
  EXPECT_TRUE(window_.pages().isShowingGallery());
  EXPECT_EQ(cards().cardCount(), static_cast<int>(libraryScenes().size()));
  QTest::keyClicks(&cards(), "tyre");  // letters go to the filter
  EXPECT_EQ(filter().text(), "tyre");
  key(Qt::Key_Return);
  EXPECT_EQ(window_.document().origin().shipped, "tyre_on_asphalt");
}

TEST_F(GalleryTest, BeginsAtThePresentScene) {
  key(Qt::Key_Escape);
  action("scene:velocity_step").trigger();
  action("gallery").trigger();
  EXPECT_EQ(cards().chosen(), "velocity_step");
}

/// The list has another width when it was filled than when it is seen.
TEST_F(GalleryTest, ShowsTheWholeCardOfThePresentScene) {
  for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
    window_.resize(size);
    for (const char* scene : {"reversal", "wedge", "tyre_on_asphalt", "figure_2"}) {
      if (window_.pages().isShowingGallery()) key(Qt::Key_Escape);
      action(QStringLiteral("scene:") + scene).trigger();
      action("gallery").trigger();
      QCoreApplication::processEvents();
      EXPECT_TRUE(cards().viewport()->rect().contains(cards().visualRect(cards().currentIndex())))
          << scene << ", width " << size.width();
    }
  }
}

/// Pages follow each other without leaving the parts around them hidden.
TEST_F(GalleryTest, FiguresAndGalleryTakeTurns) {
  window_.pages().openFigures();
  EXPECT_FALSE(window_.pages().isShowingGallery());
  EXPECT_FALSE(action("gallery").isChecked());
  EXPECT_TRUE(action("figures").isChecked());
  window_.openGallery();
  EXPECT_FALSE(action("figures").isChecked());
  key(Qt::Key_Escape);
  EXPECT_TRUE(control<QWidget>("parameterDock").isVisible());
  EXPECT_TRUE(action("play").isEnabled());
}

TEST_F(GalleryTest, CardsAreNamedForAScreenReader) {
  for (int row = 0; row < cards().count(); ++row) {
    const QListWidgetItem& item = *cards().item(row);
    if (!(item.flags() & Qt::ItemIsEnabled)) continue;
    const QString name = item.data(Qt::AccessibleTextRole).toString();
    EXPECT_GT(name.size(), 20) << row;
  }
  EXPECT_FALSE(cards().accessibleName().isEmpty());
  EXPECT_FALSE(filter().accessibleName().isEmpty());
}

/// No text of a card is cut off, at any width of the window.
TEST_F(GalleryTest, TextsFitTheirCards) {
  for (const int width : {900, 1024, 1280, 1700}) {
    window_.resize(width, 700);
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    QFont bold = cards().font();
    bold.setBold(true);
    int right = 0, rightOfCards = 0;
    for (int row = 0; row < cards().count(); ++row) {
      const QListWidgetItem& item = *cards().item(row);
      const QRect place = cards().visualItemRect(&item);
      right = std::max(right, place.right());
      if (!(item.flags() & Qt::ItemIsEnabled)) continue;
      rightOfCards = std::max(rightOfCards, place.right());
      const QRect inside(0, 0, place.width() - 23, 9999);
      const int texts =
          QFontMetrics(bold)
              .boundingRect(inside, Qt::TextWordWrap, item.data(Qt::UserRole + 1).toString())
              .height() +
          QFontMetrics(cards().font())
              .boundingRect(inside, Qt::TextWordWrap, item.data(Qt::UserRole + 2).toString())
              .height();
      EXPECT_LE(0.6 * place.width() + texts + 10, place.height()) << width << " " << row;
    }
    EXPECT_LE(right, cards().viewport()->width()) << width;
    // A full row uses the width: no broader strip is free behind it than before it.
    constexpr int kRest = 12;  // pixels that the columns cannot share
    EXPECT_GE(rightOfCards, cards().viewport()->width() - cards().spacing() - kRest) << width;
  }
}

/// Chapters have few scenes: many small cards would leave half of each row free.
TEST_F(GalleryTest, ALargeScreenIsFilled) {
  window_.resize(2560, 1400);
  QCoreApplication::sendPostedEvents();
  QCoreApplication::processEvents();
  std::map<int, int> rows;  // of cards, by their height
  for (int row = 0; row < cards().count(); ++row)
    if (const QListWidgetItem& item = *cards().item(row); item.flags() & Qt::ItemIsEnabled)
      ++rows[cards().visualItemRect(&item).top()];
  const int columns =
      std::ranges::max_element(rows, {}, &std::pair<const int, int>::second)->second;
  EXPECT_GE(cards().cardCount(), 0.75 * columns * static_cast<double>(rows.size()));
}

/// Lessons are what else a first start can begin with.
TEST_F(GalleryTest, LeadsToTheLessons) {
  auto& button = control<QToolButton>("gallery:lessons");
  EXPECT_TRUE(button.isVisible());
  EXPECT_EQ(button.text(), "Lessons");
  EXPECT_EQ(QAccessible::queryAccessibleInterface(&button)->text(QAccessible::Name), "Lessons");
  button.setFocus();
  QTest::keyClick(&button, Qt::Key_Tab);
  ASSERT_NE(QApplication::focusWidget(), nullptr);
  EXPECT_EQ(QApplication::focusWidget()->objectName().toStdString(), "sceneFilter");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  EXPECT_TRUE(cards().hasFocus());
  button.setFocus();
  QTest::keyClick(&button, Qt::Key_Return);
  EXPECT_NE(window_.findChild<QDialog*>("lessonList"), nullptr);
}

}  // namespace
}  // namespace asperity
