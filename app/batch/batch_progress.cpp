#include "app/batch/batch_progress.h"

#include <array>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "core/base/file_digest.h"
#include "core/base/json_text.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kName = ".asperity_batch_progress";

// A point is kept as its bytes: every bit of it comes back, and a key that holds the version of the
// program ensures that it is the same program that reads them.
static_assert(std::is_trivially_copyable_v<CurvePoint>);

std::string toHex(const CurvePoint& point) {
  return hexadecimal({reinterpret_cast<const std::uint8_t*>(&point), sizeof(CurvePoint)});
}

/// Throws std::runtime_error where the text is not that of a point.
CurvePoint pointFromHex(const std::string& text) {
  std::array<unsigned char, sizeof(CurvePoint)> bytes{};
  if (text.size() != 2 * bytes.size()) throw std::runtime_error("not a point");
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<unsigned char>(std::stoi(text.substr(2 * i, 2), nullptr, 16));
  CurvePoint point;
  std::memcpy(static_cast<void*>(&point), bytes.data(), bytes.size());
  return point;
}

}  // namespace

BatchProgress::BatchProgress(const std::filesystem::path& folder)
    : folder_(folder), file_(folder / kName) {
  std::ifstream lines(file_);
  std::string line;
  try {
    while (std::getline(lines, line)) {
      const Json json = jsonValue(line);
      BatchProgressEntry entry;
      for (const Json& point : json.at("curve")) entry.curve.push_back(pointFromHex(point));
      if (!json.at("mean").is_null()) entry.result.mean = pointFromHex(json.at("mean"));
      const CurvePoint shown = pointFromHex(json.at("line"));
      entry.result.lineMu = shown.mu;
      entry.result.lineIndentation = shown.indentation;
      entry.result.lineContactFraction = shown.contactFraction;
      entry.result.files = json.at("files").get<std::vector<std::string>>();
      entries_[json.at("key").get<std::string>()] = std::move(entry);
    }
  } catch (const std::exception&) {
    // The line was being written when the run ended.
  }
}

const BatchProgressEntry* BatchProgress::find(const std::string& key) const {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return nullptr;
  std::error_code ignored;
  for (const std::string& file : found->second.result.files)
    if (!std::filesystem::is_regular_file(folder_ / file, ignored)) return nullptr;
  return &found->second;
}

void BatchProgress::add(const std::string& key, const BatchProgressEntry& entry) {
  Json json = {{"key", key}, {"files", entry.result.files}, {"mean", nullptr}};
  if (entry.result.mean) json["mean"] = toHex(*entry.result.mean);
  CurvePoint shown{.mu = entry.result.lineMu,
                   .contactFraction = entry.result.lineContactFraction,
                   .indentation = entry.result.lineIndentation};
  json["line"] = toHex(shown);
  Json& curve = json["curve"] = Json::array();
  for (const CurvePoint& point : entry.curve) curve.push_back(toHex(point));
  std::ofstream(file_, std::ios::app) << jsonLine(json) + "\n";
}

void BatchProgress::remove() const {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace asperity
