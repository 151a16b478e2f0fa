#include "core/base/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// The maximum number of keys in one object, more than any of the program's files has. Each key is
/// compared with all earlier ones.
constexpr std::size_t kMaxKeys = 256;

/// Returns the parser's message without its own name in front, with the place of the error as
/// values, and with the middle of a long quotation cut. parsed: the text up to that place.
Message parserMessage(const std::exception& error, std::string_view parsed) {
  constexpr std::size_t kMax = 300, kKept = 120;
  std::string text = error.what();
  const std::size_t bracket = text.find("] ");
  if (bracket != std::string::npos) text.erase(0, bracket + 2);
  // "parse error at line 1, column 5: syntax error while ..."
  const auto numberAfter = [&text](std::string_view words) {
    std::size_t number = 0;
    const std::size_t at = text.find(words);
    if (at != std::string::npos)
      std::from_chars(text.data() + at + words.size(), text.data() + text.size(), number);
    return number;
  };
  std::size_t line = static_cast<std::size_t>(std::ranges::count(parsed, '\n')) + 1;
  std::size_t column = parsed.size() - (parsed.rfind('\n') + 1);  // npos + 1 is 0
  if (text.starts_with("parse error at line ")) {
    line = numberAfter(" line ");
    column = numberAfter(", column ");
    text.erase(0, text.find(": ") + 2);
  }
  if (text.size() > kMax) {
    std::size_t from = kKept, to = text.size() - kKept;
    while (!beginsCharacter(text[from])) --from;
    while (!beginsCharacter(text[to])) ++to;
    text.replace(from, to - from, " ... ");
  }
  return message("is not valid JSON: line {}, column {}: {}", line, column, text);
}

/// Makes values from the parser's events. (With the library's own callback, the time would grow
/// with the square of a list's length.) It also refuses what the library accepts silently: a key
/// that occurs twice in one object (the library keeps the last), a number that is too small for a
/// double (the library reads 0), too deep nesting, and objects with very many keys.
class Reader : public nlohmann::json_sax<Json> {
 public:
  /// `wanted`: a member of the outermost object after which the parser stops; null: everything is
  /// read.
  Reader(std::string_view text, int deepest, const std::string* wanted)
      : text_(text), deepest_(deepest), wanted_(wanted) {}

  bool null() override { return take(nullptr); }
  bool boolean(bool value) override { return take(value); }
  bool number_integer(std::int64_t value) override { return take(value); }
  bool number_unsigned(std::uint64_t value) override { return take(value); }
  bool number_float(double value, const std::string& digits) override {
    const std::string_view mantissa =
        std::string_view(digits).substr(0, digits.find_first_of("eE"));
    const bool isZero = mantissa.find_first_of("123456789") == std::string_view::npos;
    if (value == 0 && !isZero)
      throw InputError("", path(), message("{} is too close to 0 for a number", shortened(digits)));
    return take(value);
  }
  bool string(std::string& value) override { return take(std::move(value)); }
  bool binary(Json::binary_t& value) override { return take(std::move(value)); }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    checkDepth();
    Level& level = levels_.back();
    level.key = name;
    if (level.value->contains(name))
      throw InputError("", path(), "occurs twice in the same object");
    if (level.value->size() == kMaxKeys)
      throw InputError("", path(), message("an object has more than {} keys", kMaxKeys));
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    throw InputError("", "", parserMessage(error, text_.substr(0, position)));
  }

  /// Returns everything that was read; a wanted member is the last one in it.
  Json& root() { return root_; }

 private:
  /// An object or a list that is not closed yet.
  struct Level {
    Json* value;
    std::string key;  // present key of an object
  };

  void checkDepth() const {
    if (static_cast<int>(levels_.size()) > deepest_)
      throw InputError("", path(), "is nested too deeply");
  }

  Json& put(Json value) {
    checkDepth();
    if (levels_.empty()) return root_ = std::move(value);
    const Level& level = levels_.back();
    if (level.value->is_object()) return (*level.value)[level.key] = std::move(value);
    level.value->push_back(std::move(value));
    return level.value->back();
  }

  /// Returns whether the parser continues: not after the wanted member.
  bool goesOn() const {
    return !wanted_ || levels_.size() != 1 || !root_.is_object() || levels_[0].key != *wanted_;
  }

  bool take(Json value) {
    put(std::move(value));
    return goesOn();
  }
  bool open(Json value) {
    levels_.push_back({&put(std::move(value)), {}});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return goesOn();
  }

  std::string path() const {
    std::string path;
    for (const Level& level : levels_)
      if (level.value->is_object()) appendItem(path, shortened(level.key), ".");
    return path;
  }

  std::string_view text_;
  int deepest_;
  const std::string* wanted_;
  Json root_;
  std::vector<Level> levels_;
};

