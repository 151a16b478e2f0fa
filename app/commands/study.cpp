// asperity study: many simulations of one scene over a space of its keys, kept in a store that
// survives the end of its processes, merged, written as a table, analysed.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>

#include "app/command_line.h"
#include "app/output.h"
#include "app/progress_bar.h"
#include "app/result_files.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/named_choices.h"
#include "core/scene/provenance.h"
#include "core/study/study_report.h"
#include "core/study/study_run.h"
#include "core/study/study_table.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"
#include "ui/language/language.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr NamedChoices<TableShape, 2> kShapes{
    {{"wide", TableShape::Wide}, {"long", TableShape::Long}}};

/// Returns an approximate duration: "40 s", "12 min", "3.5 h", "2 d".
std::string durationText(double seconds) {
  struct Unit {
    double seconds;
    const char* name;
  };
  for (const Unit& unit : {Unit{86400, "d"}, Unit{3600, "h"}, Unit{60, "min"}})
    if (seconds >= 2 * unit.seconds)
      return answerNumber(seconds / unit.seconds, 2) + " " + unit.name;
  return answerNumber(std::max(seconds, 0.1), 2) + " s";
}

ParameterStudy loadStudy(const StudyCommand& command) {
  return readStudy(command.study, readNamedScene);
}

Json header(const ParameterStudy& study) {
  return {{"schema", "asperity-study-answer/1"},
          {"verb", "study"},
          {"version", ASPERITY_VERSION},
          {"study_sha256", study.digest}};
}

// ---- run

/// Shows how many simulations are done, and how long the rest will take at the present rate.
class StudyProgress {
 public:
  StudyProgress(std::int64_t before, std::int64_t total, bool quiet)
      : bar_(Words::tr("simulations"), quiet), before_(before), total_(total) {}

  void show(std::int64_t done) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const auto added = static_cast<double>(done - before_);
    const double left = elapsed.count() / added * static_cast<double>(total_ - done);
    bar_.show(done, total_,
              done < total_ ? filled(Words::tr("%1 left"), {durationText(left)}) : std::string());
  }

 private:
  ProgressBar bar_;
  std::int64_t before_, total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string planText(const StudyBudget& budget) {
  std::string text =
      filledLine(Words::tr("%1 simulations of %2 states on %3 lines each, in chunks of %4"),
                 budget.simulations, budget.states / std::max<std::int64_t>(1, budget.simulations),
                 budget.lines, budget.chunk);
  if (budget.done > 0) text += filledLine(Words::tr("%1 of them are done"), budget.done);
  text += filledLine(Words::tr("about %1 on %2 threads, by a trial of %3 simulations"),
                     durationText(budget.seconds), budget.threads, budget.trial);
  if (budget.trialFailures > 0)
    text += filledLine(Words::tr("%1 of the trial cannot be computed"), budget.trialFailures);
  text += filledLine(Words::tr("about %1 MB in the store"), answerNumber(budget.bytes / 1e6, 2));
  return text;
}

Json planJson(const ParameterStudy& study, const StudyBudget& budget) {
  Json answer = header(study);
  answer["simulations"] = budget.simulations;
  answer["done"] = budget.done;
  answer["states"] = budget.states;
  answer["lines"] = budget.lines;
  answer["chunk"] = budget.chunk;
  answer["chunks"] = budget.chunks;
  answer["seconds"] = budget.seconds;
  answer["threads"] = budget.threads;
  answer["trial"] = budget.trial;
  answer["trial_failures"] = budget.trialFailures;
  answer["bytes"] = budget.bytes;
  return answer;
}

/// Returns how the surface of the base scene is read; nothing where only a simulation's own values
/// make it readable.
std::vector<Message> readingFactsOfBase(const ParameterStudy& study) {
  try {
    return readingFacts(study.base);
  } catch (const InputError&) {
    return {};
  }
}

