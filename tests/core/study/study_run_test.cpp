// Running a study: every simulation is that of its own scene, whatever threads, processes and
// shards do the work; failures keep their messages; tables of the same results have the same bytes.
#include "core/study/study_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/input_error.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/scene/columns.h"
#include "core/scene/sweep.h"
#include "core/study/curve_fits.h"
#include "core/study/study_table.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

ParameterStudy studyOf(const std::string& members) {
  return readStudy(R"({"schema":"asperity-study/1","set":{"surface.elements":100,)"
                   R"("ensemble.realizations":2,"sweep.points":3},)" +
                       members + "}",
                   "s.json", {});
}

std::string tableOf(const StudyStore& store, TableShape shape = TableShape::Wide,
                    TableFormat format = TableFormat::Csv) {
  std::string text;
  writeStudyTable(store, shape, format, [&](std::string_view bytes) { text += bytes; });
  return text;
}

/// The number of a simulation from a curve of its own.
double ownNumber(const Scene& scene, const std::string& column, double velocity) {
  Scene single = scene;
  single.sweep.velocityFrom = single.sweep.velocityTo = velocity;
  single.sweep.points = 1;
  return curveValue(frictionCurve(single, {}).points.front(), column);
}

TEST(StudyRun, EverySimulationIsThatOfItsOwnScene) {
  const ParameterStudy study = studyOf(
      R"("sampling":"latin_hypercube","samples":12,"chunk":5,"space":{"surface.hurst":{"from":0.2,)"
      R"("to":0.9},"load.normal_force":{"from":0.001,"to":1},"surface.seed":{"from":1,"to":3}},)"
      R"("outputs":["mu","contact_fraction","curve.mu"])");
  const TemporaryFolder folder;
  StudyStore store(folder / "s", study, {});
  EXPECT_EQ(runStudy(store, {2, {}, {}}), 12);
  EXPECT_TRUE(store.isWhole());
  const std::vector<double> velocities = study.curveValues();
  std::vector<double> point(3);
  int compared = 0;
  store.eachChunk([&](const StudyChunk& chunk) {
    for (std::int64_t i = 0; i < chunk.count; i += 2) {
      study.space.pointInto(chunk.first + i, point);
      const Scene scene = study.sceneAt(point);
      const double mu = ownNumber(scene, "mu", scene.sliding.velocity);
      EXPECT_NEAR(chunk.at(0, i) / mu, 1, 1e-6);
      EXPECT_NEAR(chunk.at(1, i), ownNumber(scene, "contact_fraction", scene.sliding.velocity),
                  1e-6);
      for (std::size_t v = 0; v < velocities.size(); ++v)
        EXPECT_NEAR(chunk.at(2 + v, i) / ownNumber(scene, "mu", velocities[v]), 1, 1e-5);
      ++compared;
    }
    return true;
  });
  EXPECT_EQ(compared, 7);
}

TEST(StudyRun, ThreadsChangeNoBit) {
  const ParameterStudy study = studyOf(
      R"("chunk":4,"space":{"surface.hurst":[0.3,0.7],"load.normal_force":{"from":0.001,"to":1,)"
      R"("points":9}},"outputs":["mu","mu_standard_error","curve.indentation"])");
  const TemporaryFolder folder;
  std::string first;
  for (const int threads : {1, 2, 5}) {
    StudyStore store(folder / std::to_string(threads), study, {});
    runStudy(store, {threads, {}, {}});
    const std::string table = tableOf(store);
    if (first.empty()) first = table;
    EXPECT_EQ(table, first) << threads;
  }
  EXPECT_GT(first.size(), 1000U);
}

TEST(StudyRun, MergedShardsGiveTheTableOfOneRun) {
  const ParameterStudy study = studyOf(
      R"("sampling":"sobol","samples":50,"chunk":4,"space":{"surface.hurst":{"from":0.2,"to":0.9},)"
      R"("load.normal_force":{"from":0.001,"to":1}})");
  const TemporaryFolder folder;
  StudyStore whole(folder / "whole", study, {});
  runStudy(whole);
  std::vector<std::filesystem::path> parts;
  for (std::int64_t i = 3; i >= 1; --i) {
    StudyStore part(folder / std::to_string(i), study, {i, 3});
    runStudy(part);
    EXPECT_TRUE(part.isWhole());
    parts.push_back(part.file());
  }
  mergeStores({parts[1], parts[0], parts[2]}, folder / "merged");
  for (const TableShape shape : {TableShape::Wide, TableShape::Long})
    for (const TableFormat format : {TableFormat::Csv, TableFormat::Json})
      EXPECT_EQ(tableOf(StudyStore(folder / "merged"), shape, format),
                tableOf(whole, shape, format));
}

