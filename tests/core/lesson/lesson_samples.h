// A small lesson as text, and its parts to be changed, for tests.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/lesson/lesson_file.h"

namespace asperity {

/// Two steps on a small line: a choice that a ratio decides, and a number.
inline nlohmann::ordered_json sampleLesson() {
  return nlohmann::ordered_json::parse(R"({
    "schema": "asperity-lesson/1",
    "title": {"en": "Sample", "de": "Probe"},
    "goal": "To try.",
    "minutes": 10,
    "notes": {"en": ["One.", "Two."], "de": "Eins."},
    "steps": [
      {"title": "First", "text": ["Look.", "Again."],
       "scene": {"schema": "asperity-scene/1", "surface": {"elements": 128},
                 "sliding": {"velocity": 1e-4}, "ensemble": {"realizations": 4},
                 "sweep": {"velocity_from": 1e-4, "velocity_to": 100, "points": 13}},
       "controls": {"free": ["sliding.velocity"], "locked": ["load.normal_force"]},
       "prediction": {"kind": "choice", "question": "Twice as fast?",
         "choices": [{"text": "same", "below": 1.5}, {"text": "twice", "above": 1.5, "below": 3},
                     {"text": "more", "above": 3}],
         "answer": {"quantity": "mu", "set": {"sliding.velocity": 2e-4},
                    "over": {"quantity": "mu"}},
         "right": "Yes, {answer}.", "wrong": "No, {answer}, not {given}."},
       "after": {"sliding.velocity": 2e-4}, "reveal": "{twice} twice.",
       "values": {"twice": {"quantity": "mu", "set": {"sliding.velocity": 2e-4}}}},
      {"text": "Second", "set": {"load.normal_force": "20mN"},
       "show": {"tab": "curve", "curve": "hidden", "hidden_range": {"from": 1e-6, "to": 1},
                "beside": [{"load.normal_force": 0.01}]},
       "prediction": {"kind": "number", "question": "Indentation?", "tolerance": 0.2,
                      "answer": {"quantity": "indentation"}}}
    ]})");
}

inline Lesson lessonOf(const nlohmann::ordered_json& json) {
  return readLesson(json.dump(), "sample.json");
}

}  // namespace asperity