std::string_view withoutBlanks(std::string_view text) {
  text = withoutByteOrderMark(text);
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

std::string memberPath(const std::string& where, const std::string& member) {
  return where.empty() ? member : where + "." + member;
}

[[noreturn]] void refuseKind(std::string_view kind, std::string_view wanted) {
  throw InputError("", "", message("is {}; {}", Message(kind), Message(wanted)));
}

}  // namespace

bool beginsAsObject(std::string_view text) {
  return withoutBlanks(text).starts_with('{');
}

nlohmann::ordered_json parseJson(std::string_view text, int deepest, std::string_view wanted) {
  if (const std::string_view kind = detectNonText(text); !kind.empty()) refuseKind(kind, wanted);
  const std::string_view beginning = withoutBlanks(text).substr(0, 1);
  if (beginning.empty()) refuseKind("an empty file", wanted);
  if (beginning != "{" && beginning != "[" && !Json::accept(text))
    refuseKind("text that is not JSON", wanted);
  Reader reader(text, deepest, nullptr);
  Json::sax_parse(text, &reader);
  return std::move(reader.root());
}

nlohmann::ordered_json membersUpTo(std::string_view text, const std::string& name, int deepest) {
  Reader reader(text, deepest, &name);
  Json::sax_parse(text, &reader);
  return reader.root().is_object() ? std::move(reader.root()) : Json();
}

bool isFileOfSchema(const std::filesystem::path& file, std::size_t limit,
                    std::string_view beginning) {
  constexpr int kDeepest = 16;  // of members in front of the schema
  try {
    const Json members = membersUpTo(readRegularFile(file, limit), "schema", kDeepest);
    return textMember(members, "schema").starts_with(beginning);
  } catch (const InputError&) {
    return false;
  }
}

Json jsonValue(std::string_view text) {
  return Json::parse(text);
}

Json jsonOrDiscarded(std::string_view text) {
  return Json::parse(text, nullptr, false);
}

std::string jsonLine(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string jsonFile(const Json& value) {
  return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void refuseMember(const std::string& path, const Message& why) {
  throw InputError("", path, why);
}

void checkMembers(const Json& object, const std::string& where,
                  std::initializer_list<std::string_view> list) {
  const std::span<const std::string_view> known(list.begin(), list.size());
  if (!object.is_object()) refuseMember(where, "needs an object");
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string_view nearest = nearestWord(key, known);
    refuseMember(memberPath(where, shortened(key)),
                 nearest.empty() ? message("unknown key; known are {}", namesWithCommas(known))
                                 : message("unknown key; the nearest known one is {}", nearest));
  }
}

double numberMember(const Json& object, const std::string& where, const char* member) {
  const auto found = object.find(member);
  if (found == object.end())
    refuseMember(memberPath(where, member), "is missing; it needs a number");
  if (!found->is_number()) refuseMember(memberPath(where, member), "needs a number");
  return found->get<double>();
}

std::optional<double> optionalNumberMember(const Json& object, const std::string& where,
                                           const char* member) {
  return object.contains(member) ? std::optional(numberMember(object, where, member))
                                 : std::nullopt;
}

namespace {

/// Returns the whole number of a JSON value; nothing where it has none that fits. An integer is
/// read as it stands, because a double rounds those above 2^53.
std::optional<std::int64_t> wholeNumber(const Json& json) {
  constexpr double kExact = 9007199254740992;  // 2^53
  if (json.is_number_unsigned() &&
      json.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<std::int64_t>::max()})
    return {};
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (!json.is_number()) return {};
  const double number = json.get<double>();
  if (number != std::floor(number) || std::abs(number) >= kExact) return {};
  return static_cast<std::int64_t>(number);
}

}  // namespace

std::int64_t integerMember(const Json& object, const char* member, std::int64_t least,
                           std::int64_t most, const std::string& where) {
  const std::optional<std::int64_t> number = wholeNumber(object.at(member));
  if (!number || *number < least || *number > most)
    refuseMember(memberPath(where, member),
                 message("{} is not a whole number from {} to {}",
                         shortened(jsonLine(object.at(member))), least, most));
  return *number;
}

std::string textMember(const Json& object, const char* member, const std::string& otherwise,
                       const std::string& where) {
  const auto found = object.find(member);
  if (found == object.end()) return otherwise;
  if (!found->is_string()) refuseMember(memberPath(where, member), "must be a text");
  return found->get<std::string>();
}

std::string assignedText(const Json& value) {
  return value.is_string() ? value.get<std::string>() : jsonLine(value);
}

nlohmann::ordered_json numberOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace asperity
