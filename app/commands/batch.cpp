// asperity batch: runs many scenes and sweeps; writes pictures, data and a page with all of them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "app/batch/batch_file.h"
#include "app/batch/batch_page.h"
#include "app/batch/batch_progress.h"
#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/frame_source.h"
#include "app/pictures/headless_pictures.h"
#include "app/pictures/picture_composer.h"
#include "app/progress_bar.h"
#include "core/accuracy/compute_curve.h"
#include "core/accuracy/target_curve.h"
#include "core/base/atomic_file.h"
#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/chart/curve_set.h"
#include "core/friction/curve_file.h"
#include "core/run/motion_table.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_files.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/shapes.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// Maximum number of rows in the table of a motion.
constexpr std::int64_t kMotionRows = 2000;

/// Number of scenes above which contact sheets are made only on request.
constexpr std::size_t kMaxScenesOnSheets = 100;

/// Returns the mean over the scene's lines at its own velocity. It is empty for a motion, and for a
/// line at rest.
std::optional<Curve> computeMean(const Scene& scene, const CurveOptions& options) {
  if (scene.sliding.kind != SlidingKind::Steady || !(scene.sliding.velocity > 0))
    return std::nullopt;
  return computeCurveAt(scene, scene.sliding.velocity, options);
}

class BatchRun {
 public:
  explicit BatchRun(const BatchCommand& command)
      : command_(command), batch_(withSceneContext(command.common, [&] {
          return command.common.remade ? restoreBatch(*command.common.remade)
                                       : readBatch(command.common.scene);
        })) {
    settings_ = readSettings();
    columns_ = ColumnChoice(command.columns, {"batch"});
    const bool hasChart = std::ranges::any_of(
        batch_.items, [](const BatchItem& item) { return item.show != "contact"; });
    if (!hasChart)
      refuseChartOptions(command.picture,
                         "applies only to charts, and no entry of the batch shows one");
    if (batch_.items.size() <= kMaxScenesOnSheets || command.contactSheet) makeSheets();
    makeFolder(command.output);
    progress_.emplace(command.output);
    checkWritable(fileIn("index.html"));
    checkInputs();
  }

  int run() {
    HeadlessPictures pictures(settings_.backend);
    {
      ProgressBar bar(Words::tr("scenes"), command_.common.quiet);
      const auto total = static_cast<std::int64_t>(batch_.items.size());
      for (const BatchItem& item : batch_.items) {
        results_.push_back(runItem(item, pictures));
        noteProgress();
        bar.show(static_cast<std::int64_t>(results_.size()), total);
      }
    }
    finishPictures(pictures);
    // The small files with the results are written first: the sheets are large, and may fail.
    const std::string made = provenanceComment(origin("results.csv"));
    const std::vector<std::string> names = grid_ ? grid_->names() : std::vector<std::string>();
    writeFileAtomically(fileIn("results.csv"),
                        made + columns_.select(tableCsv(batchTable(results_))));
    writeFileAtomically(fileIn("index.html"), batchPage(batch_, results_, names));
    // The provenance of the table has the scenes; a single contact sheet repeats them.
    const std::string ofSheets =
        provenanceLine(sheets_.size() == 1 ? origin(names[0]) : referenceHeader("results.csv"));
    for (std::size_t i = 0; i < sheets_.size(); ++i)
      pictures.write(fileIn(names[i]), sheets_[i], {batch_.title, ofSheets, settings_.scale});
    pictures.finish();
    if (std::ranges::all_of(results_,
                            [](const BatchResult& result) { return result.fault().empty(); }))
      progress_->remove();
    return report();
  }

 private:
  void makeSheets() {
    grid_.emplace(static_cast<int>(batch_.items.size()), settings_.width, settings_.height);
    small_ = settings_;
    small_.width = grid_->cellWidth();
    small_.height = grid_->cellHeight();
    small_.scale = 0.5F;
    for (int i = 0; i < grid_->sheets(); ++i) {
      DrawList& sheet = sheets_.emplace_back();
      sheet.width = grid_->widthOf(i);
      sheet.height = grid_->heightOf(i);
      sheet.background = settings_.theme.background;
    }
  }

  std::string fileIn(const std::string& name) const {
    return asperity::fileIn(command_.output, name);
  }

