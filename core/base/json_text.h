// Reads JSON that a user wrote, such as scenes and studies: texts, with refusal of errors that a
// parser would accept silently, and the members of objects, with errors that name their path:
// "space.load.normal_force.from". Also makes single values of JSON. Pure except for isFileOfSchema;
// any thread.
// Failure: InputError with the path and what is allowed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace asperity {

/// Returns whether the text can be JSON at all: an object, after a byte order mark and blanks.
bool beginsAsObject(std::string_view text);

/// Parses the text. Throws InputError with the position where the text is not JSON, where a key
/// occurs twice in one object or an object has more than 256 keys, and where the nesting is deeper
/// than `deepest`. wanted: the sentence that tells what is needed instead of a file of another
/// kind. The time grows linearly with the text.
nlohmann::ordered_json parseJson(std::string_view text, int deepest,
                                 std::string_view wanted = "JSON in UTF-8 is needed");

/// Returns the outermost object with its members up to this one, without reading what follows it;
/// all of them where this one is not there, and null where the text is no object. Throws as
/// parseJson.
nlohmann::ordered_json membersUpTo(std::string_view text, const std::string& name, int deepest);

/// Returns whether a regular file of at most `limit` bytes is JSON whose schema begins like this;
/// false where it cannot be read.
bool isFileOfSchema(const std::filesystem::path& file, std::size_t limit,
                    std::string_view beginning);

/// Returns the value of a text that this program wrote itself. Throws the parser's error.
nlohmann::ordered_json jsonValue(std::string_view text);

/// Returns the value of the text; a discarded one where the text is not JSON.
nlohmann::ordered_json jsonOrDiscarded(std::string_view text);

/// Returns JSON in one line without its end. Bytes that are no UTF-8 are replaced, here and below.
std::string jsonLine(const nlohmann::ordered_json& value);

/// Returns the text of a JSON file, or of an answer of a command: each value in a line of its own.
std::string jsonFile(const nlohmann::ordered_json& value);

/// Throws InputError with the path.
[[noreturn]] void refuseMember(const std::string& path, const Message& why);

/// Throws InputError where the value is no object, or has a member that is not known.
void checkMembers(const nlohmann::ordered_json& object, const std::string& where,
                  std::initializer_list<std::string_view> known);

/// Returns a number. where: the path of the object, here and below. Throws InputError where the
/// member is missing or no number.
double numberMember(const nlohmann::ordered_json& object, const std::string& where,
                    const char* member);
/// Returns a number, or nothing where the member is missing.
std::optional<double> optionalNumberMember(const nlohmann::ordered_json& object,
                                           const std::string& where, const char* member);
/// Returns a whole number from `least` to `most`; the member must exist.
std::int64_t integerMember(const nlohmann::ordered_json& object, const char* member,
                           std::int64_t least, std::int64_t most, const std::string& where = "");
/// Returns a text, or `otherwise` where the member is missing.
std::string textMember(const nlohmann::ordered_json& object, const char* member,
                       const std::string& otherwise = "", const std::string& where = "");

/// Returns a value in the form that --set takes: a text as it is, anything else as JSON.
std::string assignedText(const nlohmann::ordered_json& value);

/// Returns a number, or null where it is not finite, for which JSON has no number.
nlohmann::ordered_json numberOrNull(double value);

}  // namespace asperity
