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

}  // namespace
}  // namespace asperity