  /// Throws where an output would replace a file from which the batch is read.
  void checkInputs() const {
    std::error_code missing;  // a file that does not exist cannot be replaced
    std::set<std::filesystem::path> inputs{
        std::filesystem::canonical(command_.common.scene, missing)};
    for (const BatchItem& item : batch_.items)
      for (const std::filesystem::path& input : item.inputs)
        inputs.insert(std::filesystem::canonical(input, missing));
    inputs.erase(std::filesystem::path());
    const auto check = [&](const std::string& name) {
      const std::filesystem::path present = std::filesystem::canonical(fileIn(name), missing);
      if (inputs.contains(present)) checkNoInput(fileIn(name), {present});
    };
    for (const BatchItem& item : batch_.items)
      for (const std::string& name : outputFiles(item)) check(name);
    if (grid_)
      for (const std::string& name : grid_->names()) check(name);
    check("results.csv");
  }

  /// Records the scene before the last one: the picture of the last one is still being written.
  void noteProgress() {
    if (written_) progress_->add(written_->first, written_->second);
    written_ = std::exchange(finished_, std::nullopt);
  }

  /// Waits for the last picture, whose writing may fail after its scene has been finished.
  void finishPictures(HeadlessPictures& pictures) {
    try {
      pictures.finish();
    } catch (const std::runtime_error& error) {
      results_.back().item.error = errorMessage(error);
    }
  }

  /// Reads the settings of pictures. An error in a size that the batch file gives names that file.
  PictureSettings readSettings() const {
    PictureArguments arguments = command_.picture;
    const bool isOfFile = arguments.size.empty();
    if (isOfFile) arguments.size = batch_.size;
    try {
      return pictureSettings(arguments);
    } catch (const InputError& error) {
      if (!isOfFile || error.key() != "--size") throw;
      throw InputError(command_.common.scene, "size", error.message());
    }
  }

  /// Runs one scene. An error belongs to that scene only; the other scenes go on.
  BatchResult runItem(const BatchItem& item, HeadlessPictures& pictures) {
    BatchResult result;
    result.item = item;
    try {
      if (item.error.empty()) completeItem(result, pictures);
    } catch (const InputError& error) {
      result.item.error = errorMessage(error);
    } catch (const std::runtime_error& error) {
      result.item.error = errorMessage(error);
    }
    if (!result.item.error.empty() && grid_) {
      const auto [sheet, left, top] = cell();
      addLabel(sheets_[sheet], filled(Words::tr("%1 failed"), {item.name}),
               {static_cast<float>(left + 16), static_cast<float>(top + 32)}, 16, TextAnchor::Left,
               settings_.theme.text);
    }
    return result;
  }

  /// Returns the cell of the next scene.
  ContactSheets::Cell cell() const { return grid_->cell(static_cast<int>(results_.size())); }

  /// Computes one scene and writes its files, unless an earlier run did, and puts its picture on
  /// the contact sheet.
  void completeItem(BatchResult& result, HeadlessPictures& pictures) {
    Scene shown = result.item.scene;  // with translated texts, as pictures show them
    shown.title = translated(result.item.title);
    PictureContent content{layoutFrom(result.item.show)};
    const std::string key = itemDigest(result.item);
    const BatchProgressEntry* const known = progress_->find(key);
    if (known) {
      BatchItem item = std::move(result.item);
      result = known->result;
      result.item = std::move(item);
    }
    result.reading = readingFacts(result.item.scene);
    const std::vector<FrictionData> measured = measuredFriction(result, content.layout);
    const std::vector<CurvePoint> curve =
        known ? known->curve : computeMeans(result, content.layout);
    if (known && !grid_) return;
    if (!curve.empty()) content.curves = curvesOf(shown, curve, measured);
    FrameSource source(shown, {}, true);
    const Frame frame = source.frame(0);
    if (!known) {
      result.lineMu = frame.state.mu;
      result.lineIndentation = frame.state.indentation;
      result.lineContactFraction = frame.state.contactFraction;
      write(result, shown, content, frame, pictures);
      if (result.missed.empty()) finished_.emplace(key, BatchProgressEntry{result, curve});
    }
    if (!grid_) return;
    const auto [sheet, left, top] = cell();
    addPicture(sheets_[sheet], PictureComposer(small_, content).compose(frame),
               static_cast<float>(left), static_cast<float>(top));
  }

