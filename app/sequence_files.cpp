#include "app/sequence_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/output.h"
#include "core/scene/atomic_file.h"
#include "core/scene/input_error.h"
#include "core/scene/provenance.h"
#include "ui/picture/png_file.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHead = std::size_t{1} << 21;  // bytes before which the texts stand

std::string headOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(kHead, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace

SequenceFiles::SequenceFiles(const std::string& folder, std::int64_t count,
                             nlohmann::ordered_json origin)
    : origin_(std::move(origin)) {
  makeFolder(folder);
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(count).size());
  for (std::int64_t i = 1; i <= count; ++i)
    files_.push_back((fs::path(folder) / fmt::format("frame_{:0{}}.png", i, digits)).string());
  checkWritable(files_.front());
}

std::string SequenceFiles::metadata(std::int64_t index) const {
  nlohmann::ordered_json own = origin_;
  own["picture"]["frame"] = index + 1;
  return provenanceLine(own);
}

std::vector<std::int64_t> SequenceFiles::missing() const {
  std::vector<std::int64_t> missing;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const auto index = static_cast<std::int64_t>(i);
    if (!fs::exists(files_[i]))
      missing.push_back(index);
    else if (pngMetadata(headOf(files_[i])) != metadata(index))
      throw InputError(files_[i], "",
                       "was made by another scene, version or options; without --resume it is "
                       "made anew");
  }
  return missing;
}

}  // namespace asperity