int plan(const StudyCommand& command, const ParameterStudy& study, const Shard& shard) {
  std::int64_t done = 0;
  std::error_code ignored;
  if (!command.output.empty() && std::filesystem::exists(command.output, ignored)) {
    const StudyStore store(command.output);
    if (store.study().digest == study.digest) done = store.simulationsDone();
  }
  const StudyBudget budget =
      studyBudget(study, shard.simulations(study), done, command.common.threads);
  const std::vector<Message> reading = readingFactsOfBase(study);
  printSummary(command.common, planText(budget) + translatedLines(reading));
  if (command.common.json) {
    Json answer = planJson(study, budget);
    addReadingFacts(answer, reading);
    printJson(answer);
  }
  return kDone;
}

/// Throws InputError where a page or a chunk of the store is damaged: what is computed into it
/// could not be read again.
void checkReadable(const StudyStore& store) {
  store.check();
  store.eachChunk([](const StudyChunk&) { return true; });
}

std::string stateText(const StudyStore& store, std::int64_t added, std::int64_t total) {
  const std::int64_t done = store.simulationsDone();
  std::string text =
      filledLine(Words::tr("%1 of %2 simulations done, %3 of them now"), done, total, added);
  if (done < total) text += Words::tr("other processes work on the rest") + "\n";
  return text;
}

/// Says that simulations failed: as a part of the summary where that is allowed, else as an error.
/// Returns the exit status.
int reportFailures(const StudyCommand& command) {
  if (command.allowsFailures) {
    printSummary(command.common,
                 Words::tr("some simulations failed: 'asperity study show' says why") + "\n");
    return kDone;
  }
  printError(message("{}: some simulations failed: 'asperity study show' says why; "
                     "--allow-failures accepts them",
                     command.output)
                 .english());
  return kRunFailed;
}

// ---- show

struct FailureCount {
  std::int64_t count = 0, first = 0;
};

/// Returns the number of occurrences of each message, for the first messages, and in `all` the
/// number of failures.
std::map<std::string, FailureCount> countFailures(const StudyStore& store, std::int64_t& all) {
  constexpr std::size_t kMax = 1000;
  std::map<std::string, FailureCount> failures;
  store.eachChunk([&](const StudyChunk& chunk) {
    for (const StudyFailure& failure : chunk.failures) {
      ++all;
      const auto found = failures.find(failure.message);
      if (found != failures.end())
        ++found->second.count;
      else if (failures.size() < kMax)
        failures[failure.message] = {1, failure.simulation};
    }
    return true;
  });
  return failures;
}

// ---- merge

std::string missingText(const MergedStores& merged, const ParameterStudy& study) {
  std::string shards, ranges;
  for (const Shard& shard : merged.missingShards)
    shards += fmt::format("{}{}/{}", shards.empty() ? "" : ", ", shard.number, shard.count);
  for (const std::int64_t chunk : merged.missingChunks)
    ranges += fmt::format("{}{}-{}", ranges.empty() ? "" : ", ", chunk * study.chunk,
                          chunk * study.chunk + study.sizeOfChunk(chunk) - 1);
  const std::int64_t missing = merged.chunksPlanned - merged.chunks;
  if (missing > static_cast<std::int64_t>(merged.missingChunks.size())) ranges += ", ...";
  return message("{} of {} chunks are missing (simulations {}){}", missing, merged.chunksPlanned,
                 ranges,
                 shards.empty() ? Message("") : message("; no store is of shard {}", shards))
      .english();
}

}  // namespace