  /// Reads the measured friction that the scene names, where the picture shows a curve, before
  /// anything is computed; how it was read is added to the result.
  static std::vector<FrictionData> measuredFriction(BatchResult& result, PictureLayout layout) {
    std::vector<FrictionData> measured;
    if (showsCurve(layout)) measured = readComparisonData(result.item.scene);
    std::ranges::move(notesOf(measured), std::back_inserter(result.reading));
    return measured;
  }

  /// Computes the mean of a scene over its lines, and its curve where the picture shows it. Returns
  /// the curve.
  std::vector<CurvePoint> computeMeans(BatchResult& result, PictureLayout layout) const {
    const Scene& scene = result.item.scene;
    const CurveOptions options{.threads = command_.common.threads};
    Curve curve;
    if (showsCurve(layout)) {
      requireSteadySliding(scene, Message::name("\"show\": \"" + result.item.show + "\""));
      curve = computeCurve(scene, options);
      result.missed = missedTarget(curve).value_or(Message());
    }
    if (const auto mean = computeMean(scene, options)) {
      result.mean = mean->points.front();
      if (result.missed.empty()) result.missed = missedTarget(*mean).value_or(Message());
    }
    return curve.points;
  }

  /// Returns the curve with what the scene compares it with: measured friction and theories.
  CurveSet curvesOf(const Scene& shown, const std::vector<CurvePoint>& curve,
                    const std::vector<FrictionData>& measured) const {
    CurveSet set;
    set.present = {{}, shown, curve, 0};
    if (hasComparisons(set)) addComparisons(set, measured, {.threads = command_.common.threads});
    return set;
  }

  /// Writes the files of one scene.
  void write(BatchResult& result, const Scene& shown, const PictureContent& content,
             const Frame& frame, HeadlessPictures& pictures) {
    const Scene& scene = result.item.scene;
    const std::string& name = result.item.name;
    const auto itemOptions = [&](const std::string& file) {
      Json options = optionsFor(file);
      options["entry"] = itemJson(result.item);
      return options;
    };
    // In the provenance of all files written below.
    std::optional<ProvenanceOptions> given(std::in_place, itemOptions(name + ".png"));
    PictureComposer composer(settings_, content);
    composer.fitHeight(scene);
    pictures.write(fileIn(name + ".png"), composer.compose(frame),
                   settings_.properties(shown.title, pictureOrigin("batch", scene)));
    given.emplace(itemOptions(name + ".csv"));
    result.files = {name + ".png"};
    const std::vector<CurvePoint>& curve = content.curves.present.points;
    if (!curve.empty()) {
      std::string table;
      if (scene.comparison == Comparisons{}) {
        table = curveCsv(curve, columnsFor(scene));
      } else {
        CurveSet curves = content.curves;
        curves.present.scene = scene;  // tables name it in English
        table = curveSetCsv(curves);
      }
      writeFileAtomically(fileIn(name + ".csv"), provenanceComment("batch", scene) + table);
      result.files.push_back(name + ".csv");
    }
    if (layoutFrom(result.item.show) == PictureLayout::Transient) {
      MotionOptions motion{.mostRows = kMotionRows, .threads = command_.common.threads};
      const MotionTable table = marchMotion(scene, motion);
      writeFileAtomically(
          fileIn(name + ".csv"),
          provenanceComment(motionProvenance("batch", scene, table)) + motionCsv(table));
      result.files.push_back(name + ".csv");
    }
    writeFileAtomically(fileIn(name + ".json"),
                        writeScene(withFilesRelativeTo(command_.output, scene)));
    result.files.push_back(name + ".json");
  }

  /// Returns the options of a file, with the size of a picture at the end, given or default.
  Json optionsFor(const std::string& file) const {
    Json options = optionsInFolder(command_.common.given, file);
    options.erase("size");
    if (file.ends_with(".png"))
      options["size"] = command_.picture.size.empty() ? batch_.size : command_.picture.size;
    return options;
  }

