// The table of a motion: its columns, its rows and what their numbers have to do with each other.
#include "core/run/motion_table.h"
#include "core/base/stop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>
#include "core/base/input_error.h"

#include "core/scene/columns.h"
#include "core/surface/line_source.h"
#include "core/surface/surface_file.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

constexpr const char* kHeader =
    "time,displacement,velocity,normal_force,tangential_force,mu,indentation,contact_fraction,"
    "contact_spots,power_in,power_dissipated,mu_interface,realization";

Scene someMotion(SlidingKind kind) {
  Scene scene;
  scene.surface.elements = 200;
  scene.load.normalForce = 0.02;
  scene.accuracy.oversampling = 2;
  scene.sliding.kind = kind;
  scene.sliding.velocity = 0.5;
  scene.sliding.velocityAfter = 0;
  scene.sliding.amplitude = 0.5;
  scene.sliding.frequency = 200;
  scene.sliding.duration = 0.01;
  return scene;
}

using Row = std::map<std::string, double>;

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char letter : line)
    if (letter == ',')
      cells.emplace_back();
    else
      cells.back() += letter;
  return cells;
}

std::vector<Row> rowsOf(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, kHeader);
  const std::vector<std::string> names = cellsOf(line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cellsOf(line);
    EXPECT_EQ(cells.size(), names.size());
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i)
      row[names[i]] = cells[i].empty() ? kNotApplicable : std::stod(cells[i]);
  }
  return rows;
}

std::vector<Row> rowsOf(const Scene& scene, const MotionOptions& options = {}) {
  return rowsOf(motionCsv(marchMotion(scene, options)));
}

TEST(MotionTable, RowsSayWhatTheirColumnsMean) {
  for (const SlidingKind kind :
       {SlidingKind::Start, SlidingKind::Step, SlidingKind::Oscillation, SlidingKind::Reversal}) {
    const Scene scene = someMotion(kind);
    const std::vector<Row> rows = rowsOf(scene);
    ASSERT_GE(rows.size(), 500U);
    EXPECT_EQ(rows.back().at("time"), scene.sliding.duration);
    double time = 0, displacement = 0;
    for (const Row& row : rows) {
      EXPECT_GT(row.at("time"), time);
      EXPECT_NEAR(row.at("displacement") - displacement,
                  row.at("velocity") * (row.at("time") - time), 1e-15);
      time = row.at("time");
      displacement = row.at("displacement");
      EXPECT_NEAR(row.at("normal_force"), 0.02, 1e-12);
      EXPECT_NEAR(row.at("mu"), std::abs(row.at("tangential_force")) / row.at("normal_force"),
                  1e-12);
      EXPECT_NEAR(row.at("power_in"), -row.at("tangential_force") * row.at("velocity"), 1e-15);
      EXPECT_GE(row.at("power_dissipated"), 0);
      EXPECT_GT(row.at("contact_spots"), 0);
      EXPECT_TRUE(std::isnan(row.at("mu_interface")));
      EXPECT_EQ(row.at("realization"), 0);
    }
    if (kind == SlidingKind::Reversal) {
      EXPECT_LT(rows[rows.size() / 2 - 9].at("tangential_force"), 0);  // against +x
      EXPECT_GT(rows.back().at("tangential_force"), 0);
    }
  }
}

TEST(MotionTable, ColumnsAreThoseOfTheTextLineAfterLine) {
  Scene scene = someMotion(SlidingKind::Start);
  MotionOptions options{.every = 50, .lines = 2};
  for (const double interfaceFriction : {0.0, 0.1}) {
    scene.interface.frictionCoefficient = interfaceFriction;
    const MotionTable table = marchMotion(scene, options);
    const std::vector<Row> rows = rowsOf(motionCsv(table));
    const std::vector<MotionValues> columns = motionColumns(table);
    ASSERT_EQ(columns.size() + 1, rows.front().size());
    for (const MotionValues& column : columns) {
      ASSERT_EQ(column.values.size(), rows.size()) << column.name;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const double written = rows[i].at(column.name);
        EXPECT_TRUE(std::isnan(written) ? std::isnan(column.values[i])
                                        : written == column.values[i])
            << column.name;
      }
    }
  }
}

/// From steady state to steady state all that friction gave is heat: nothing more is stored.
TEST(MotionTable, WhatSteadySlidingPutsInIsDissipated) {
  Scene scene = someMotion(SlidingKind::Step);
  scene.accuracy.oversampling = 4;
  scene.sliding.velocityAfter = scene.sliding.velocity;
  scene.sliding.duration = 3 * scene.surface.length / scene.sliding.velocity;
  double in = 0, out = 0, last = 0;
  for (const Row& row : rowsOf(scene)) {
    const double dt = row.at("time") - last;
    last = row.at("time");
    if (last < scene.sliding.duration / 3) continue;  // until the march is in its own steady state
    in += row.at("power_in") * dt;
    out += row.at("power_dissipated") * dt;
  }
  EXPECT_NEAR(out / in, 1, 1e-3);
}

