#include "ui/language/words.h"

#include "ui/language/language.h"

namespace asperity {

std::string Words::tr(const char* english) {
  // The tool finds the namespace in most places, but not in all.
  for (const char* context : {"asperity::Words", "Words"})
    if (const auto found = translationIn(context, english)) return found->toStdString();
  return english;
}

std::string filled(const std::string& text, std::initializer_list<std::string> values) {
  std::string whole;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto place = i + 1 < text.size() && text[i] == '%'
                           ? static_cast<std::size_t>(text[i + 1] - '1')
                           : values.size();
    if (place < values.size())
      whole += values.begin()[place], ++i;
    else
      whole += text[i];
  }
  return whole;
}

}  // namespace asperity
