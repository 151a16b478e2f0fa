// Letters of menu entries.
#include "ui/window/main/window_keys.h"

#include <gtest/gtest.h>

#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

TEST(Mnemonics, BeginningsOfWordsComeFirst) {
  EXPECT_EQ(withMnemonics({"Save", "Save as", "Söhne && Töchter"}),
            (QStringList{"&Save", "Save &as", "Söhne && &Töchter"}));
}

TEST(Mnemonics, EarlierEntriesGiveWayToThoseThatHaveNoOtherLetter) {
  EXPECT_EQ(withMnemonics({"ab", "a"}), (QStringList{"a&b", "&a"}));
  EXPECT_EQ(withMnemonics({"abc", "ab", "a"}), (QStringList{"ab&c", "a&b", "&a"}));
}

TEST(Mnemonics, OldMarksGoAndWhatHasNoLetterLeftHasNone) {
  EXPECT_EQ(withMnemonics({"O&pen", "✓", "o", "o"}), (QStringList{"O&pen", "✓", "&o", "o"}));
  EXPECT_EQ(withMnemonics(withMnemonics({"One", "Only"})), withMnemonics({"One", "Only"}));
}

}  // namespace
}  // namespace asperity
