// The results of a study in one SQLite file: one row for each chunk of simulations, whose numbers
// are one binary column. A chunk is written in one transaction, so finished chunks stay however a
// process ends. The store contains the whole study and refuses to continue with another one.
//
// Processes: any number of processes of one machine may share a store. A process that works on a
// chunk locks a byte of the file STORE-claims; the lock ends with the process. A shard (part i of
// n) has a store of its own for one process, which needs no memory shared between processes and so
// works on network file systems.
// Threading: one thread at a time. Failure: InputError for a file that is no such store, is
// damaged, is newer, or belongs to another study; std::runtime_error in one sentence where writing
// fails.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/study_database.h"
#include "core/study/study_file.h"

namespace asperity {

/// Part `number` of `count`, counted from 1, of a study, computed by runStudy(): every count-th
/// chunk of it. 1 of 1 is all of the study.
struct Shard {
  std::int64_t number = 1, count = 1;

  bool isWhole() const { return count == 1; }
  bool has(std::int64_t chunk) const { return chunk % count == number - 1; }
  /// Returns the number of its chunks.
  std::int64_t chunks(const ParameterStudy& study) const;
  /// Returns the number of its simulations.
  std::int64_t simulations(const ParameterStudy& study) const;
  bool operator==(const Shard&) const = default;
};

/// Reads "3/8". Throws InputError that names --shard.
Shard parseShard(const std::string& text);

struct StudyFailure {
  std::int64_t simulation = 0;  // its number in the study
  std::string message;
};

/// The results of consecutive simulations.
struct StudyChunk {
  std::int64_t number = 0, first = 0, count = 0;
  /// The numbers [number][simulation]. NaN where a number does not apply or the simulation failed.
  std::vector<double> values;
  std::vector<StudyFailure> failures;
  double seconds = 0;  // spent on it; not part of the result

  double at(std::size_t row, std::int64_t simulation) const {
    return values[row * static_cast<std::size_t>(count) + static_cast<std::size_t>(simulation)];
  }
};

/// Returns whether a file that begins with these 72 bytes is the store of a study.
bool isStudyStore(std::string_view beginning);

class StudyStore {
 public:
  /// Opens the store of a study, or makes it where there is none. Throws InputError with the
  /// differences where the store belongs to another study or another shard.
  StudyStore(const std::filesystem::path& file, const ParameterStudy& study, const Shard& shard);
  /// Opens a store for reading, with the study in it.
  explicit StudyStore(const std::filesystem::path& file);
  ~StudyStore();
  StudyStore(StudyStore&&) noexcept;
  StudyStore& operator=(StudyStore&&) = delete;

  const ParameterStudy& study() const { return *study_; }
  const Shard& shard() const { return shard_; }
  const std::filesystem::path& file() const { return database_.file(); }

  /// Returns the number of chunks of the complete store.
  std::int64_t chunksPlanned() const;
  std::int64_t chunksDone() const;
  std::int64_t simulationsDone() const;
  /// Returns the SHA-256 of the numbers of the stored chunks, which identifies the simulations of
  /// an unfinished store.
  std::string chunksDigest() const;
  double secondsSpent() const;  // of all chunks together
  bool isWhole() const { return chunksDone() == chunksPlanned(); }
  bool has(std::int64_t chunk) const;
  bool hasFailures() const;
  /// Returns the first `most` missing chunks, in ascending order.
  std::vector<std::int64_t> missing(std::size_t most) const;

  /// Claims a missing chunk on which no process works, from `from` on; returns -1 where there is
  /// none. The claim holds until the chunk is added or the process ends.
  std::int64_t claim(std::int64_t from);
  /// Adds a chunk in one transaction; a stored chunk is not replaced.
  void add(const StudyChunk& chunk);
  /// Adds chunks in one transaction.
  void add(const std::vector<StudyChunk>& chunks);
  /// Adds chunks of another store. Throws InputError that names that store where a chunk is stored
  /// here with other results.
  void addEqual(const std::vector<StudyChunk>& chunks, const std::filesystem::path& from);
  /// Converts a complete store to the form that can be read everywhere.
  void finish();

  /// Calls `use` with all chunks in ascending order, one at a time in memory, and checks each. It
  /// ends where `use` returns false.
  void eachChunk(const std::function<bool(const StudyChunk&)>& use) const;
  /// Reads the whole file and throws InputError where one of its pages is damaged.
  void check() const;

 private:
  void create(const ParameterStudy& study, const Shard& shard);
  bool hasTables() const;
  void readHeader();
  std::string metaText(const char* key) const;
  void insert(const StudyChunk& chunk);

  StudyDatabase database_;
  std::shared_ptr<const ParameterStudy> study_;
  Shard shard_;
  int claims_ = -1;  // descriptor of STORE-claims
};

}  // namespace asperity