TEST(MotionTable, EachNthStepIsARowOfTheWholeTableAndTheLastOneToo) {
  const Scene scene = someMotion(SlidingKind::Step);
  const std::string whole = motionCsv(marchMotion(scene, {}));
  const std::vector<Row> all = rowsOf(whole);
  MotionOptions options;
  options.every = 7;
  const std::vector<Row> some = rowsOf(scene, options);
  ASSERT_EQ(some.size(), (all.size() + 6) / 7);
  for (std::size_t i = 0; i < some.size(); ++i) {
    const Row& same = all[std::min(7 * (i + 1), all.size()) - 1];
    EXPECT_EQ(some[i].at("time"), same.at("time"));
    EXPECT_EQ(some[i].at("mu"), same.at("mu"));
  }
  options.every = 1;
  options.mostRows = 100;
  EXPECT_LE(rowsOf(scene, options).size(), 100U);
}

/// Some 10,000 steps: none of them is missing where friction is greatest or least.
TEST(MotionTable, ThePictureOfALineShowsThePeaksOfAllSteps) {
  Scene scene = someMotion(SlidingKind::Oscillation);
  scene.sliding.frequency = 50;
  scene.sliding.duration = 1;
  const MotionTable table = marchMotion(scene, {});
  const auto& rows = table.lines[0];
  ASSERT_GT(rows.size(), 4000U);
  EXPECT_LT(table.drawn.size(), 4000U);
  using Member = double TransientSample::*;
  for (const Member member :
       {Member{&TransientSample::mu}, Member{&TransientSample::velocity},
        Member{&TransientSample::indentation}, Member{&TransientSample::contactFraction}}) {
    const auto value = [member](const TransientSample& sample) { return sample.*member; };
    EXPECT_EQ(std::ranges::max(table.drawn, {}, value).*member,
              std::ranges::max(rows, {}, value).*member);
    EXPECT_EQ(std::ranges::min(table.drawn, {}, value).*member,
              std::ranges::min(rows, {}, value).*member);
  }
  EXPECT_TRUE(std::ranges::is_sorted(table.drawn, {}, &TransientSample::time));
  // Each peak of the velocity, not the first alone.
  EXPECT_GT(std::ranges::count_if(table.drawn, [](const auto& s) { return s.velocity > 0.99; }),
            50);
}

TEST(MotionTable, ThePictureOfAShortMotionShowsEachStep) {
  const MotionTable table = marchMotion(someMotion(SlidingKind::Start), {});
  const auto& rows = table.lines[0];
  ASSERT_EQ(table.drawn.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(table.drawn[i].time, rows[i].time);
    EXPECT_EQ(table.drawn[i].mu, rows[i].mu);
  }
}

/// Steps of 1/500 of 5 ms.
TEST(MotionTable, TimesAreMultiplesOfTheStepAndPrintedShort) {
  Scene scene = someMotion(SlidingKind::Start);
  scene.sliding.duration = 5e-3;
  std::istringstream lines(motionCsv(marchMotion(scene, {})));
  std::string line;
  std::getline(lines, line);
  int rows = 0;
  while (std::getline(lines, line)) {
    ++rows;
    const std::string time = cellsOf(line).front();
    EXPECT_LE(time.size(), 8U) << time;
    EXPECT_NEAR(std::stod(time), 1e-5 * rows, 1e-16);
  }
  EXPECT_EQ(rows, 500);
}

/// Friction of an elastic body is rounding: the axis shows the 0 that lies within its error.
TEST(MotionTable, TheBandOfErrorsFitsOnTheAxis) {
  Scene scene = someMotion(SlidingKind::Step);
  scene.elastomer.rheology = Rheology::Elastic;
  for (const Rheology rheology : {Rheology::Elastic, Rheology::Kelvin}) {
    scene.elastomer.rheology = rheology;
    const MotionTable table = marchMotion(scene, {});
    const Diagram friction = motionSheet(scene, table).diagrams[1];
    for (const DiagramSeries& series : friction.series)
      for (const DiagramPoint& point : series.points) {
        if (!series.isBand) continue;
        EXPECT_GE(point.low, friction.y.from);
        EXPECT_LE(point.high, friction.y.to);
      }
  }
}

TEST(MotionTable, ThePictureSaysThatFrictionIsOfDeformationAlone) {
  Scene scene = someMotion(SlidingKind::Start);
  EXPECT_EQ(motionSheet(scene, marchMotion(scene, {})).diagrams[1].y.title.english(),
            "friction \u03BC");
  scene.interface.frictionCoefficient = 0.1;
  EXPECT_EQ(motionSheet(scene, marchMotion(scene, {})).diagrams[1].y.title.english(),
            "friction \u03BC, deformation alone");
}

