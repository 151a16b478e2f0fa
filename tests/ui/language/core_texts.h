// Every text that core gives people to read, made by asking for it: the table of parameters, the
// shipped scenes, plans, refusals, complaints, the paper's figures, diagrams.
#pragma once

#include <set>
#include "core/base/message.h"

namespace asperity {

std::set<Message> tableTexts();        // labels, sentences, choices
std::set<Message> sceneTexts();        // titles, chapters, descriptions of shipped scenes
std::set<Message> explanationTexts();  // under the pointer; notes; what theories hold for
std::set<Message> planTexts();         // stages, and the reasons of every shipped scene and more
std::set<Message> refusalTexts();      // of values that the table does not allow
std::set<Message> complaintTexts();    // of scenes and profiles that cannot be read or cannot run
std::set<Message> figureTexts();       // headlines, diagrams and claims, from few realizations
std::set<Message> diagramTexts();      // curves, motions, what accuracy costs

}  // namespace asperity