TEST(StudyRun, GoesOnWhereItWasStopped) {
  const ParameterStudy study =
      studyOf(R"("chunk":2,"space":{"load.normal_force":{"from":0.001,"to":1,"points":20}})");
  const TemporaryFolder folder;
  StudyStore whole(folder / "whole", study, {});
  runStudy(whole);
  std::stop_source stop;
  {
    StudyStore store(folder / "s", study, {});
    StudyRunOptions options{1, stop.get_token(), {}};
    options.progress = [&](std::int64_t done) {
      if (done >= 6) stop.request_stop();
    };
    EXPECT_EQ(runStudy(store, options), 6);
  }
  StudyStore store(folder / "s", study, {});
  EXPECT_EQ(runStudy(store), 14);
  EXPECT_EQ(runStudy(store), 0);
  EXPECT_EQ(tableOf(store), tableOf(whole));
}

TEST(StudyRun, AFailedSimulationKeepsItsMessageAndLeavesTheOthersAlone) {
  // A Hurst exponent cannot be above 1; the distribution goes there now and then.
  const ParameterStudy study = studyOf(
      R"("sampling":"sobol","samples":40,"space":{"surface.hurst":{"distribution":"normal",)"
      R"("mean":0.9,"deviation":0.1}})");
  const TemporaryFolder folder;
  StudyStore store(folder / "s", study, {});
  runStudy(store);
  std::int64_t failed = 0;
  std::vector<double> point(1);
  store.eachChunk([&](const StudyChunk& chunk) {
    std::size_t next = 0;
    for (std::int64_t i = 0; i < chunk.count; ++i) {
      study.space.pointInto(chunk.first + i, point);
      EXPECT_EQ(std::isnan(chunk.at(0, i)), point[0] > 1);
      if (!(point[0] > 1)) continue;
      ++failed;
      const StudyFailure& failure = chunk.failures.at(next++);
      EXPECT_EQ(failure.simulation, chunk.first + i);
      EXPECT_THAT(failure.message, testing::HasSubstr("is outside 0 to 1"));
    }
    EXPECT_EQ(next, chunk.failures.size());
    return true;
  });
  EXPECT_GT(failed, 2);
  EXPECT_LT(failed, 20);
  const std::string table = tableOf(store);
  EXPECT_THAT(table, testing::HasSubstr("simulation,surface.hurst,mu,error\n"));
  EXPECT_THAT(table, testing::HasSubstr("surface.hurst: "));
}

TEST(StudyTable, LongHasARowForEachNumber) {
  const ParameterStudy study =
      studyOf(R"("space":{"surface.hurst":[0.3,0.7]},"outputs":["mu","curve.contact_fraction"])");
  const TemporaryFolder folder;
  StudyStore store(folder / "s", study, {});
  runStudy(store);
  const std::string wide = tableOf(store), rows = tableOf(store, TableShape::Long);
  EXPECT_THAT(wide, testing::HasSubstr("simulation,surface.hurst,mu,contact_fraction_1,"
                                       "contact_fraction_2,contact_fraction_3\n"));
  EXPECT_THAT(rows, testing::HasSubstr("simulation,surface.hurst,output,sweep_value,value\n"));
  EXPECT_EQ(std::ranges::count(rows, '\n'), 2 + 2 * 4);
  const auto json = nlohmann::json::parse(tableOf(store, TableShape::Wide, TableFormat::Json));
  EXPECT_EQ(json["rows"].size(), 2U);
  EXPECT_EQ(json["rows"][1]["surface.hurst"], 0.7);
  EXPECT_EQ(json["curve"]["values"].size(), 3U);
  EXPECT_EQ(json["keys"], nlohmann::json({"surface.hurst"}));
  const auto jsonRows = nlohmann::json::parse(tableOf(store, TableShape::Long, TableFormat::Json));
  EXPECT_EQ(jsonRows["rows"].size(), 8U);
  EXPECT_EQ(jsonRows["rows"][1]["value"], json["rows"][0]["contact_fraction_1"]);
}

