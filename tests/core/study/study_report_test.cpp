// The tables of the analysis of a study.
#include "core/study/study_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/study/study_file.h"

namespace asperity {
namespace {

TEST(StudyReport, AListOfArmsIsOneCellOfATable) {
  const ParameterStudy study =
      readStudy(R"({"schema":"asperity-study/1","set":{"elastomer.rheology":"prony"},"space":{)"
                R"("elastomer.arms":[[{"modulus":1e6,"relaxation_time":0.01}],)"
                R"([{"modulus":2e6,"relaxation_time":0.1}]]},"outputs":["mu"]})",
                "s.json", {});
  const StudyAnalysis analysis =
      analyseSimulations(study.space, {{"mu", {}}}, [](const UseSimulation& use) {
        for (const std::int64_t i : {0, 1}) {
          const double mu = 0.5 * static_cast<double>(i);
          use(i, {&mu, 1});
        }
      });
  EXPECT_THAT(effectsCsv(study, analysis),
              testing::HasSubstr(
                  R"(mu,elastomer.arms,"[{""modulus"":1000000.0,""relaxation_time"":0.01}]",0)"));
}

/// The positions of parameters are no numbers, and quantities have their names and units.
TEST(StudyReport, PicturesNameParametersAndQuantities) {
  const ParameterStudy study = readStudy(
      R"({"schema":"asperity-study/1","space":{"load.normal_force":[1,2,3],"surface.hurst":[0.3,1]},)"
      R"("sampling":"grid","outputs":["indentation"]})",
      "s.json", {});
  const StudyAnalysis analysis =
      analyseSimulations(study.space, {{"indentation", {}}}, [](const UseSimulation& use) {
        for (const std::int64_t i : {0, 1, 2, 3, 4, 5}) {
          const double depth = 1e-6 * static_cast<double>(i);
          use(i, {&depth, 1});
        }
      });
  const std::vector<NamedSheet> sheets = studySheets(study, analysis);
  ASSERT_EQ(sheets.size(), 2U);
  const Diagram& correlation = sheets[0].sheet.diagrams.at(0);
  EXPECT_EQ(correlation.title.english(), "indentation d");
  EXPECT_TRUE(correlation.x.isOfNames);
  EXPECT_EQ(sheets[1].sheet.title.english(), "indentation d over each parameter");
  EXPECT_EQ(sheets[1].sheet.diagrams.at(0).y.unit, "m");
}

}  // namespace
}  // namespace asperity