  /// Returns the digest of everything that influences the files of a scene.
  std::string itemDigest(const BatchItem& item) const {
    const Json all = {{"version", ASPERITY_VERSION},
                      {"name", item.name},
                      {"show", item.show},
                      {"title", translated(item.title)},
                      {"picture", settings_.json()},
                      {"backend", static_cast<int>(settings_.backend)},
                      {"options", optionsFor(item.name + ".png")},
                      {"origin", lineProvenance("batch", item.scene)}};
    return sha256(jsonLine(all));
  }

  /// Returns the provenance of a file whose scenes are in another file.
  static Json referenceHeader(const std::string& file) {
    Json origin = header();
    origin["see"] = file;
    return origin;
  }

  static Json header() {
    return {
        {"schema", "asperity-batch-results/1"}, {"verb", "batch"}, {"version", ASPERITY_VERSION}};
  }

  /// Returns the provenance of a file that shows all scenes together.
  Json origin(const std::string& file) const {
    Json options = optionsFor(file);
    options["title"] = batch_.title;
    Json origin = header();
    origin["options"] = std::move(options);
    Json& scenes = origin["scenes"] = Json::array();
    for (const BatchResult& result : results_) {
      Json& one = scenes.emplace_back(itemJson(result.item));
      if (!result.item.error.empty()) continue;
      const Json own = provenance("batch", result.item.scene);
      for (const char* member : {"inputs", "scene"})
        if (own.contains(member)) one[member] = own[member];
    }
    if (file.ends_with(".png")) nameLanguage(origin);
    return origin;
  }

  /// Returns how the surfaces were read, once for scenes that follow each other with the same one.
  std::string readingText() const {
    std::string text, last;
    for (const BatchResult& result : results_) {
      std::string facts = translatedLines(result.reading);
      if (!facts.empty() && facts != last) text += result.item.name + ":\n" + facts;
      last = std::move(facts);
    }
    return text;
  }

  int report() const {
    int bad = 0, missed = 0;
    Json answer = header();
    auto& list = answer["scenes"] = Json::array();
    for (const BatchResult& result : results_) {
      Json entry = {{"name", result.item.name}, {"files", result.files}};
      if (!result.fault().empty()) {
        int& count = result.item.error.empty() ? missed : bad;
        ++count;
        entry["error"] = result.fault().english();
        printError(InputError(command_.common.scene, result.item.name, result.fault()).what());
      }
      if (result.item.error.empty()) {
        const CurvePoint none{.mu = kNotApplicable};
        const CurvePoint& mean = result.mean ? *result.mean : none;
        entry["mu"] = numberOrNull(mean.mu);
        entry["mu_standard_error"] = numberOrNull(mean.muStandardError);
        if (std::isfinite(mean.muInterface)) entry["mu_total"] = totalMu(mean);
        entry["realizations"] = result.mean ? Json(mean.realizations) : Json();
        entry["line_mu"] = numberOrNull(result.lineMu);
        entry["provenance"] = lineProvenance("batch", result.item.scene);
        addReadingFacts(entry, result.reading);
      }
      list.push_back(std::move(entry));
    }
    printSummary(
        command_.common,
        (results_.size() == 1 ? filled(Words::tr("one scene, %1 failed"), {std::to_string(bad)})
                              : filled(Words::tr("%1 scenes, %2 failed"),
                                       {std::to_string(results_.size()), std::to_string(bad)})) +
            "\n" + readingText() +
            (missed > 0 ? filledLine(Words::tr("target accuracy missed: %1"), missed) : "") +
            wroteLine(fileIn("index.html")));
    if (command_.common.json) printJson(answer);
    return bad + missed > 0 ? kRunFailed : kDone;
  }

  const BatchCommand& command_;
  Batch batch_;
  PictureSettings settings_, small_;
  ColumnChoice columns_;
  std::optional<ContactSheets> grid_;  // none: no contact sheet
  std::optional<BatchProgress> progress_;
  using Finished = std::pair<std::string, BatchProgressEntry>;
  std::optional<Finished> finished_, written_;
  std::vector<DrawList> sheets_;
  std::vector<BatchResult> results_;
};

}  // namespace

int runBatch(const BatchCommand& command) {
  return BatchRun(command).run();
}

}  // namespace asperity
