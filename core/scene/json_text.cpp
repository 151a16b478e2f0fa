#include "core/scene/json_text.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/scene/file_kind.h"
#include "core/scene/input_error.h"
#include "core/scene/known_words.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// Refuses what the parser would take in silence: a key that stands twice in one object (it keeps
/// the last), and nesting that no file of ours has.
class Watch {
 public:
  explicit Watch(int deepest) : deepest_(deepest) {}

  bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > deepest_) throw InputError("", path(), "is nested too deeply");
    if (event == Json::parse_event_t::object_start) objects_.emplace_back();
    if (event == Json::parse_event_t::object_end) objects_.pop_back();
    if (event == Json::parse_event_t::key) takeKey(parsed.get<std::string>());
    return true;
  }

 private:
  struct Object {
    std::set<std::string> keys;
    std::string last;
  };

  void takeKey(const std::string& key) {
    objects_.back().last = shortened(key);
    if (!objects_.back().keys.insert(key).second)
      throw InputError("", path(), "stands twice in the same object");
  }
  std::string path() const {
    std::string path;
    for (const Object& object : objects_) path += (path.empty() ? "" : ".") + object.last;
    return path;
  }

  int deepest_;
  std::vector<Object> objects_;
};

/// The parser's message without its own name in front, and without the middle of what it quotes
/// where that is long.
std::string parserMessage(const std::exception& error) {
  constexpr std::size_t kMost = 300, kKept = 120;
  std::string text = error.what();
  const std::size_t bracket = text.find("] ");
  if (bracket != std::string::npos) text.erase(0, bracket + 2);
  const auto isInside = [&text](std::size_t i) { return (text[i] & 0xC0) == 0x80; };  // of a letter
  if (text.size() > kMost) {
    std::size_t from = kKept, to = text.size() - kKept;
    while (isInside(from)) --from;
    while (isInside(to)) ++to;
    text.replace(from, to - from, " ... ");
  }
  return "is not valid JSON: " + text;
}

std::string_view withoutBlanks(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

[[noreturn]] void refuseKind(std::string_view kind, std::string_view wanted) {
  throw InputError("", "", "is " + std::string(kind) + "; " + std::string(wanted));
}

}  // namespace

nlohmann::ordered_json parseJson(std::string_view text, int deepest, std::string_view wanted) {
  if (const std::string_view kind = foreignKindOf(text); !kind.empty()) refuseKind(kind, wanted);
  const std::string_view beginning = withoutBlanks(text).substr(0, 1);
  if (beginning.empty()) refuseKind("an empty file", wanted);
  try {
    return Json::parse(text, Watch(deepest));
  } catch (const nlohmann::json::exception& error) {
    if (beginning != "{" && beginning != "[") refuseKind("text that is not JSON", wanted);
    throw InputError("", "", parserMessage(error));
  }
}

}  // namespace asperity
