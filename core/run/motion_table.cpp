#include "core/run/motion_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <utility>
#include <variant>

#include "core/base/input_error.h"
#include "core/base/jobs.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/chart/curve_words.h"
#include "core/friction/curve_file.h"
#include "core/run/rigid_line.h"
#include "core/run/transient.h"
#include "core/run/transient_diagram.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMaxRows = 5e6;      // of all lines
constexpr std::int64_t kParts = 400;  // parts of a motion's duration in its picture
constexpr double kWorkToTell = 2e6;   // steps times nodes between two calls of `progress`

/// Returns the number with 15 digits, the accuracy of a sum of steps, so that 0.5 is not
/// 0.49999999999999994.
double withoutRounding(double time) {
  double rounded = time;
  readNumber(fmt::format("{:.15g}", time), rounded);
  return rounded;
}

/// The columns in the order of the table, without the realization, which is the last one.
struct MotionColumn {
  ColumnName name;
  double (*value)(const TransientSample& row);
};
constexpr std::array<MotionColumn, 11> kMotionColumns{{
    {"time", [](const TransientSample& row) { return withoutRounding(row.time); }},
    {"displacement", [](const TransientSample& row) { return row.distance; }},
    {"velocity", [](const TransientSample& row) { return row.velocity; }},
    {"normal_force", [](const TransientSample& row) { return row.normalForce; }},
    {"tangential_force", [](const TransientSample& row) { return 0 - row.tangentialForce; }},
    {"mu", [](const TransientSample& row) { return row.mu; }},
    {"indentation", [](const TransientSample& row) { return row.indentation; }},
    {"contact_fraction", [](const TransientSample& row) { return row.contactFraction; }},
    {"contact_spots", [](const TransientSample& row) { return row.contactSpots; }},
    {"power_in",
     [](const TransientSample& row) { return row.tangentialForce * row.velocity + 0.0; }},
    {"power_dissipated", [](const TransientSample& row) { return row.powerDissipated; }},
}};
constexpr ColumnName kMuInterface = "mu_interface", kRealization = "realization";

std::vector<std::string> columnNames() {
  std::vector<std::string> names;
  for (const MotionColumn& column : kMotionColumns) names.push_back(column.name.text());
  names.push_back(kMuInterface.text());
  names.push_back(kRealization.text());
  return names;
}

/// Calls a function with the cells of every row, line after line. A table of millions of rows is
/// too long to keep all its cells.
template <class Function>
void forEachRow(const MotionTable& table, const Function& function) {
  for (std::size_t line = 0; line < table.lines.size(); ++line)
    for (const TransientSample& sample : table.lines[line]) {
      std::vector<TableCell> row;
      for (const MotionColumn& column : kMotionColumns) row.emplace_back(column.value(sample));
      const bool slides = table.hasInterface && sample.velocity != 0;
      row.emplace_back(slides ? sample.muInterface : kNotApplicable);
      row.emplace_back(static_cast<std::int64_t>(line));
      function(row);
    }
}

/// Computes means of single steps over parts of the duration, and sums of their errors.
class MotionMeans {
 public:
  explicit MotionMeans(double duration) : duration_(duration) {}

  void add(const TransientSample& row, double dt) {
    const auto at =
        static_cast<std::int64_t>(std::ceil(row.time / duration_ * kParts * (1 - 1e-9)));
    Part& part = parts_[static_cast<std::size_t>(std::clamp<std::int64_t>(at - 1, 0, kParts - 1))];
    part.time += dt;
    for (std::size_t i = 0; i < kMeans.size(); ++i) part.sums[i] += row.*kMeans[i] * dt;
    part.indentation = row.indentation;  // at its end
    if (!std::isfinite(row.muError)) return;
    ++part.errors;
    part.squares += row.muError * row.muError;
    errors_ += row.muError * row.muError;
    values_ += row.mu * row.mu;
    ++known_;
  }

  void add(const MotionMeans& other) {
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      Part& part = parts_[k];
      const Part& more = other.parts_[k];
      part.time += more.time;
      for (std::size_t i = 0; i < kMeans.size(); ++i) part.sums[i] += more.sums[i];
      part.indentation += more.indentation;
      part.errors += more.errors;
      part.squares += more.squares;
    }
    errors_ += other.errors_;
    values_ += other.values_;
    known_ += other.known_;
  }

  std::vector<TransientSample> means(std::int64_t lines) const {
    std::vector<TransientSample> means;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const Part& part = parts_[k];
      if (!(part.time > 0)) continue;
      TransientSample sample;
      sample.time = duration_ * static_cast<double>(k + 1) / kParts;
      for (std::size_t i = 0; i < kMeans.size(); ++i) sample.*kMeans[i] = part.sums[i] / part.time;
      sample.indentation = part.indentation / static_cast<double>(lines);
      if (part.errors > 0) sample.muError = std::sqrt(part.squares / part.errors);
      means.push_back(sample);
    }
    return means;
  }

  double error() const { return known_ > 0 ? std::sqrt(errors_ / known_) : kNotApplicable; }
  double relativeError() const {
    return values_ > 0 ? std::sqrt(errors_ / values_) : kNotApplicable;
  }

 private:
  static constexpr std::array<double TransientSample::*, 5> kMeans{
      &TransientSample::velocity, &TransientSample::mu, &TransientSample::contactFraction,
      &TransientSample::contactLength, &TransientSample::predictedRate};
  struct Part {
    double time = 0, indentation = 0, errors = 0, squares = 0;
    std::array<double, kMeans.size()> sums{};
  };

  double duration_;
  std::array<Part, kParts> parts_{};
  double errors_ = 0, values_ = 0, known_ = 0;
};

