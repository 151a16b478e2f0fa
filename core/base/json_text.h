// Reads JSON that a user wrote, such as scenes and batches, and refuses errors that a parser would
// accept silently. Also writes numbers of JSON. Pure; any thread.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

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

/// Returns the value of this member of the outermost object, without reading what follows it; null
/// where there is none. Throws as parseJson.
nlohmann::ordered_json memberOf(std::string_view text, const std::string& name, int deepest);

/// Returns a value in the form that --set takes: a text as it is, anything else as JSON.
std::string assignedText(const nlohmann::ordered_json& value);

/// Returns a number, or null where it is not finite, for which JSON has no number.
nlohmann::ordered_json numberOrNull(double value);

}  // namespace asperity
