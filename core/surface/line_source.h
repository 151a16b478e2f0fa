// Makes the lines of a scene: it reads the scene's file once, plans its transforms once, and then
// makes any realization.
// Threading: make() may be called by several threads at once.
// Failure: InputError (unreadable file, more waves than the elements can represent).
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stop_token>
#include <string>

#include "core/scene/notes.h"
#include "core/scene/scene.h"
#include "core/surface/line.h"
#include "core/surface/measured_lines.h"
#include "core/surface/profile_file.h"
#include "core/surface/spectrum.h"

namespace asperity {

/// Whether a line's slopes are computed; otherwise slopeAfter is empty.
enum class Slopes { Computed, Omitted };

/// The size of the lines of a scene, known without making one.
struct LineExtent {
  double length = 0;          // m
  std::int64_t elements = 0;  // per period
  std::int64_t rows = 0;      // of a profile's file; 0: no profile
  double rmsHeight = 0;       // m; of a profile approximate, of other lines as in the scene
  std::int64_t lines = 1;     // number of lines of the scene's means
};
LineExtent lineExtent(const Scene& scene);

/// Returns pointsPerElement with the size of the line, which is read from the surface's file only
/// if the number depends on it.
std::int64_t linePoints(const Scene& scene);

/// Returns provenance() with that number. It stays null where the file cannot be read.
nlohmann::ordered_json lineProvenance(const std::string& verb, const Scene& scene);

/// Returns the first `rows` rows of the profile of a scene.
Profile readProfileStart(const Scene& scene, std::int64_t rows);

class LineSource {
 public:
  /// Makes lines with elements * oversampling nodes. profile: replaces that in the scene's file.
  LineSource(const Scene& scene, std::int64_t oversampling, const Profile* profile = nullptr);

  /// Returns realization 0, 1, ...; equal scenes and numbers always give the same line.
  Line make(std::int64_t realization) const;

  /// Makes the line in memory that is used again. Straight segments need no slopes. Returns false
  /// where `stop` was requested, which is checked before and after each transform; the line is then
  /// incomplete.
  bool makeInto(Line& line, std::int64_t realization, Slopes slopes = Slopes::Computed,
                const std::stop_token& stop = {}) const;

  /// Returns whether realizations differ: those of random lines, or of several rows of a measured
  /// surface.
  bool isRandom() const { return isRandom_; }
  /// Returns the number of lines of the scene's means: its realizations, every row where they are
  /// 0, or 1.
  std::int64_t lines() const { return lines_; }
  /// Throws InputError naming the option (or argument) unless the scene has this many different
  /// lines: any number of random ones, each row of a measured surface that the scene uses, or one.
  void requireLines(std::int64_t lines, const std::string& option) const;
  /// Does the same for the line of one realization, counted from 0.
  void requireRealization(std::int64_t realization, const std::string& option) const;
  /// Returns whether rms height and rms slope differ from line to line.
  bool slopesDiffer() const { return hasRows() || (isRandom_ && summits_); }
  /// Returns whether realizations are rows of a topography.
  bool hasRows() const { return measured_ && isRandom_ && !hasRandomPhases(surface_); }
  /// Returns the number of rows of a topography that can be lines; 0 for other lines.
  std::int64_t rows() const { return hasRows() ? measured_->rows() : 0; }
  /// Returns how many of these rows the scene uses.
  std::int64_t rowsToUse() const { return drawsRows_ ? rows() : std::min(lines_, rows()); }
  /// Returns how many different rows of a topography the first realizations are, in their order on
  /// the surface; 0 for independent lines. Neighbouring rows are nearly the same line.
  std::int64_t orderedRows() const { return drawsRows_ ? 0 : rowsToUse(); }
  /// Returns the lines of a measured surface; else null.
  const MeasuredLines* measured() const { return measured_.get(); }
  /// Returns how the table of a spectrum was understood, one sentence each; empty for other
  /// surfaces.
  const std::vector<Message>& spectrumFacts() const { return spectrumFacts_; }
  /// Returns the row of a measured surface that belongs to a realization, counted from 0 among
  /// those used.
  std::int64_t rowOf(std::int64_t realization) const;

  const LineStatistics& statistics() const { return statistics_; }
  /// Returns the modes of a realization; empty for lines given by a formula.
  FourierLine spectrum(std::int64_t realization) const;

  double length() const { return length_; }            // m
  std::int64_t elements() const { return elements_; }  // per period, without oversampling
  std::int64_t nodes() const { return static_cast<std::int64_t>(nodes_); }  // of every line

 private:
  void setAmplitudes(const Scene& scene);
  void setProfile(const Profile& profile);
  void setMeasured(const Scene& scene);
  void setSpectrum(const Scene& scene);
  FourierLine carried(FourierLine modes) const;
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
  bool drawsRows_ = false;          // realizations are rows drawn with replacement
  std::vector<double> amplitudes_;  // |c_k| of a line of random phases
  std::shared_ptr<const MeasuredLines> measured_;
  std::vector<Message> spectrumFacts_;
  Line only_;  // of a scene that is not random
  FourierLine profile_;
  LineStatistics statistics_;
  std::optional<FourierTransform> transform_;  // for lines that have a spectrum
  std::optional<FourierTransform> summits_;    // for those with summit correlation
};

/// Returns the modes of the first line; those of a line given by a formula follow from its nodes.
FourierLine modesOf(const LineSource& source);

/// Returns the notes on the lines of a source: on the rms slope, and on spikes and steps at the
/// seam of measured rows.
NoteSet lineNotes(const LineSource& source);

}  // namespace asperity