/// Keeps the lowest and the highest value of every part of a motion, in the order in which they
/// occurred: a picture of them shows the peaks of all steps, however many there are.
class MotionEnvelope {
 public:
  explicit MotionEnvelope(double duration) : duration_(duration) {}

  void add(const TransientSample& row) {
    const auto at = static_cast<std::int64_t>(row.time / duration_ * kStrokes);
    Part& part = parts_[static_cast<std::size_t>(std::clamp<std::int64_t>(at, 0, kStrokes - 1))];
    if (part.steps++ == 0) part.first = row.time;
    part.last = row.time;
    for (std::size_t i = 0; i < kDrawn.size(); ++i) {
      const double value = row.*kDrawn[i];
      if (!std::isfinite(value)) continue;
      Extremes& known = part.extremes[i];
      if (value < known.low) known = {value, known.high, false};
      if (value > known.high) known = {known.low, value, true};
    }
    if (std::isfinite(row.muError)) part.muError = std::max(part.muError, row.muError);
  }

  /// Returns one sample for a part with one step, two for others.
  std::vector<TransientSample> samples() const {
    std::vector<TransientSample> samples;
    for (const Part& part : parts_)
      for (int end = 0; end < std::min(part.steps, 2); ++end) {
        TransientSample& sample = samples.emplace_back();
        sample.time = end == 0 ? part.first : part.last;
        for (std::size_t i = 0; i < kDrawn.size(); ++i) {
          const Extremes& known = part.extremes[i];
          if (known.low > known.high) continue;  // never known
          const bool isHigh = known.isHighLast == (end == 1);
          sample.*kDrawn[i] = isHigh ? known.high : known.low;
        }
        if (part.muError > 0) sample.muError = part.muError;
      }
    return samples;
  }

 private:
  // more than the width of a usual picture in pixels
  static constexpr std::int64_t kStrokes = 1500;
  static constexpr std::array<double TransientSample::*, 6> kDrawn{
      &TransientSample::velocity,      &TransientSample::mu,
      &TransientSample::indentation,   &TransientSample::contactFraction,
      &TransientSample::contactLength, &TransientSample::predictedRate};
  struct Extremes {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    bool isHighLast = true;
  };
  struct Part {
    int steps = 0;
    double first = 0, last = 0, muError = 0;
    std::array<Extremes, kDrawn.size()> extremes{};
  };

  double duration_;
  std::vector<Part> parts_ = std::vector<Part>(kStrokes);
};

/// Reports the steps of all lines from any marching thread.
class StepCounter {
 public:
  StepCounter(const MotionOptions& options, std::int64_t total)
      : options_(options), total_(total) {}

  void add(std::int64_t steps) {
    const std::scoped_lock guard(lock_);
    done_ += steps;
    if (options_.progress) options_.progress(std::min(done_, total_), total_);
  }

 private:
  const MotionOptions& options_;
  std::int64_t total_, done_ = 0;
  std::mutex lock_;
};

/// Marches every step of one line.
void marchLine(Transient transient, std::int64_t every, const MotionOptions& options,
               StepCounter& counter, std::vector<TransientSample>& rows, MotionMeans& means,
               MotionEnvelope* envelope) {
  double before = 0;
  const double nodes = static_cast<double>(transient.march().line().nodes());
  const auto stepsToTell = static_cast<std::int64_t>(std::clamp(kWorkToTell / nodes, 1.0, 256.0));
  std::int64_t untold = 0;
  counter.add(0);  // the line is prepared
  for (std::int64_t step = 1; !transient.isOver(); ++step) {
    if (options.stop.stop_requested()) return;
    const TransientSample row = transient.singleStep();
    means.add(row, row.time - before);
    if (envelope) envelope->add(row);
    before = row.time;
    if (step % every == 0 || transient.isOver()) rows.push_back(row);
    if (++untold < stepsToTell && !transient.isOver()) continue;
    counter.add(untold);
    untold = 0;
  }
}

/// Returns the realizations of the first different lines: with a target accuracy rows of a
/// topography are drawn with replacement.
std::vector<std::int64_t> differentLines(const Scene& scene, std::int64_t lines) {
  std::vector<std::int64_t> realizations{0};
  if (lines < 2) return realizations;
  const LineSource source(scene, 1);
  source.requireLines(lines, "--lines");
  std::set<std::int64_t> rows{source.rowOf(0)};
  for (std::int64_t next = 1; std::ssize(realizations) < lines; ++next)
    if (!source.hasRows() || rows.insert(source.rowOf(next)).second) realizations.push_back(next);
  return realizations;
}

}  // namespace