int runStudyRun(const StudyCommand& command) {
  const ParameterStudy study = loadStudy(command);
  const Shard shard = command.shard.empty() ? Shard{} : parseShard(command.shard);
  if (command.plan) return plan(command, study, shard);
  if (command.output.empty())
    throw InputError("", "--output", "is missing; a study needs a store, unless --plan is given");
  checkNoInput(command.output, {command.study});
  checkNoInput(command.output, filesReadBy(study.base));
  StudyStore store(command.output, study, shard);
  checkReadable(store);
  const std::int64_t total = shard.simulations(study), before = store.simulationsDone();
  if (!command.common.quiet && before < total) {
    constexpr double kTrial = 0.1;  // s; a study of less time is simply run
    const StudyBudget budget = studyBudget(study, total, before, command.common.threads, kTrial);
    if (budget.seconds > 10 * kTrial) std::fputs(planText(budget).c_str(), stderr);
  }
  StudyRunOptions options;
  options.threads = command.common.threads;
  std::int64_t added = 0;
  {
    StudyProgress progress(before, total, command.common.quiet);
    options.progress = [&](std::int64_t done) { progress.show(std::min(done, total)); };
    added = runStudy(store, options);
  }
  if (added > 0) checkReadable(store);
  const std::vector<Message> reading = readingFactsOfBase(study);
  printSummary(command.common, stateText(store, added, total) + translatedLines(reading));
  if (command.common.json) {
    Json answer = header(study);
    answer["simulations"] = total;
    answer["done"] = store.simulationsDone();
    answer["added"] = added;
    answer["has_failures"] = store.hasFailures();
    addReadingFacts(answer, reading);
    printJson(answer);
  }
  return store.hasFailures() ? reportFailures(command) : kDone;
}

int runStudyMerge(const StudyCommand& command) {
  std::vector<std::filesystem::path> inputs(command.stores.begin(), command.stores.end());
  const MergedStores merged = mergeStores(inputs, command.output);
  const StudyStore store(command.output);
  if (command.common.json) {
    Json answer = header(store.study());
    answer["chunks"] = merged.chunks;
    answer["chunks_wanted"] = merged.chunksPlanned;
    Json& missing = answer["missing_shards"] = Json::array();
    for (const Shard& shard : merged.missingShards)
      missing.push_back(fmt::format("{}/{}", shard.number, shard.count));
    printJson(answer);
  }
  if (!merged.isWhole())
    throw TextError(Message::name(missingText(merged, store.study())), {command.output});
  printSummary(command.common, filledLine(Words::tr("%1 simulations"), store.simulationsDone()) +
                                   wroteLine(command.output));
  return kDone;
}

int runStudyTable(const StudyCommand& command) {
  const StudyStore store(command.study);
  const TableShape shape = chosen(kShapes, command.shape, "--shape");
  const bool isStdout = command.outputs.empty();
  checkOutputs(command.outputs, {".csv", ".json"}, DefaultOutput::PrintsTable);
  for (const std::string& output : command.outputs) checkNoInput(output, {command.study});
  std::int64_t rows = 0;
  const ProvenanceOptions given(optionsFor(command.common.given, ".csv"));
  const auto print = [](std::string_view bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
  };
  for (const std::string& output : command.outputs) {
    if (output == "-") {
      rows = writeStudyTable(store, shape, TableFormat::Csv, print);
      continue;
    }
    AtomicFile file(output);
    rows = writeStudyTable(store, shape,
                           fileExtension(output) == ".json" ? TableFormat::Json : TableFormat::Csv,
                           [&](std::string_view bytes) { file.write(bytes); });
    file.commit();
  }
  if (isStdout || command.common.json)
    rows = writeStudyTable(store, shape, command.common.json ? TableFormat::Json : TableFormat::Csv,
                           print);
  const std::int64_t all = store.study().simulations();
  if (rows < all)
    printError(message("{}: {} of {} simulations are not there yet", command.study, all - rows, all)
                   .english());
  if (!isStdout) {
    printSummary(command.common,
                 filledLine(Words::tr("%1 simulations"), rows) + wroteLines(command.outputs),
                 hasStandardOutput(command.outputs));
  }
  return kDone;
}

