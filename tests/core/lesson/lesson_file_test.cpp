// Lessons as files: what they mean, that they survive writing, and that nothing wrong passes.
#include "core/lesson/lesson_file.h"

#include <gmock/gmock.h>

#include <random>

#include "core/base/input_error.h"
#include "core/scene/scene_file.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST(LessonFile, StepsGoOnFromWhatTheOneBeforeRevealed) {
  const Lesson lesson = lessonOf(sampleLesson());
  ASSERT_EQ(lesson.steps.size(), 2U);
  EXPECT_EQ(lesson.title.in("de"), "Probe");
  EXPECT_EQ(lesson.goal.in("de"), "To try.");  // the only language there is
  EXPECT_EQ(lesson.notes.english, "One.\n\nTwo.");
  EXPECT_EQ(lesson.steps[0].scene.sliding.velocity, 1e-4);
  EXPECT_EQ(lesson.steps[0].revealedScene.sliding.velocity, 2e-4);
  EXPECT_EQ(lesson.steps[1].scene.sliding.velocity, 2e-4);
  EXPECT_EQ(lesson.steps[1].scene.load.normalForce, 0.02);
  EXPECT_EQ(lesson.steps[1].scene.surface.elements, 128);
  EXPECT_EQ(lesson.name, "sample");
}

TEST(LessonFile, IsTheSameAfterWriting) {
  const Lesson lesson = lessonOf(sampleLesson());
  const std::string text = writeLesson(lesson);
  const Lesson again = readLesson(text, "sample.json");
  EXPECT_EQ(again, lesson);
  EXPECT_EQ(writeLesson(again), text);
  EXPECT_EQ(lesson.digest.size(), 64U);
}

TEST(LessonFile, ACurveIsShownHiddenOrHiddenThroughout) {
  for (const auto& [word, hides, hidesAfter] : {std::tuple("shown", false, false),
                                                {"hidden", true, false},
                                                {"hidden_throughout", true, true}}) {
    Json json = sampleLesson();
    json["steps"][0]["show"]["curve"] = word;
    const Lesson lesson = lessonOf(json);
    EXPECT_EQ(lesson.steps[0].show.hidesCurve, hides);
    EXPECT_EQ(lesson.steps[0].show.hidesCurveAfter, hidesAfter);
    EXPECT_EQ(readLesson(writeLesson(lesson), "again.json").steps[0].show, lesson.steps[0].show);
  }
}

TEST(LessonFile, TheVerticalAxisIsLogarithmicOrLinear) {
  Json json = sampleLesson();
  EXPECT_FALSE(lessonOf(json).steps[0].show.isLinearY);
  json["steps"][0]["show"]["scale"] = "linear";
  json["steps"][0]["show"]["hidden_range"] = {{"from", 0}, {"to", 1}};
  const Lesson lesson = lessonOf(json);
  EXPECT_TRUE(lesson.steps[0].show.isLinearY);
  EXPECT_EQ(lesson.steps[0].show.hiddenFrom, 0);
  EXPECT_TRUE(readLesson(writeLesson(lesson), "again.json").steps[0].show.isLinearY);
}

TEST(LessonFile, ControlsAreFreeLockedOrHidden) {
  const LessonStep step = lessonOf(sampleLesson()).steps[0];
  EXPECT_EQ(step.controls.state("sliding.velocity"), ControlState::Free);
  EXPECT_EQ(step.controls.state("load.normal_force"), ControlState::Locked);
  EXPECT_EQ(step.controls.state("surface.hurst"), ControlState::Hidden);
  Scene given = step.scene;
  given.sliding.velocity = 3;
  EXPECT_TRUE(lockedChanges(step.controls, step.scene, given).empty());
  given.load.normalForce = 5;
  given.surface.hurst = 0.3;
  EXPECT_THAT(lockedChanges(step.controls, step.scene, given),
              testing::UnorderedElementsAre("load.normal_force", "surface.hurst"));
  const Scene held = withinControls(step.controls, step.scene, given);
  EXPECT_EQ(held.sliding.velocity, 3);
  EXPECT_EQ(held.load.normalForce, step.scene.load.normalForce);
  EXPECT_EQ(held.surface.hurst, step.scene.surface.hurst);
}

/// What is wrong in a lesson, where, and what the message says.
struct Wrong {
  const char *pointer, *value, *key, *says;
};

void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.pointer << " = " << wrong.value;
}

class WrongLesson : public testing::TestWithParam<Wrong> {};

