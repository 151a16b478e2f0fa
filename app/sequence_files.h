// The files of a sequence of pictures: numbered so that ffmpeg (frame_%04d.png) and LaTeX's
// animate take them, each saying which one it is, so that an interrupted sequence can go on.
// Immutable once made; any thread.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace asperity {

class SequenceFiles {
 public:
  /// `origin`: the provenance of all of them. Makes the folder. Throws InputError.
  SequenceFiles(const std::string& folder, std::int64_t count, nlohmann::ordered_json origin);

  const std::vector<std::string>& files() const { return files_; }
  const std::string& file(std::int64_t index) const {
    return files_[static_cast<std::size_t>(index)];
  }

  /// What file `index` says of itself.
  std::string metadata(std::int64_t index) const;

  /// Those that are not there yet. Throws InputError where one is there that says something else.
  std::vector<std::int64_t> missing() const;

  /// Removes frames in the folder that a sequence of this program left there and that are not of
  /// this one; returns how many. A file that does not say that it is such a frame stays.
  std::int64_t removeLeftOver() const;

 private:
  std::string folder_;
  std::vector<std::string> files_;
  nlohmann::ordered_json origin_;
};

}  // namespace asperity
