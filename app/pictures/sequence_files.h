// The files of a sequence of pictures. They are numbered so that ffmpeg (frame_%04d.png) and
// LaTeX's animate take them. Each contains its number, so that an interrupted sequence can be
// continued. Immutable once made; any thread.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace asperity {

class SequenceFiles {
 public:
  /// Makes the folder. `origin`: the provenance of all pictures. Throws InputError.
  SequenceFiles(const std::string& folder, std::int64_t count, nlohmann::ordered_json origin);

  const std::vector<std::string>& files() const { return files_; }
  const std::string& file(std::int64_t index) const {
    return files_[static_cast<std::size_t>(index)];
  }

  /// Returns the metadata of file `index`.
  std::string metadata(std::int64_t index) const;

  /// Returns the pictures that are not there yet. Throws InputError where a file has other
  /// metadata.
  std::vector<std::int64_t> missing() const;

  /// Removes frames that another sequence of this program left in the folder; returns their number.
  /// A file whose metadata does not name it as such a frame stays.
  std::int64_t removeLeftOver() const;

 private:
  std::string folder_;
  std::vector<std::string> files_;
  nlohmann::ordered_json origin_;
};

}  // namespace asperity
