#include "ui/language/words.h"

#include "ui/language/language.h"

namespace asperity {

std::string Words::tr(const char* english) {
  // Qt's tool finds the namespace in most places, but not in all.
  for (const char* context : {"asperity::Words", "Words"})
    if (const auto found = translationIn(context, english)) return found->toStdString();
  return english;
}

}  // namespace asperity