/// The guide at the rate 1/tau + v/l is drawn where the note explains it, for one line and for the
/// mean of several; other elements than Kelvin's have neither.
TEST(MotionTable, ThePictureHasTheGuideThatItExplains) {
  for (const SlidingKind kind : {SlidingKind::Start, SlidingKind::Step})
    for (const std::int64_t lines : {1, 3})
      for (const Rheology rheology : {Rheology::Kelvin, Rheology::StandardSolid}) {
        Scene scene = someMotion(kind);
        scene.elastomer.rheology = rheology;
        scene.sliding.velocityAfter = 0.6;
        MotionOptions options;
        options.lines = lines;
        const DiagramSheet sheet = motionSheet(scene, marchMotion(scene, options));
        const auto& series = sheet.diagrams[1].series;
        const auto guide = std::ranges::find_if(series, &DiagramSeries::isTheory);
        const bool isKelvin = rheology == Rheology::Kelvin;
        EXPECT_EQ(guide != series.end(), isKelvin) << lines;
        EXPECT_EQ(sheet.note.english().find("Dashed: ") != std::string::npos, isKelvin) << lines;
        if (!isKelvin || guide == series.end()) continue;
        // It begins on the friction of the picture, and is as long.
        const auto friction = std::ranges::find(series, false, &DiagramSeries::isBand);
        const DiagramPoint& first = guide->points.front();
        const auto same = std::ranges::find(friction->points, first.x, &DiagramPoint::x);
        ASSERT_NE(same, friction->points.end());
        EXPECT_EQ(same->y, first.y);
        EXPECT_EQ(guide->points.back().x, friction->points.back().x);
      }
}

TEST(MotionTable, LinesAreRealizationsAndTheirMeanIsThePicture) {
  const Scene scene = someMotion(SlidingKind::Start);
  MotionOptions options;
  options.lines = 3;
  const MotionTable table = marchMotion(scene, options);
  ASSERT_EQ(table.lines.size(), 3U);
  EXPECT_EQ(motionCsv(table).find(motionCsv(marchMotion(scene, {}))), 0U);  // line 0 comes first
  double each = 0;
  for (const auto& rows : table.lines) each += rows.back().indentation / 3;
  EXPECT_NE(table.lines[1].back().mu, table.lines[0].back().mu);
  EXPECT_NEAR(table.mean.back().indentation, each, 1e-12 * each);
  double sum = 0, wanted = 0;
  for (const TransientSample& part : table.mean) sum += part.mu / 400;
  for (const auto& rows : table.lines) {
    double last = 0;
    for (const TransientSample& row : rows) {
      wanted += row.mu * (row.time - last) / scene.sliding.duration / 3;
      last = row.time;
    }
  }
  EXPECT_NEAR(sum / wanted, 1, 0.01);  // steps do not end where parts do
}

TEST(MotionTable, IsTheSameWithAnyThreads) {
  MotionOptions one, two;
  one.lines = two.lines = 3;
  one.threads = 1;
  two.threads = 2;
  const Scene scene = someMotion(SlidingKind::Step);
  EXPECT_EQ(motionJson(scene, marchMotion(scene, one)), motionJson(scene, marchMotion(scene, two)));
}

TEST(MotionTable, LocalFrictionStandsApartAndIsUnknownAtRest) {
  Scene scene = someMotion(SlidingKind::Step);
  scene.interface.frictionCoefficient = 0.3;
  int resting = 0;
  for (const Row& row : rowsOf(scene)) {
    if (row.at("velocity") == 0) {
      ++resting;
      EXPECT_TRUE(std::isnan(row.at("mu_interface")));
    } else {
      EXPECT_EQ(row.at("mu_interface"), 0.3);
    }
  }
  EXPECT_GT(resting, 100);
}

TEST(MotionTable, StatesItsError) {
  const Scene scene = someMotion(SlidingKind::Step);
  const MotionTable table = marchMotion(scene, {});
  EXPECT_GT(table.relativeError, 1e-3);
  EXPECT_LT(table.relativeError, 0.2);
  const auto made = motionProvenance("motion", scene, table);
  EXPECT_EQ(made["discretization_error"]["mu"], table.muError);
  EXPECT_EQ(made["options"]["every"], 1);
}

TEST(MotionTable, TellsItsStepsAndStops) {
  const Scene scene = someMotion(SlidingKind::Step);
  MotionOptions options;
  options.lines = 2;
  std::int64_t done = 0, total = 0;
  options.progress = [&](std::int64_t now, std::int64_t all) {
    EXPECT_GE(now, done);
    done = now;
    total = all;
  };
  marchMotion(scene, options);
  EXPECT_EQ(done, total);
  std::stop_source source;
  options.stop = source.get_token();
  options.progress = [&](std::int64_t, std::int64_t) { source.request_stop(); };
  EXPECT_THROW(marchMotion(scene, options), StopRequested);
}

