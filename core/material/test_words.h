// What words above a table of measurements are about: the test, making and storing the sample, the
// shift, other things. Each list has words in English and German, some in other languages. Words
// are in lower case (wordsIn). Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Returns whether a word says that a temperature is one of making or storing the sample.
bool isOfMaking(const std::string& word);

/// Returns whether a word is "mixture", which is a sample or its making.
bool isMixture(const std::string& word);

/// Returns the words without "mixture" where it has a name after it, so that it is the sample:
/// "Mischung A12". In "mixture at 160 °C" and "Mix 160 °C" it is the making.
std::vector<std::string> withoutNamesOfMixtures(std::vector<std::string> words);

/// Returns whether words say that a temperature is none of the test. The storage modulus is no
/// storage, 5 min are minutes, and a rheometer may be that of the test.
bool areOfOther(const std::vector<std::string>& words);

/// Returns whether a word says that something was measured, or is about the curve itself.
bool isTestWord(const std::string& word);
bool areOfTest(const std::vector<std::string>& words);

/// Returns whether words state how long something took: "24 h", "168h", "10 min", "7 d".
bool stateDuration(const std::vector<std::string>& words);

/// Returns whether nothing but words about the test, the sample and the kind of load stands in a
/// text, and words that say nothing: numbers and short words, as prepositions. Any other word may
/// say that the sample was treated: "swollen", "vieilli".
bool areOnlyOfTest(const std::vector<std::string>& words);

/// Returns whether words are about the constants of a shift.
bool areOfShift(const std::vector<std::string>& words);

/// Returns whether words are about a glass transition.
bool areOfGlass(const std::vector<std::string>& words);

/// Returns whether a word says that a temperature need not be the sample's.
bool isVague(const std::string& word);

/// Returns whether a word names the temperature to which a master curve is shifted.
bool isOfReference(const std::string& word);

/// Returns whether a key names a temperature.
bool isTemperatureWord(std::string_view key);

/// Returns whether a key is of one temperature, so that a number without a unit is one too:
/// "Temperature", "T", "Messtemperatur", "Temp. of the sample", but not "Number of temperatures",
/// "Temperature sensor".
bool namesOneTemperature(std::string_view key);

}  // namespace asperity
