// What the command line says of words that it cannot take: one sentence that names the option, what
// is wrong with it and what is allowed. Main thread.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string_view>

#include "core/scene/input_error.h"

namespace asperity {

/// Checks of a number's text: a finite one, or a whole one, within the limits, which
/// are said with the unit.
CLI::Validator within(double least, double most, std::string_view unit = {});
CLI::Validator wholeWithin(std::int64_t least, std::int64_t most);

/// No option or file of the app and its verbs may be empty text, and a flag takes no value: both
/// would be taken in silence. Once, when all options are there.
void refuseEmptyWords(CLI::App& app);

/// What was wrong, in our words. app: the one that parsed.
InputError errorOf(const CLI::App& app, const CLI::ParseError& error);

/// Throws InputError where options of the app itself stand before a verb, which does not see them.
void refuseWordsBeforeVerb(const CLI::App& app);

}  // namespace asperity
