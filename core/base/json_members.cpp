#include "core/base/json_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/input_error.h"
#include "core/base/text.h"

namespace asperity {

using Json = nlohmann::ordered_json;

void refuseMember(const std::string& key, const Message& why) {
  throw InputError("", key, why);
}

void checkMembers(const Json& object, const std::string& where,
                  std::initializer_list<std::string_view> list) {
  const std::span<const std::string_view> known(list.begin(), list.size());
  if (!object.is_object()) refuseMember(where, "needs an object");
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string path = where.empty() ? shortened(key) : where + "." + shortened(key);
    const std::string_view nearest = nearestWord(key, known);
    refuseMember(
        path, nearest.empty()
                  ? message("unknown key; known are {}", fmt::format("{}", fmt::join(known, ", ")))
                  : message("unknown key; the nearest known one is {}", nearest));
  }
}

double numberMember(const Json& object, const std::string& where, const char* member) {
  const auto found = object.find(member);
  if (found == object.end()) refuseMember(where + "." + member, "is missing; it needs a number");
  if (!found->is_number()) refuseMember(where + "." + member, "needs a number");
  return found->get<double>();
}

std::optional<double> optionalNumberMember(const Json& object, const std::string& where,
                                           const char* member) {
  return object.contains(member) ? std::optional(numberMember(object, where, member))
                                 : std::nullopt;
}

std::int64_t integerMember(const Json& object, const char* member, std::int64_t least,
                           std::int64_t most, const std::string& where) {
  const std::string path = where.empty() ? member : where + "." + member;
  const double number = object.at(member).is_number() ? object.at(member).get<double>() : 0.5;
  if (number != std::floor(number) || number < static_cast<double>(least) ||
      number > static_cast<double>(most))
    refuseMember(path, message("{} is not a whole number from {} to {}",
                               shortened(object.at(member).dump()), least, most));
  return static_cast<std::int64_t>(number);
}

std::string textMember(const Json& object, const char* member, const std::string& otherwise,
                       const std::string& where) {
  const auto found = object.find(member);
  if (found == object.end()) return otherwise;
  if (!found->is_string())
    refuseMember(where.empty() ? member : where + "." + member, "needs a text");
  return found->get<std::string>();
}

}  // namespace asperity