/// Eqs. (5) to (8): in slow sliding friction is proportional to velocity, whatever the line.
TEST(StudyRun, FitsOfSlowSlidingHaveTheExponentOfVelocity) {
  const ParameterStudy study = readStudy(
      R"({"schema":"asperity-study/1","set":{"surface.elements":200,"ensemble.realizations":2,)"
      R"("sweep.points":7,"sweep.velocity_from":1e-9,"sweep.velocity_to":1e-6},)"
      R"("space":{"surface.hurst":[0.3,0.7,1],"load.normal_force":[0.001,0.1]},)"
      R"("outputs":["fit.exponent","mu","fit.maximum","curve.mu","fit.begin_of_region_2"]})",
      "s.json", {});
  const TemporaryFolder folder;
  StudyStore store(folder / "s", study, {});
  runStudy(store);
  EXPECT_FALSE(store.hasFailures());
  std::int64_t compared = 0;
  store.eachChunk([&](const StudyChunk& chunk) {
    for (std::int64_t i = 0; i < chunk.count; ++i, ++compared) {
      EXPECT_NEAR(chunk.at(0, i), 1, 1e-3);
      EXPECT_EQ(chunk.at(2, i), chunk.at(9, i));  // the last of seven points
      EXPECT_TRUE(std::isnan(chunk.at(10, i)));
    }
    return true;
  });
  EXPECT_EQ(compared, 6);
  EXPECT_THAT(tableOf(store), testing::HasSubstr("surface.hurst,load.normal_force,fit.exponent,mu,"
                                                 "fit.maximum,mu_1,"));
}

/// The numbers of a study are those of each simulation's own curve.
TEST(StudyRun, FitsAreThoseOfEachCurve) {
  std::string outputs;
  for (const CurveFitEntry& entry : kCurveFits)
    outputs += (outputs.empty() ? "\"" : ",\"") + entry.name.text() + "\"";
  const ParameterStudy study = readStudy(
      R"({"schema":"asperity-study/1","set":{"surface.elements":200,"ensemble.realizations":3,)"
      R"("sweep.points":33,"sweep.velocity_to":1e5},"chunk":2,)"
      R"("space":{"elastomer.relaxation_time":[1e-4,1e-2],"surface.hurst":[0.4,0.8]},"outputs":[)" +
          outputs + "]}",
      "s.json", {});
  const TemporaryFolder folder;
  StudyStore store(folder / "s", study, {});
  runStudy(store);
  std::vector<double> point(2);
  int known = 0;
  store.eachChunk([&](const StudyChunk& chunk) {
    for (std::int64_t i = 0; i < chunk.count; ++i) {
      study.space.pointInto(chunk.first + i, point);
      const Scene scene = study.sceneAt(point);
      const CurveFitValues own =
          curveFits(scene, sweepValues(scene), frictionCurve(scene, {}).points);
      for (std::size_t k = 0; k < own.size(); ++k) {
        EXPECT_EQ(std::isnan(own[k]), std::isnan(chunk.at(k, i))) << kCurveFits[k].name.text();
        if (std::isnan(own[k])) continue;
        EXPECT_NEAR(own[k], chunk.at(k, i), 1e-5 * std::abs(own[k]) + 1e-9)
            << kCurveFits[k].name.text();
        ++known;
      }
    }
    return true;
  });
  EXPECT_GE(known, 4 * 11);
}

TEST(StudyBudget, CountsWhatThereIsToDo) {
  const ParameterStudy study = studyOf(
      R"("space":{"surface.hurst":[0.3,0.7],"surface.seed":{"from":1,"to":50,"points":50,"scale":)"
      R"("linear"}},"outputs":["mu","curve.mu"])");
  const StudyBudget budget = studyBudget(study, 100, 40, 1, 0.02);
  EXPECT_EQ(budget.simulations, 100);
  EXPECT_EQ(budget.states, 400);
  EXPECT_EQ(budget.lines, 2);
  EXPECT_GT(budget.seconds, 0);
  EXPECT_EQ(budget.trialFailures, 0);
}

}  // namespace
}  // namespace asperity