int runStudyShow(const StudyCommand& command) {
  const StudyStore store(command.study);
  store.check();
  const ParameterStudy& study = store.study();
  const std::int64_t total = store.shard().simulations(study), done = store.simulationsDone();
  const double seconds = store.secondsSpent();
  std::int64_t failed = 0;
  const std::map<std::string, FailureCount> failures = countFailures(store, failed);
  if (command.common.json) {
    Json answer = header(study);
    answer["title"] = study.title;
    if (!store.shard().isWhole())
      answer["shard"] = fmt::format("{}/{}", store.shard().number, store.shard().count);
    answer["simulations"] = total;
    answer["done"] = done;
    answer["chunk"] = study.chunk;
    answer["failed"] = failed;
    answer["processor_seconds"] = seconds;
    answer["study"] = jsonValue(study.canonical);
    Json& list = answer["failures"] = Json::array();
    for (const auto& [text, count] : failures)
      list.push_back({{"message", text}, {"count", count.count}, {"first", count.first}});
    printJson(answer);
  }
  std::string text = study.title.empty() ? "" : study.title + "\n";
  if (!store.shard().isWhole())
    text += filledLine(Words::tr("shard %1 of %2"), store.shard().number, store.shard().count);
  text += filledLine(Words::tr("%1 of %2 simulations done"), done, total);
  if (done > 0 && seconds > 0)
    text += filledLine(Words::tr("%1 simulations a second on one thread"),
                       answerNumber(static_cast<double>(done) / seconds, 3));
  if (done < total && done > 0)
    text += filledLine(
        Words::tr("the rest takes about %1 of one thread"),
        durationText(seconds / static_cast<double>(done) * static_cast<double>(total - done)));
  if (failed > 0) text += filledLine(Words::tr("%1 simulations failed:"), failed);
  for (const auto& [why, count] : failures)
    text += filledLine(Words::tr("  %1 times, first %2: %3"), count.count, count.first, why);
  printSummary(command.common, text);
  return kDone;
}

int runStudyAnalyse(const StudyCommand& command) {
  const PictureSettings settings = pictureSettings(command.picture);
  OutputFolder output(command.output, {command.study}, settings);
  const StudyStore store(command.study);
  const ParameterStudy& study = store.study();
  if (store.chunksDone() == 0)
    throw InputError(command.study, "", "has no result yet; 'asperity study run' computes them");
  const StudyAnalysis analysis = analyseStudy(store);
  const auto origin = [&store] { return studyProvenance(store); };
  const auto fileOrigin = [&](const char* name) {
    const ProvenanceOptions given(optionsInFolder(command.common.given, name));
    return origin();
  };
  Json answer = fileOrigin("analysis.json");
  answer["analysis"] = analysisJson(study, analysis);
  output.addText("analysis.json", jsonFile(answer));
  const auto addTable = [&](const char* name, const std::string& csv) {
    output.addText(name, provenanceComment(fileOrigin(name)) + csv);
  };
  if (!analysis.outputs.empty()) {
    addTable("sensitivity.csv", indicesCsv(study, analysis));
    addTable("effects.csv", effectsCsv(study, analysis));
  }
  addTable("percentiles.csv", percentilesCsv(analysis));
  for (NamedSheet& sheet : studySheets(study, analysis)) output.addSheet(std::move(sheet));
  output.write(command.common.given, origin);
  std::string text =
      filledLine(Words::tr("%1 of %2 simulations"), analysis.simulations, study.simulations());
  for (const OutputAnalysis& one : analysis.outputs) {
    for (const SobolIndex& index : one.indices)
      text += filledLine(Words::tr("%1, %2: first order %3, total %4"), one.name,
                         axisName(study.space.axes()[index.axis]),
                         answerNumber(index.first.value, 2), answerNumber(index.total.value, 2));
    if (one.failed > 0)
      text += filledLine(Words::tr("%1: %2 simulations without a number are left out"), one.name,
                         one.failed);
  }
  if (study.space.sampling() != Sampling::Saltelli)
    text += Words::tr("no Sobol indices: they need sampling saltelli") + "\n";
  printSummary(command.common, text + output.summary());
  if (command.common.json) printJson(answer);
  return kDone;
}

}  // namespace asperity