/// The steps of a long line take long: each few of them are told.
TEST(MotionTable, TellsEachStepOfALongLine) {
  Scene scene = someMotion(SlidingKind::Start);
  scene.surface.elements = 1 << 14;
  scene.accuracy.oversampling = 4;
  std::vector<std::int64_t> told;
  MotionOptions options;
  std::stop_source source;
  options.stop = source.get_token();
  options.progress = [&](std::int64_t done, std::int64_t) {
    told.push_back(done);
    if (told.size() == 3) source.request_stop();
  };
  EXPECT_THROW(marchMotion(scene, options), StopRequested);
  ASSERT_GE(told.size(), 3U);
  EXPECT_EQ(told[0], 0);  // the line is prepared
  EXPECT_LE(told[1], 31);
  EXPECT_LE(told[2] - told[1], 31);
}

/// With a target accuracy rows are drawn with replacement; a motion still has each of them once.
TEST(MotionTable, TheLinesOfATargetAreDifferentRows) {
  std::ostringstream matrix;
  matrix << "# Channel: Topo\n# Width: 100 \u00B5m\n# Height: 4 \u00B5m\n# Value units: m\n";
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 100; ++i)
      matrix << 1e-7 * (row + 1) * std::sin(0.21 * i + row) << (i == 99 ? "\n" : "\t");
  const TemporaryFolder folder;
  Scene scene = someMotion(SlidingKind::Start);
  scene.surface = {};
  scene.surface.kind = SurfaceKind::Measured;
  scene.surface.file = folder.write("rows.txt", matrix.str()).string();
  scene.surface.length = 0;
  scene.surface.elements = 0;
  scene.accuracy = {};
  scene.accuracy.targetRelativeError = 0.05;
  scene.ensemble.realizations = 0;
  scene.sliding.duration = 1e-4;
  MotionOptions options;
  options.lines = 4;
  std::set<double> depths;
  for (const std::vector<TransientSample>& line : marchMotion(scene, options).lines)
    depths.insert(line.back().indentation);
  EXPECT_EQ(depths.size(), 4U);
}

/// A line written to a file and read as a profile or as a measured surface is as accurate as the
/// line itself, and the provenance says with how many points.
TEST(MotionTable, ALineFromAFileHasThePointsOfTheLineItself) {
  Scene scene = someMotion(SlidingKind::Start);
  scene.surface = {};
  scene.surface.elements = 100;
  scene.surface.length = 1e-3;
  scene.accuracy = {};
  scene.sliding.velocity = 0.01;
  scene.sliding.duration = 0.02;
  const TemporaryFolder folder;
  folder.write("line.csv", lineCsv(LineSource(scene, 1).make(0)));
  Scene fromFile = scene;
  fromFile.folder = folder.path();
  fromFile.surface = {};
  fromFile.surface.kind = SurfaceKind::Profile;
  fromFile.surface.file = "line.csv";
  fromFile.surface.length = 0;
  fromFile.surface.elements = 0;
  Scene measured = fromFile;
  measured.surface.kind = SurfaceKind::Measured;
  measured.surface.processing.form = FormRemoval::None;
  measured.surface.processing.seam = Seam::Periodic;
  measured.surface.contactSide = ContactSide::Valleys;
  measured.ensemble.realizations = 0;
  const MotionTable own = marchMotion(scene, {});
  EXPECT_EQ(linePoints(scene), 32);
  for (const Scene& other : {fromFile, measured}) {
    EXPECT_EQ(linePoints(other), 32);
    const MotionTable table = marchMotion(other, {});
    EXPECT_EQ(motionProvenance("motion", other, table)["oversampling_used"], 32);
    ASSERT_EQ(table.lines[0].size(), own.lines[0].size());
    EXPECT_NEAR(table.lines[0].back().mu, own.lines[0].back().mu, 1e-6 * own.lines[0].back().mu);
  }
}

TEST(MotionTable, RefusesWhatItCannotDo) {
  EXPECT_THROW(marchMotion(someMotion(SlidingKind::Steady), {}), InputError);
  Scene parabola = someMotion(SlidingKind::Start);
  parabola.surface.kind = SurfaceKind::Parabola;
  MotionOptions options;
  options.lines = 2;
  EXPECT_THROW(marchMotion(parabola, options), InputError);
  Scene endless = someMotion(SlidingKind::Start);
  endless.sliding.duration = 1e6;
  EXPECT_THROW(marchMotion(endless, {}), InputError);
}

}  // namespace
}  // namespace asperity
