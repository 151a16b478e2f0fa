// What a person is told about a surface that was read: how, what was assumed, what is unusual.
#include "core/measured/reading_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace asperity::written {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A profile with a point each 2 um, as its reader hands it on; both units come from the file.
SurfaceDraft profile(const std::vector<double>& heights, const std::string& unit, double metres) {
  SurfaceDraft draft;
  draft.grid.columns = static_cast<std::int64_t>(heights.size());
  draft.grid.rows = 1;
  draft.grid.columnSpacing = 2e-6;
  for (const double height : heights) draft.grid.height.push_back(height * metres);
  draft.facts.format = "profile";
  draft.facts.positionUnit = draft.facts.heightUnit = {unit, metres, UnitSource::File};
  return draft;
}

/// Returns all notes in one text, one line each.
std::string notesOf(SurfaceDraft draft) {
  addReadingNotes(draft);
  std::string text;
  for (const Message& note : draft.facts.notes) text += note.english() + "\n";
  return text;
}

TEST(ReadingNotes, BeginWithTheSizeAndEndWithTheGaps) {
  SurfaceDraft draft = profile({1, 2, 3}, "um", 1e-6);
  draft.facts.notes = {"a note of the reader"};
  draft.facts.gaps = 2;
  EXPECT_EQ(notesOf(draft),
            "Read as a profile as text: 3 points, 2 \u00B5m apart.\n"
            "a note of the reader\n"
            "Positions are in \u00B5m, as the file states.\n"
            "Heights are in \u00B5m, as the file states.\n"
            "2 points have no height.\n");
}

TEST(ReadingNotes, NameAFlatSurface) {
  const double none = std::nan("");
  const std::string flat = "All heights are the same: the surface is flat.";
  EXPECT_THAT(notesOf(profile({none, 2, 2, 2}, "um", 1e-6)), HasSubstr(flat));
  EXPECT_THAT(notesOf(profile({2, 2, 2.1}, "um", 1e-6)), testing::Not(HasSubstr(flat)));
}

/// What the file does not state was chosen or assumed, and each is said as such.
TEST(ReadingNotes, TellTheSourcesOfUnitsAndDistancesApart) {
  SurfaceDraft draft = profile({1, 2, 3}, "um", 1e-6);
  draft.facts.positionUnit.source = draft.facts.heightUnit.source = UnitSource::Assumed;
  EXPECT_THAT(notesOf(draft), AllOf(HasSubstr("positions: they are taken as metres"),
                                    HasSubstr("heights: they are taken as metres")));
  draft.facts.positionUnit.source = draft.facts.heightUnit.source = UnitSource::Choice;
  EXPECT_THAT(notesOf(draft), AllOf(HasSubstr("as surface.position_unit says"),
                                    HasSubstr("as surface.height_unit says")));
  draft.hasPositions = false;
  EXPECT_THAT(notesOf(draft), HasSubstr("2 \u00B5m is assumed"));
  draft.hasPositions = draft.isSpacingChosen = true;
  EXPECT_THAT(notesOf(draft), AllOf(HasSubstr("2 \u00B5m apart, as surface.point_spacing says"),
                                    Not(HasSubstr("is assumed"))));
}

TEST(ReadingNotes, LargeSizesMayHaveAWrongUnit) {
  SurfaceDraft large = profile({0, 1000, -1000}, "m", 1);
  large.grid.columnSpacing = 10;
  EXPECT_THAT(notesOf(large),
              AllOf(HasSubstr("The surface is 30 m long: if the file states a wrong unit"),
                    HasSubstr("The heights span 2e+03 m: if the file states a wrong unit")));
  // Whoever chose a unit knows the size.
  large.facts.positionUnit.source = large.facts.heightUnit.source = UnitSource::Choice;
  EXPECT_THAT(notesOf(large), Not(HasSubstr("wrong unit")));
  SurfaceDraft usual = profile({0, 0.01, 0.02, 0.05}, "m", 1);
  usual.grid.columnSpacing = 1;
  EXPECT_THAT(notesOf(usual), Not(HasSubstr("wrong unit")));
}

/// Numbers that stand for missing points are far from all heights and alike.
TEST(ReadingNotes, NameVoidCodes) {
  const auto withCode = [](const std::string& code, int every) {
    std::vector<double> heights;
    for (int i = 0; i < 60; ++i)
      heights.push_back(i % every == 5 ? std::atof(code.c_str())
                                       : 3 * std::sin(0.7 * i) + 0.01 * i);
    return notesOf(profile(heights, "um", 1e-6));
  };
  for (const std::string code : {"-9999", "-32768", "9999.9999", "99999", "-123.5"})
    EXPECT_THAT(withCode(code, 20),
                HasSubstr("The height " + code + " (in \u00B5m) stands 3 times"));
  EXPECT_THAT(withCode("-999.9", 100), HasSubstr("The height -999.9 (in \u00B5m) is far"));
  // One deep scratch, or a plateau among the others.
  EXPECT_THAT(withCode("-123.5", 100), Not(HasSubstr("The height ")));
  EXPECT_THAT(withCode("-5", 4), Not(HasSubstr("The height ")));
}

/// The sign for micro of Shift-JIS arrives as two letters of Latin-1.
TEST(ReadingNotes, WriteUnitsAsPeopleDo) {
  EXPECT_THAT(notesOf(profile({1, 2, 3}, "\u0192\u00CAm", 1e-6)),
              HasSubstr("Heights are in \u00B5m, as the file states."));
  SurfaceDraft sdf = profile({1, 2, 3}, "m", 1);
  sdf.facts.format = "sdf";
  EXPECT_THAT(notesOf(sdf), StartsWith("Read as SDF: "));
}

}  // namespace
}  // namespace asperity::written
