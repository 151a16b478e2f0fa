// The notes on the validity of a result: one list for the column `notes` of tables, for `asperity
// explain`, for `asperity surface` and for the window. Constant; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace asperity {

/// The notes in the order in which they are shown.
enum class Note : std::uint8_t {
  SlopeAbove,               // rms slope of the line above kSmallSlope
  FewContacts,              // few contacts carry the load (region IV)
  ExtrapolatedMaterial,     // frequencies outside of what was measured of the elastomer
  ExtrapolatedTemperature,  // temperature outside of it
  StrainBeyondMeasured,     // larger strains than those the elastomer was measured at
  SeamJump,                 // the period of the line repeats with a step
  Spikes,                   // points of a measured surface that stand out of their neighbours
  CoarseHeights,            // heights of rows have steps that are too coarse for their line
  RoundForm,                // the profile is part of a circle, which no parabola removes
  FewIndependentRows,       // the error of a mean over rows of a topography is badly known
  FastEnoughToHeat,         // the power dissipated would change the temperature
  UnresolvedFriction,       // too few elements in contact for the tangential force
  FasterThanTested,         // velocity shown in the window above kFastestTested
};
inline constexpr std::size_t kNotes = static_cast<std::size_t>(Note::FasterThanTested) + 1;

/// The model assumes small slopes: above this rms slope its friction is an estimate.
inline constexpr double kSmallSlope = 0.3;

/// Velocity (m/s) above which rubber friction is not measured; elastic waves in rubber are mostly
/// slower. The model has no density and therefore no waves; tables of long curves, whose ends are
/// limits, have no note.
inline constexpr double kFastestTested = 1000;

/// Returns the word of a note in tables: "slope_above_0.3".
std::string_view noteWord(Note note);
/// Returns the note as one sentence without a full stop.
Message noteSentence(Note note);

/// A set of notes: a plain value.
class NoteSet {
 public:
  void add(Note note, bool holds = true) {
    if (holds) bits_ |= std::uint32_t{1} << static_cast<unsigned>(note);
  }
  void add(NoteSet others) { bits_ |= others.bits_; }
  bool has(Note note) const { return (bits_ >> static_cast<unsigned>(note) & 1) != 0; }
  bool empty() const { return bits_ == 0; }
  std::vector<Note> list() const;
  /// Returns their words, separated by blanks.
  std::string words() const;

  bool operator==(const NoteSet&) const = default;

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace asperity
