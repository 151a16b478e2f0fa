// asperity batch: many scenes and sweeps into pictures, data and a page to look through.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/batch_file.h"
#include "app/batch_page.h"
#include "app/command_line.h"
#include "app/frame_source.h"
#include "app/headless_pictures.h"
#include "app/output.h"
#include "app/picture_composer.h"
#include "app/progress_bar.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/run/motion_table.h"
#include "core/scene/atomic_file.h"
#include "core/scene/effects.h"
#include "core/scene/input_error.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"
#include "ui/picture/picture_origin.h"
#include "ui/picture/shapes.h"
#include "ui/picture/stacked.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kThumbnail = 480;             // pixels wide
constexpr std::int64_t kMotionRows = 2000;  // of a motion's table

class BatchRun {
 public:
  explicit BatchRun(const BatchCommand& command)
      : command_(command), batch_(readBatch(command.common.scene)) {
    style_ = readStyle();
    small_ = style_;
    small_.width = kThumbnail;
    small_.height = kThumbnail * style_.height / style_.width;
    small_.scale = 0.5F;
    columns_ = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(batch_.items.size()))));
    const auto rows = (static_cast<int>(batch_.items.size()) + columns_ - 1) / columns_;
    sheet_.width = columns_ * small_.width;
    sheet_.height = rows * small_.height;
    sheet_.background = style_.theme.background;
    makeFolder(command.output);
    checkWritable(fileIn("index.html"));
    for (const BatchItem& item : batch_.items)
      checkNoInput(fileIn(item.name + ".json"), {command.common.scene});
  }

  int run() {
    HeadlessPictures pictures(style_.backend);
    {
      ProgressBar bar(Words::tr("scenes"), command_.common.quiet);
      const auto total = static_cast<std::int64_t>(batch_.items.size());
      for (const BatchItem& item : batch_.items) {
        results_.push_back(resultOf(item, pictures));
        bar.show(static_cast<std::int64_t>(results_.size()), total);
      }
    }
    const std::string made = provenanceLine(origin());
    pictures.write(fileIn("contact_sheet.png"), sheet_, {batch_.title, made, style_.scale});
    pictures.finish();
    writeFileAtomically(fileIn("results.csv"), "# asperity: " + made + "\n" + batchTable(results_));
    writeFileAtomically(fileIn("index.html"), batchPage(batch_, results_));
    return report();
  }

 private:
  std::string fileIn(const std::string& name) const {
    return (std::filesystem::path(command_.output) / name).string();
  }

  /// A size that the file gives is said of the file.
  PictureStyle readStyle() const {
    PictureChoice choice = command_.picture;
    const bool isOfFile = choice.size.empty();
    if (isOfFile) choice.size = batch_.size;
    try {
      return styleOf(choice, {960, 900, "light"});
    } catch (const InputError& error) {
      if (!isOfFile || error.key() != "--size") throw;
      throw InputError(command_.common.scene, "size", error.message());
    }
  }

  /// What goes wrong with one scene is said of it, and the rest go on.
  BatchResult resultOf(const BatchItem& item, HeadlessPictures& pictures) {
    BatchResult result;
    result.item = item;
    try {
      if (item.error.empty()) fill(result, pictures);
    } catch (const InputError& error) {
      result.item.error = error.what();
    } catch (const std::runtime_error& error) {
      result.item.error = error.what();
    }
    if (!result.item.error.empty()) {
      const auto [x, y] = cell();
      addLabel(sheet_, filled(Words::tr("%1 failed"), {item.name}), {x + 16, y + 32}, 16,
               TextAnchor::Left, style_.theme.text);
    }
    return result;
  }

  /// Where the next scene stands on the sheet.
  Place cell() const {
    const int place = static_cast<int>(results_.size());
    return {static_cast<float>(place % columns_ * small_.width),
            static_cast<float>(place / columns_ * small_.height)};
  }

  void fill(BatchResult& result, HeadlessPictures& pictures) {
    const Scene& scene = result.item.scene;
    const PictureLayout layout = layoutFrom(result.item.show);
    PictureContent content{layout};
    if (layout == PictureLayout::Curve || layout == PictureLayout::Both) {
      needSteadySliding(scene, "\"show\": \"" + result.item.show + "\"");
      CurveOptions options;
      options.threads = command_.common.threads;
      content.curves.present = {{}, scene, frictionCurve(scene, options).points, 0};
    }
    FrameSource source(scene, {}, true);
    const Frame frame = source.frame(0);
    result.mu = frame.transient ? frame.muMarch : frame.muSteady;
    result.indentation = frame.indentation;
    result.contactFraction = frame.contactFraction;

    const std::string& name = result.item.name;
    pictures.write(fileIn(name + ".png"), PictureComposer(style_, content).compose(frame),
                   {translated(scene.title), pictureOrigin("batch", scene), style_.scale});
    result.files = {name + ".png"};
    const std::vector<CurvePoint>& curve = content.curves.present.points;
    if (!curve.empty()) {
      writeFileAtomically(fileIn(name + ".csv"),
                          provenanceComment("batch", scene) + curveCsv(curve));
      result.files.push_back(name + ".csv");
    }
    if (layout == PictureLayout::Transient) {
      MotionOptions options;
      options.mostRows = kMotionRows;
      options.threads = command_.common.threads;
      const MotionTable table = marchMotion(scene, options);
      writeFileAtomically(fileIn(name + ".csv"),
                          "# asperity: " + provenanceLine(motionProvenance("batch", scene, table)) +
                              "\n" + motionCsv(table));
      result.files.push_back(name + ".csv");
    }
    writeFileAtomically(fileIn(name + ".json"), writeScene(scene));
    result.files.push_back(name + ".json");

    const auto [x, y] = cell();
    addPicture(sheet_, PictureComposer(small_, content).compose(frame), x, y);
  }

  static Json header() {
    return {
        {"schema", "asperity-batch-results/1"}, {"verb", "batch"}, {"version", ASPERITY_VERSION}};
  }

  /// Of what shows all scenes together.
  Json origin() const {
    Json origin = header();
    Json& scenes = origin["scenes"] = Json::array();
    for (const BatchResult& result : results_)
      if (result.item.error.empty())
        scenes.push_back(
            {{"name", result.item.name}, {"scene", Json::parse(writeScene(result.item.scene))}});
    nameLanguage(origin);
    return origin;
  }

  int report() const {
    int bad = 0;
    Json answer = header();
    auto& list = answer["scenes"] = Json::array();
    for (const BatchResult& result : results_) {
      Json entry = {{"name", result.item.name}, {"files", result.files}};
      if (!result.item.error.empty()) {
        ++bad;
        entry["error"] = result.item.error;
        std::fputs("asperity: ", stderr);
        std::fputs(InputError(command_.common.scene, result.item.name, result.item.error).what(),
                   stderr);
        std::fputs("\n", stderr);
      } else {
        entry["mu"] = std::isfinite(result.mu) ? Json(result.mu) : Json();
        entry["provenance"] = provenance("batch", result.item.scene);
      }
      list.push_back(std::move(entry));
    }
    printSummary(
        command_.common.json, command_.common.quiet,
        (results_.size() == 1 ? filled(Words::tr("one scene, %1 failed"), {std::to_string(bad)})
                              : filled(Words::tr("%1 scenes, %2 failed"),
                                       {std::to_string(results_.size()), std::to_string(bad)})) +
            "\n" + wroteLine(fileIn("index.html")));
    if (command_.common.json) fmt::print("{}\n", answer.dump(2));
    return bad > 0 ? kRunFailed : kDone;
  }

  const BatchCommand& command_;
  Batch batch_;
  PictureStyle style_, small_;
  int columns_ = 1;
  DrawList sheet_;
  std::vector<BatchResult> results_;
};

}  // namespace

int runBatch(const BatchCommand& command) {
  return BatchRun(command).run();
}

}  // namespace asperity
