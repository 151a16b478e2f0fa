// The lines of a scene: reads its file once, plans its transforms once, then makes any realization.
// Threading: make() may be called by several threads at once.
// Failure: InputError (unreadable file, waves beyond the elements).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include "core/scene/notes.h"
#include "core/scene/scene.h"
#include "core/surface/line.h"
#include "core/surface/measured_lines.h"
#include "core/surface/profile_file.h"
#include "core/surface/spectrum.h"

namespace asperity {

/// Whether a line's slopes are wanted; without, slopeAfter is empty.
enum class Slopes { Wanted, NotWanted };

/// How large the lines of a scene are, without making one.
struct LineExtent {
  double length = 0;          // m
  std::int64_t elements = 0;  // per period
  std::int64_t rows = 0;      // of a profile's file; 0: no profile
  double rmsHeight = 0;       // m; of a profile about, and of other lines as the scene states it
  std::int64_t lines = 1;     // that the scene's means are over
};
LineExtent lineExtent(const Scene& scene);

/// The profile of a scene: the first `rows` rows of its file.
Profile readProfileStart(const Scene& scene, std::int64_t rows);

class LineSource {
 public:
  /// Lines with elements * oversampling nodes. profile: instead of that in the scene's file.
  LineSource(const Scene& scene, std::int64_t oversampling, const Profile* profile = nullptr);

  /// Realization 0, 1, ... ; the same line for the same scene and number, always.
  Line make(std::int64_t realization) const;

  /// The same into a line whose memory is used again. Straight segments need no slopes. Returns
  /// false where `stop` was requested, which is looked at before and after each transform; the line
  /// is then not whole.
  bool makeInto(Line& line, std::int64_t realization, Slopes slopes = Slopes::Wanted,
                const std::stop_token& stop = {}) const;

  /// Whether realizations differ at all: random lines, or several rows of a measured surface.
  bool isRandom() const { return isRandom_; }
  /// Lines that the scene's means are over: its realizations, every row where they are 0, or 1.
  std::int64_t lines() const { return lines_; }
  /// Whether rms height and rms slope differ from line to line.
  bool slopesDiffer() const {
    return isRandom_ && (summits_ || (measured_ && !hasRandomPhases(surface_)));
  }
  /// Of a measured surface; else null.
  const MeasuredLines* measured() const { return measured_.get(); }
  /// What the table of a spectrum was taken for, one sentence each; of other surfaces none.
  const std::vector<Message>& spectrumFacts() const { return spectrumFacts_; }
  /// The row of a measured surface that a realization is, counted from 0 among those used.
  std::int64_t rowOf(std::int64_t realization) const;

  const LineStatistics& statistics() const { return statistics_; }
  /// The modes of a realization; empty for lines given by a formula.
  FourierLine spectrum(std::int64_t realization) const;

  double length() const { return length_; }            // m
  std::int64_t elements() const { return elements_; }  // per period, without oversampling
  std::int64_t nodes() const { return static_cast<std::int64_t>(nodes_); }  // of every line

 private:
  void setAmplitudes(const Scene& scene);
  void setProfile(const Profile& profile);
  void setMeasured(const Scene& scene);
  void setSpectrum(const Scene& scene);
  Line makeShape() const;
  void spectrumInto(FourierLine& line, std::int64_t number) const;
  bool setFromSpectrum(const FourierLine& modes, Slopes slopes, Line& line,
                       const std::stop_token& stop) const;

  Surface surface_;
  double length_;
  std::int64_t elements_;
  std::size_t nodes_ = 0;
  bool isRandom_ = false;
  std::int64_t lines_ = 1;
  bool drawsRows_ = false;          // any number of realizations from the rows there are
  std::vector<double> amplitudes_;  // |c_k| of a line of random phases
  std::shared_ptr<const MeasuredLines> measured_;
  std::vector<Message> spectrumFacts_;
  Line only_;  // of a scene that is not random
  FourierLine profile_;
  LineStatistics statistics_;
  std::optional<FourierTransform> transform_;  // for lines that have a spectrum
  std::optional<FourierTransform> summits_;    // for those with summit correlation
};

/// The modes of the first line; of one that is given by a formula from its points.
FourierLine modesOf(const LineSource& source);

/// What to know of the lines of a source: the rms slope, and steps at the seam of measured rows.
NoteSet lineNotes(const LineSource& source);

}  // namespace asperity