MotionTable marchMotion(const Scene& scene, const MotionOptions& options) {
  requireMotion(scene, Message::name("asperity motion"));
  const std::vector<std::int64_t> realizations = differentLines(scene, options.lines);
  const auto first = std::make_shared<const RigidLine>(scene);
  Transient beginning(scene, first);
  const double steps = beginning.countSteps();
  MotionTable table;
  table.every = options.every;
  if (options.mostRows > 0)
    table.every = std::max(
        table.every,
        static_cast<std::int64_t>(std::ceil(steps / static_cast<double>(options.mostRows))));
  const double lines = static_cast<double>(options.lines);
  if (const double rows = lines * steps / static_cast<double>(table.every); rows > kMaxRows)
    throw InputError(
        "", "--every",
        message("{} time steps would give {} rows, more than {}; each {}th step gives fewer",
                printed(steps), printed(rows), printed(kMaxRows),
                printed(std::ceil(lines * steps / kMaxRows))));
  table.spacing = first->line->spacing;
  table.length = first->line->length;
  table.hasInterface = hasLocalFriction(scene);
  table.lines.resize(static_cast<std::size_t>(options.lines));
  std::vector<MotionMeans> means(table.lines.size(), MotionMeans(scene.sliding.duration));
  MotionEnvelope envelope(scene.sliding.duration);  // of a line that is drawn alone
  StepCounter counter(options, options.lines * static_cast<std::int64_t>(steps));
  Jobs(options.threads).run(options.lines, [&](std::int64_t line) {
    if (options.stop.stop_requested()) return;
    const auto index = static_cast<std::size_t>(line);
    Transient transient =
        line == 0 ? beginning
                  : Transient(scene, std::make_shared<const RigidLine>(scene, realizations[index]));
    counter.add(0);  // making the coarser lines takes long, too
    transient.estimateErrors(scene);
    marchLine(std::move(transient), table.every, options, counter, table.lines[index], means[index],
              options.lines == 1 ? &envelope : nullptr);
  });
  throwIfStopped(options.stop);
  for (std::size_t i = 1; i < means.size(); ++i) means[0].add(means[i]);
  table.mean = means[0].means(options.lines);
  table.drawn = options.lines == 1 ? envelope.samples() : table.mean;
  table.muError = means[0].error();
  table.relativeError = means[0].relativeError();
  return table;
}

std::vector<MotionValues> motionColumns(const MotionTable& table) {
  std::vector<MotionValues> columns;
  for (std::string& name : columnNames()) columns.push_back({std::move(name), {}});
  columns.pop_back();  // the realization
  forEachRow(table, [&](const std::vector<TableCell>& row) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      columns[i].values.push_back(std::get<double>(row[i]));
  });
  return columns;
}

std::string motionCsv(const MotionTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(columnNames(), ","));
  forEachRow(table, [&](const std::vector<TableCell>& row) { text += csvLine(row); });
  return text;
}

Json motionProvenance(const std::string& verb, const Scene& scene, const MotionTable& table) {
  Json root = lineProvenance(verb, scene);
  // They stand at the end, so that their position does not depend on how they were given.
  for (const char* own : {"every", "lines"})
    if (root.contains("options")) root["options"].erase(own);
  root["options"]["every"] = table.every;
  root["options"]["lines"] = table.lines.size();
  root["discretization_error"] = {{"mu", numberOrNull(table.muError)},
                                  {"relative", numberOrNull(table.relativeError)}};
  return root;
}

std::string motionJson(const Scene& scene, const MotionTable& table) {
  Json rows = Json::array();
  const std::vector<std::string> names = columnNames();
  forEachRow(table,
             [&](const std::vector<TableCell>& row) { rows.push_back(jsonObject(names, row)); });
  Json root = motionProvenance("motion", scene, table);
  root["points"] = std::move(rows);
  return jsonFile(root);
}

DiagramSheet motionSheet(const Scene& scene, const MotionTable& table) {
  DiagramSheet sheet = transientSheet(scene, table.drawn, table.spacing, table.length);
  sheet.diagrams.push_back(contactStrip(scene, table.drawn));
  sheet.title = scene.title;
  sheet.subtitle = describeParameters(scene);
  std::vector<Message> notes;
  if (table.lines.size() > 1) notes.push_back(message("Mean of {} lines.", table.lines.size()));
  if (std::isfinite(table.muError))
    notes.push_back(message("Band: estimated error of elements and time steps, {} in \u03BC.",
                            printed(table.muError, 2)));
  const bool hasGuide = std::ranges::any_of(sheet.diagrams[1].series, &DiagramSeries::isTheory);
  if (hasGuide) notes.push_back(sheet.note);
  sheet.note = sentences(notes);
  return sheet;
}

}  // namespace asperity
