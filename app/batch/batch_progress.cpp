#include "app/batch/batch_progress.h"

#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kName = ".asperity_batch_progress";

// A number is kept as the integer of its bits, so that all of them come back, also those of NaN.

Json toBits(double number) {
  return std::bit_cast<std::uint64_t>(number);
}

double fromBits(const Json& bits) {
  return std::bit_cast<double>(bits.get<std::uint64_t>());
}

/// Returns the addresses of the numbers of a point, to write or to read them. The binding names all
/// members, so that it does not compile where one was added.
template <class Point>
auto numbersOf(Point& point) {
  auto& [velocity, mu, muStandardError, muLaw, contactFraction, rmsSlopeContact, indentation,
         normalizedMu, dimensionlessVelocity, dimensionlessForce, realizations, muLow, muHigh,
         muInterface, muRatioOfMeans, marginalShare, normalForce, nominalPressure, meanPressure,
         extrapolated, contactSpots, listsContacts, swept, forceOnPeriod, tangentialForce, power,
         contactPressure, notes] = point;
  const auto addresses = [](auto&... numbers) { return std::array{&numbers...}; };
  return addresses(velocity, mu, muStandardError, muLaw, contactFraction, rmsSlopeContact,
                   indentation, normalizedMu, dimensionlessVelocity, dimensionlessForce, muLow,
                   muHigh, muInterface, muRatioOfMeans, marginalShare, normalForce, nominalPressure,
                   meanPressure, extrapolated, contactSpots, swept, forceOnPeriod, tangentialForce,
                   power, contactPressure);
}

Json pointJson(const CurvePoint& point) {
  Json numbers = Json::array(), notes = Json::array();
  for (const double* number : numbersOf(point)) numbers.push_back(toBits(*number));
  for (const Note note : point.notes.list()) notes.push_back(static_cast<int>(note));
  return {{"numbers", numbers},
          {"realizations", point.realizations},
          {"lists_contacts", point.listsContacts},
          {"notes", notes}};
}

/// Throws where the JSON is not that of a point.
CurvePoint pointFrom(const Json& json) {
  CurvePoint point;
  for (std::size_t i = 0; double* number : numbersOf(point))
    *number = fromBits(json.at("numbers").at(i++));
  point.realizations = json.at("realizations");
  point.listsContacts = json.at("lists_contacts");
  for (const int note : json.at("notes")) point.notes.add(static_cast<Note>(note));
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
      for (const Json& point : json.at("curve")) entry.curve.push_back(pointFrom(point));
      if (!json.at("mean").is_null()) entry.result.mean = pointFrom(json.at("mean"));
      const Json& shown = json.at("line");
      entry.result.lineMu = fromBits(shown.at(0));
      entry.result.lineIndentation = fromBits(shown.at(1));
      entry.result.lineContactFraction = fromBits(shown.at(2));
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
  if (entry.result.mean) json["mean"] = pointJson(*entry.result.mean);
  json["line"] = {toBits(entry.result.lineMu), toBits(entry.result.lineIndentation),
                  toBits(entry.result.lineContactFraction)};
  Json& curve = json["curve"] = Json::array();
  for (const CurvePoint& point : entry.curve) curve.push_back(pointJson(point));
  std::ofstream(file_, std::ios::app) << jsonLine(json) + "\n";
}

void BatchProgress::remove() const {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace asperity
