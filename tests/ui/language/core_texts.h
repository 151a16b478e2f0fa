// Every text that core gives people to read, made by asking for it: the table of parameters, the
// shipped scenes, plans, refusals, complaints, the paper's figures, diagrams.
#pragma once

#include <set>
#include <string>

namespace asperity {

std::set<std::string> tableTexts();      // labels, sentences, choices
std::set<std::string> sceneTexts();      // titles, chapters, descriptions of shipped scenes
std::set<std::string> planTexts();       // stages, and the reasons of every shipped scene and more
std::set<std::string> refusalTexts();    // of values that the table does not allow
std::set<std::string> complaintTexts();  // of scenes and profiles that cannot be read or cannot run
std::set<std::string> figureTexts();     // headlines, diagrams and claims, from few realizations
std::set<std::string> diagramTexts();    // curves, motions, what accuracy costs

}  // namespace asperity
