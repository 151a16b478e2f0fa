// The shipped scenes in the menu, and what the window says of them.
#include "ui/window/main/scene_library.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <utility>

#include "core/base/input_error.h"
#include "core/lesson/lesson_file.h"
#include "core/scene/essentials.h"
#include "core/scene/parameters.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/session.h"

namespace asperity {
namespace {

TEST_F(MainWindowTest, TheLibraryIsInTheMenu) {
  for (const char* name : {"scene:figure_1", "scene:figure_2"}) {
    auto* action = window_.findChild<QAction*>(name);
    ASSERT_TRUE(action) << name;
    const std::uint64_t before = session().sceneNumber();
    action->trigger();
    EXPECT_EQ(session().sceneNumber(), before + 1);
    EXPECT_EQ(window_.panel().scene(), session().scene());
  }
}

TEST(SceneLibrary, EveryFileOfTheFolderIsInTheProgram) {
  std::set<std::string> files, shipped;
  for (const auto& file : std::filesystem::directory_iterator(ASPERITY_RESOURCES_DIR "/scenes"))
    if (file.path().extension() == ".json") files.insert(file.path().stem().string());
  for (const LibraryScene& entry : libraryScenes()) shipped.insert(entry.name.toStdString());
  EXPECT_EQ(shipped, files);
}

/// A description that asks for a parameter which the panel does not show at first says where it is.
TEST(SceneLibrary, DescriptionsSayWhereHiddenParametersAre) {
  constexpr std::array<std::pair<const char*, const char*>, 4> kNamed{
      {{"region_3", "elastomer.shear_modulus"},
       {"region_4", "surface.elements"},
       {"prony_dashpot", "elastomer.viscosity"},
       {"standard_solid", "elastomer.arms"}}};
  for (const auto& [name, key] : kNamed) {
    const Scene& scene = findLibraryScene(name)->scene;
    ASSERT_TRUE(isApplicable(knownParameter(key), scene)) << name;
    const std::vector<std::string_view> shown = essentialKeys(scene);
    const bool isHidden = std::ranges::find(shown, key) == shown.end();
    EXPECT_EQ(scene.description.find("“All”") != std::string::npos, isHidden) << name;
  }
}

// A user's file wins among scenes that are named on the command line, but not in a shipped lesson.
TEST(SceneLibrary, AShippedLessonHasShippedScenesWhateverTheCurrentFolderHolds) {
  const QTemporaryDir folder;
  const QString before = QDir::currentPath();
  ASSERT_TRUE(QDir::setCurrent(folder.path()));
  std::ofstream(folder.filePath("region_1.json").toStdString()) << "{\"schema\": \"another\"}";
  EXPECT_THROW(readNamedScene("region_1.json", {}, {}), InputError);
  EXPECT_NO_THROW(readNamedScene("region_1.json", kShippedFolder, {}));
  EXPECT_NO_THROW(readNamedLesson("rubber_is_not_coulomb", readNamedScene));
  QDir::setCurrent(before);
}

TEST_F(MainWindowTest, EveryChapterIsASubmenuWithEverySceneExplained) {
  const auto* action = window_.findChild<QAction*>("scene:velocity_step");
  ASSERT_TRUE(action);
  const auto* chapter = qobject_cast<QMenu*>(action->associatedObjects().constFirst());
  ASSERT_TRUE(chapter);
  EXPECT_EQ(chapter->title(), "Motions");
  EXPECT_TRUE(chapter->toolTipsVisible());
  QStringList titles;
  for (const LibraryScene& entry : libraryScenes()) {
    const auto* item = window_.findChild<QAction*>("scene:" + entry.name);
    ASSERT_TRUE(item) << entry.name.toStdString();
    EXPECT_FALSE(item->toolTip().isEmpty()) << entry.name.toStdString();
    const QString title = QString::fromStdString(entry.scene.chapter);
    if (titles.isEmpty() || titles.last() != title) titles += title;
  }
  EXPECT_EQ(titles.first(), "The basics");
  EXPECT_EQ(titles.removeDuplicates(), 0);  // each chapter in one piece
  EXPECT_GE(titles.size(), 7);
}

TEST_F(MainWindowTest, AnOpenedSceneSaysWhatToLookFor) {
  EXPECT_FALSE(window_.description().isVisible());  // the small scene has nothing to say
  window_.findChild<QAction*>("scene:region_2")->trigger();
  EXPECT_TRUE(window_.description().isVisible());
  EXPECT_EQ(window_.description().text().toStdString(), session().scene().description);
  window_.document().open(smallScene());
  EXPECT_FALSE(window_.description().isVisible());
}

TEST_F(MainWindowTest, ADescriptionThatWasClosedStaysClosed) {
  window_.findChild<QAction*>("scene:region_2")->trigger();
  window_.description().hide();
  type("load.normal_force", "5 mN");
  window_.findChild<QAction*>("undo")->trigger();
  EXPECT_FALSE(window_.description().isVisible());
  window_.findChild<QAction*>("scene:region_2")->trigger();
  EXPECT_TRUE(window_.description().isVisible());
}

}  // namespace
}  // namespace asperity
