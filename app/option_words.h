// What the command line says of words that it cannot take: one sentence that names the option, what
// is wrong with it and what is allowed. Main thread.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string_view>

#include "core/base/input_error.h"

namespace asperity {

/// The option takes a finite number, or a whole one, within limits that its help shows, with the
/// unit.
void limit(CLI::Option* option, double least, double most, std::string_view unit = {});
void limitWhole(CLI::Option* option, std::int64_t least, std::int64_t most);

/// No option or file of the app and its verbs may be empty text, and a flag takes no value: both
/// would be taken in silence. Once, when all options are there.
void refuseEmptyWords(CLI::App& app);

/// What was wrong, in our words. app: the one that parsed.
InputError errorOf(const CLI::App& app, const CLI::ParseError& error);

/// Throws InputError where options of the app itself stand before a verb, which does not see them.
void refuseWordsBeforeVerb(const CLI::App& app);

}  // namespace asperity