TEST_P(WrongLesson, IsRefusedWithItsPlace) {
  const auto& [pointer, value, key, says] = GetParam();
  Json json = sampleLesson();
  json[Json::json_pointer(pointer)] = Json::parse(value);
  try {
    lessonOf(json);
    FAIL() << "is read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "sample.json");
    EXPECT_EQ(error.key(), key);
    EXPECT_THAT(error.what(), HasSubstr(says));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongLesson,
    testing::Values(
        Wrong{"/schema", "\"asperity-lesson/2\"", "schema", "asperity-lesson/1"},
        Wrong{"/schema", "\"asperity-lesson-results/1\"", "", "the results of a student"},
        Wrong{"/titel", "1", "titel", "title"}, Wrong{"/minutes", "0", "minutes", "1 to 600"},
        Wrong{"/steps", "[]", "steps", "1 to 200"},
        Wrong{"/title", "{\"fr\": \"x\"}", "title.fr", "known are en, de"},
        Wrong{"/title", "3", "title", "text"}, Wrong{"/title", "\"\"", "title", "empty"},
        Wrong{"/steps/0/txt", "1", "steps[0].txt", "text"},
        Wrong{"/steps/0/scene", "3", "steps[0].scene", "scene"},
        Wrong{"/steps/0/scene", "\"none.json\"", "steps[0].scene", "none.json"},
        Wrong{"/steps/0/scene", "{\"surface\": {\"hurts\": 1}}", "steps[0].scene.surface.hurts",
              "surface.hurst"},
        Wrong{"/steps/1/set", "{\"load.normal_forc\": 1}", "steps[1].set.load.normal_forc",
              "load.normal_force"},
        Wrong{"/steps/1/set", "{\"load.normal_force\": -1}", "steps[1].set.load.normal_force",
              "outside"},
        Wrong{"/steps/1/set", "{\"load.normal_force\": \"2 kg\"}", "steps[1].set.load.normal_force",
              "kg"},
        Wrong{"/steps/1/set", "{\"load.normal_force\": null}", "steps[1].set.load.normal_force",
              "allowed"},
        Wrong{"/steps/1/after", "{\"surface.slope\": 1}", "steps[1].after.surface.slope",
              "has no meaning"},
        Wrong{"/steps/1/show/tab", "\"curves\"", "steps[1].show.tab", "curve"},
        Wrong{"/steps/1/show/quantity", "\"nu\"", "steps[1].show.quantity", "mu"},
        Wrong{"/steps/1/show/curve", "\"no\"", "steps[1].show.curve", "hidden"},
        Wrong{"/steps/1/show/scale", "\"lin\"", "steps[1].show.scale", "linear"},
        Wrong{"/steps/1/show/hidden_range", "{\"from\": 0, \"to\": 1}",
              "steps[1].show.hidden_range", "above 0"},
        Wrong{"/steps/1/show", R"({"scale": "linear", "hidden_range": {"from": -1, "to": 1}})",
              "steps[1].show.hidden_range", "from 0 on"},
        Wrong{"/steps/1/show/hidden_range", "{\"from\": 1, \"to\": 1}",
              "steps[1].show.hidden_range", "larger"},
        Wrong{"/steps/1/show/beside",
              "[{\"sweep.key\": \"load.normal_force\", \"sweep.from\": 1, "
              "\"sweep.to\": 2}]",
              "steps[1].show.beside[0]", "another axis"},
        Wrong{"/steps/0/controls", "{\"free\": [\"surface.slope\"]}", "steps[0].controls.free",
              "has no meaning"},
        Wrong{"/steps/0/controls", "{\"free\": [\"x\"]}", "steps[0].controls.free.x", "unknown"},
        Wrong{"/steps/0/controls/others", "\"open\"", "steps[0].controls.others", "hidden"},
        Wrong{"/steps/0/controls/hidden", "[\"sliding.velocity\"]", "steps[0].controls.hidden",
              "twice"},
        Wrong{"/steps/0/prediction/kind", "\"guess\"", "steps[0].prediction.kind", "choice"},
        Wrong{"/steps/0/prediction/question", "\"\"", "steps[0].prediction.question", "empty"},
        Wrong{"/steps/0/prediction/tolerance", "1", "steps[0].prediction.tolerance", "a number"},
        Wrong{"/steps/0/prediction/choices", "[]", "steps[0].prediction.choices", "2 to 9"},
        Wrong{"/steps/0/prediction/choices/1/above", "1", "steps[0].prediction.choices[1]",
              "overlaps"},
        Wrong{"/steps/0/prediction/choices/1/right", "true", "steps[0].prediction.choices[1].right",
              "computed"},
        Wrong{"/steps/0/prediction/choices/1", "{\"text\": \"x\"}",
              "steps[0].prediction.choices[1]", "above or below"},
        Wrong{"/steps/0/prediction/answer/quantity", "\"my\"",
              "steps[0].prediction.answer.quantity", "mu"},
        Wrong{"/steps/0/prediction/answer/peak", "\"mu\"", "steps[0].prediction.answer", "one of"},
        Wrong{"/steps/0/prediction/answer/key", "\"mu\"", "steps[0].prediction.answer.key",
              "exponent"},
        Wrong{"/steps/0/prediction/answer/over/over", "{\"quantity\": \"mu\"}",
              "steps[0].prediction.answer.over.over", "outer"},
        Wrong{"/steps/0/prediction/right", "\"{mu}\"", "steps[0].prediction.right", "answer"},
        Wrong{"/steps/0/values/answer", "{\"quantity\": \"mu\"}", "steps[0].values.answer", "name"},
        Wrong{"/steps/1/prediction/tolerance", "0", "steps[1].prediction.tolerance", "above 0"},
        Wrong{"/steps/1/prediction/answer",
              "{\"exponent\": \"mu\", \"key\": \"surface.kind\", \"from\": 1, \"to\": 2}",
              "steps[1].prediction.answer.key.surface.kind", "number"},
        Wrong{"/steps/1/prediction/answer",
              "{\"exponent\": \"mu\", \"key\": \"load.normal_force\", \"from\": 0, \"to\": 2}",
              "steps[1].prediction.answer", "above 0"},
        Wrong{"/steps/1/prediction", "{\"kind\": \"point\", \"question\": \"?\", \"x\": 1e9}",
              "steps[1].prediction.x", "axis"},
        Wrong{"/steps/1/prediction", "{\"kind\": \"number\", \"question\": \"?\"}",
              "steps[1].prediction.answer", "computed"}));

TEST(LessonFile, AChoiceThatNothingDecidesNeedsOneRightOne) {
  Json json = sampleLesson();
  Json& prediction = json["steps"][0]["prediction"];
  prediction.erase("answer");
  prediction["right"] = prediction["wrong"] = "";
  prediction["choices"] = {{{"text", "a"}, {"right", true}}, {{"text", "b"}}};
  EXPECT_NO_THROW(lessonOf(json));
  prediction["choices"][1]["right"] = true;
  EXPECT_THROW(lessonOf(json), InputError);
  prediction["choices"] = {{{"text", "a"}}, {{"text", "b"}}};
  EXPECT_THROW(lessonOf(json), InputError);
}

TEST(LessonFile, WhatIsShownAfterAnAnswerNeedsAPrediction) {
  Json json = sampleLesson();
  json["steps"][1].erase("prediction");
  EXPECT_NO_THROW(lessonOf(json));
  json["steps"][1]["reveal"] = "So.";
  EXPECT_THROW(lessonOf(json), InputError);
}

TEST(LessonFile, ScenesAreFilesBesideTheLessonOrAreFoundByTheReader) {
  TemporaryFolder folder;
  folder.write("mine.json", R"({"surface": {"elements": 64}})");
  Json json = sampleLesson();
  json["steps"][0]["scene"] = "mine.json";
  folder.write("lesson.json", json.dump());
  EXPECT_EQ(readLessonFile(folder / "lesson.json").steps[0].scene.surface.elements, 64);
  json["steps"][0]["scene"] = "shipped.json";
  const auto find = [](const std::string& name, const std::filesystem::path&,
                       const std::vector<std::string>&) {
    EXPECT_EQ(name, "shipped.json");
    return readScene(R"({"surface": {"elements": 32}})", name);
  };
  EXPECT_EQ(readLesson(json.dump(), "x", {}, find).steps[0].scene.surface.elements, 32);
}

TEST(LessonFile, IsToldFromOtherFiles) {
  TemporaryFolder folder;
  const auto isLesson = [&folder](const std::string& text) {
    folder.write("file.json", text);
    return isLessonFile(folder.path() / "file.json");
  };
  EXPECT_TRUE(isLesson(sampleLesson().dump()));
  EXPECT_FALSE(isLesson(R"({"schema": "asperity-scene/1"})"));
  EXPECT_FALSE(isLesson("no JSON"));
  EXPECT_FALSE(isLesson(""));
  EXPECT_FALSE(isLessonFile(folder.path()));
  EXPECT_THROW(readNamedLesson("no_such_lesson"), InputError);
}

/// Bytes that are changed at random are read or refused, and nothing else happens.
TEST(LessonFile, AnythingIsReadOrRefused) {
  const std::string text = sampleLesson().dump();
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string changed = text;
    for (unsigned n = 1 + random() % 4; n > 0; --n) {
      const std::size_t place = random() % changed.size();
      switch (random() % 4) {
        case 0:
          changed[place] = static_cast<char>(random());
          break;
        case 1:
          changed.erase(place, random() % 40);
          break;
        case 2:
          changed.insert(place, changed.substr(random() % changed.size(), random() % 60));
          break;
        default:
          changed[place] = "{}[],:\"0e-"[random() % 10];
      }
      if (changed.empty()) changed = " ";
    }
    try {
      const Lesson lesson = readLesson(changed, "x.json");
      EXPECT_EQ(readLesson(writeLesson(lesson), "x.json"), lesson);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
}

/// Whatever a lesson lacks, it can be written and read again to be completed.
TEST(LessonDrafts, WhatALessonLacksDoesNotKeepItFromBeingReadAgain) {
  const auto whole = sampleLesson();
  const auto pointer = [](const char* path) { return nlohmann::ordered_json::json_pointer(path); };
  for (const char* path :
       {"/title", "/steps/0/text", "/steps/0/prediction/question", "/steps/0/prediction/choices",
        "/steps/0/prediction/choices/0/text", "/steps/0/prediction/choices/1/above",
        "/steps/0/prediction/answer", "/steps/1/prediction/answer"}) {
    auto json = whole;
    const auto place = pointer(path);
    json[place.parent_pointer()].erase(place.back());
    if (place.back() == "above") json[place.parent_pointer()].erase("below");
    EXPECT_THROW(readLesson(json.dump(), "draft.json"), InputError) << path;
    const Lesson draft = readDraft(json.dump(), "draft.json");
    ASSERT_EQ(draft.steps.size(), 2U) << path;
    EXPECT_EQ(draft.steps[1].scene, lessonOf(whole).steps[1].scene) << path;
    EXPECT_EQ(writeLesson(readDraft(writeLesson(draft), "draft.json")), writeLesson(draft)) << path;
  }
  EXPECT_EQ(readDraft(writeLesson(Lesson{}), "draft.json"),
            readDraft(writeLesson(Lesson{}), "draft.json"));
  EXPECT_EQ(writeLesson(readDraft(whole.dump(), "a")), writeLesson(lessonOf(whole)));
}

/// A change that is impossible is kept; the scene is that without it.
TEST(LessonDrafts, AnImpossibleChangeIsKept) {
  auto json = sampleLesson();
  json["steps"][1]["set"]["load.normal_force"] = "much";
  const Lesson draft = readDraft(json.dump(), "draft.json");
  EXPECT_EQ(draft.steps[1].set, std::vector<std::string>{"load.normal_force=much"});
  EXPECT_EQ(draft.steps[1].scene, draft.steps[0].revealedScene);
  for (const char* wrong : {"{}", "[1]", R"({"schema": "asperity-scene/1"})",
                            R"({"schema": "asperity-lesson/1", "stps": []})"})
    EXPECT_THROW(readDraft(wrong, "draft.json"), InputError) << wrong;
}

/// Students read a question in one language, also where a teacher translated a part of it.
TEST(LessonTranslations, AQuestionThatIsTranslatedInPartFallsBackAsAWhole) {
  auto json = sampleLesson();
  auto& prediction = json["steps"][0]["prediction"];
  prediction["choices"][0]["text"] = {{"en", "same"}, {"de", "gleich"}};
  const Lesson written = lessonOf(json);
  const Lesson read = withWholeQuestions(written);
  EXPECT_EQ(read.steps[0].prediction->choices[0].text.in("de"), "same");
  EXPECT_EQ(read.title, written.title);
  prediction["question"] = {{"en", "Twice as fast?"}, {"de", "Doppelt so schnell?"}};
  prediction["choices"][1]["text"] = {{"en", "twice"}, {"de", "doppelt"}};
  prediction["choices"][2]["text"] = {{"en", "more"}, {"de", "mehr"}};
  prediction["right"] = {{"en", "Yes, {answer}."}, {"de", "Ja, {answer}."}};
  prediction["wrong"] = {{"en", "No."}, {"de", "Nein."}};
  EXPECT_EQ(withWholeQuestions(lessonOf(json)).steps[0].prediction->question.in("de"),
            "Twice as fast?")
      << "the text after the answer lacks its translation";
  json["steps"][0]["reveal"] = {{"en", "{twice} twice."}, {"de", "{twice} doppelt."}};
  EXPECT_EQ(withWholeQuestions(lessonOf(json)), lessonOf(json));
  prediction["question"] = {{"de", "Doppelt so schnell?"}};  // now English lacks a part
  EXPECT_EQ(withWholeQuestions(lessonOf(json)).steps[0].prediction->choices[1].text.in("en"),
            "doppelt");
}

}  // namespace
}  // namespace asperity
