#include "app/pictures/sequence_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/output.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/scene/provenance.h"
#include "ui/draw/picture_file.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

// the texts of a picture are within these first bytes
constexpr std::size_t kHead = std::size_t{1} << 21;

std::string readHead(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(kHead, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

/// Returns whether the name is like "frame_0061.png", with four or more digits.
bool isFrameName(const std::string& name) {
  constexpr std::string_view kFront = "frame_", kEnd = ".png";
  if (!name.starts_with(kFront) || !name.ends_with(kEnd)) return false;
  const std::string_view digits =
      std::string_view(name).substr(kFront.size(), name.size() - kFront.size() - kEnd.size());
  return digits.size() >= 4 && digits.find_first_not_of("0123456789") == digits.npos;
}

/// Returns whether this program wrote the file as part of a sequence.
bool isOwnFrame(const std::string& file) {
  constexpr int kDeepest = 12;  // largest nesting of a scene in a provenance, with a margin
  try {
    const auto made = parseJson(pngMetadata(readHead(file)), kDeepest);
    const auto verb = made.find("verb"), picture = made.find("picture");
    return verb != made.end() && *verb == "render" && picture != made.end() &&
           picture->contains("frame");
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

SequenceFiles::SequenceFiles(const std::string& folder, std::int64_t count,
                             nlohmann::ordered_json origin)
    : folder_(folder), origin_(std::move(origin)) {
  makeFolder(folder);
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(count).size());
  for (std::int64_t i = 1; i <= count; ++i)
    files_.push_back(fileIn(folder, fmt::format("frame_{:0{}}.png", i, digits)));
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
    else if (pngMetadata(readHead(files_[i])) != metadata(index))
      throw InputError(files_[i], "",
                       "was made by another scene, version or options; without --resume it is "
                       "made anew");
  }
  return missing;
}

std::int64_t SequenceFiles::removeLeftOver() const {
  std::int64_t removed = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    const std::string file = fileIn(folder_, entry.path().filename().string());
    if (!isFrameName(entry.path().filename().string()) || !entry.is_regular_file() ||
        std::ranges::binary_search(files_, file) || !isOwnFrame(file))
      continue;
    std::error_code ignored;  // a file that cannot be removed stays
    removed += fs::remove(file, ignored) ? 1 : 0;
  }
  return removed;
}

}  // namespace asperity
