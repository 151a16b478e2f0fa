// The guided tour: six shipped scenes in order, each with one sentence and one thing to try. Plain
// values; GUI thread for the translation.
#pragma once

#include <QString>
#include <span>

namespace asperity {

struct TourStep {
  const char* scene;     // name of a shipped one
  const char* title;     // what happens
  const char* sentence;  // what is to be seen
  const char* attempt;   // what to try
};

std::span<const TourStep> tourSteps();

/// One of a step's texts in the language of the window.
QString tourText(const char* text);

}  // namespace asperity
