// asperity render: pictures and films of the contact without a screen.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <thread>

#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/film_file.h"
#include "app/pictures/frame_pipeline.h"
#include "app/pictures/frame_source.h"
#include "app/pictures/headless_pictures.h"
#include "app/pictures/picture_composer.h"
#include "app/pictures/sequence_files.h"
#include "app/progress_bar.h"
#include "core/accuracy/compute_curve.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/run/contact_report.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"
#include "ui/contact/contact_overlay.h"
#include "ui/contact/contact_probe.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

enum class Kind { Picture, Film, Sequence };

Kind outputKind(const std::string& output) {
  checkFolderName(output);
  if (isPictureFile(output)) {
    checkPictureTool(output);
    return Kind::Picture;
  }
  if (isFilmFile(output)) return Kind::Film;
  std::error_code ignored;
  if (!fileExtension(output).empty() && !fs::is_directory(output, ignored))
    throw InputError(
        output, "",
        "is neither a folder nor a .png, .svg, .pdf, .eps, .tif, .mp4, .webm, .gif or .webp file");
  return Kind::Sequence;
}

/// Returns the numbers beside the crosshair, SI; a value that the frame does not have is left out.
Json probeJson(const ProbeReading& reading) {
  Json json = {{"position", reading.position},      {"rigid_height", reading.line},
               {"surface_height", reading.surface}, {"gap", reading.gap},
               {"line_load", reading.pressure},     {"slope", reading.slope}};
  if (reading.surfaceRate) json["surface_rate"] = *reading.surfaceRate;
  if (reading.age) json["time_since_contact"] = *reading.age;
  if (reading.power) json["power"] = *reading.power;
  return json;
}

/// One run of the command, from its options to the files it writes.
class Rendering {
 public:
  explicit Rendering(const RenderCommand& command)
      : command_(command),
        compared_(withCurveOptions(loadScene(command.common), command.curves)),
        scene_(compared_.scene),
        kind_(outputKind(command.output)),
        settings_(pictureSettings(command.picture)),
        layout_(layoutFrom(command.layout)),
        overlay_(command.overlay.empty() ? ContactOverlay::Pressure
                                         : chosen(kContactOverlays, command.overlay, "--overlay")) {
    checkUsage();
    checkParts();
    if (showsCurve(layout_)) checkCurves(command.curves, scene_);
    withSceneContext(command_.common, [&] {
      checkLayout();
      frames_.emplace(scene_, command_.time, kind_ == Kind::Picture, command_.view.fields(overlay_),
                      command_.view.finest());
      checkView(command_.view, overlay_, frames_->length());
      if (showsCurve(layout_)) computeCurves();
      reading_ = readingFacts(scene_);
    });
    composer_.emplace(settings_, content());
    composer_->fitHeight(scene_);
  }

  void run() {
    const auto start = std::chrono::steady_clock::now();
    if (kind_ == Kind::Picture)
      writePicture();
    else if (kind_ == Kind::Film)
      writeFilm();
    else
      writeSequence();
    elapsed_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  /// Throws where a curve, which is drawn all the same, misses the target of its scene.
  void requireTargets() const { curves_.requireTargets(); }

  std::string summary() const {
    std::string text = "mu = " + answerNumber(last_.state.mu, 6);
    if (std::isfinite(last_.muError)) text += " \u00B1 " + answerNumber(last_.muError, 2);
    text += "\n" + translatedLines(reading_);
    if (kind_ == Kind::Picture) return text + wroteLine(command_.output);
    text += framesText() + "\n";
    if (const std::int64_t kept = count() - drawn_; kept > 0)
      text += (kept == 1 ? Words::tr("one was there already")
                         : filled(Words::tr("%1 were there already"), {std::to_string(kept)})) +
              "\n";
    if (removed_ > 0)
      text += (removed_ == 1
                   ? Words::tr("removed one frame that an earlier, longer sequence left")
                   : filled(Words::tr("removed %1 frames that an earlier, longer sequence left"),
                            {std::to_string(removed_)})) +
              "\n";
    return text;
  }

  Json json() const {
    Json answer = origin();
    addReadingFacts(answer, reading_);
    answer["mu"] = numberOrNull(last_.state.mu);
    if (std::isfinite(last_.muError)) answer["mu_discretization_error"] = last_.muError;
    if (last_.state.muInterface > 0) answer["mu_interface"] = last_.state.muInterface;
    answer["indentation"] = last_.state.indentation;
    answer["contact_fraction"] = last_.state.contactFraction;
    answer["derived"] = derivedNumbers(last_);
    if (command_.view.probe)
      if (const auto reading = probeReading(last_, *command_.view.probe))
        answer["probe"] = probeJson(*reading);
    answer["files"] = files_;
    if (kind_ != Kind::Picture) answer["pipeline"] = pipelineJson();
    return answer;
  }

 private:
  std::int64_t count() const { return frames_->plan().count; }

  /// Returns a summary: "wrote 60 frames in out".
  std::string framesText() const {
    const bool isFilm = kind_ == Kind::Film;
    if (drawn_ == 1)
      return filled(
          isFilm ? Words::tr("wrote one frame to %1") : Words::tr("wrote one frame in %1"),
          {command_.output});
    return filled(isFilm ? Words::tr("wrote %1 frames to %2") : Words::tr("wrote %1 frames in %2"),
                  {std::to_string(drawn_), command_.output});
  }

  void checkUsage() const {
    if (kind_ == Kind::Picture) checkStill();
    checkUseful(command_.picture, {command_.output});
    checkNoInput(command_.output, inputFiles(command_.common, scene_));
    checkNoInput(command_.output, filesReadBeside(command_.curves, scene_));
    if (kind_ == Kind::Sequence)
      checkFolder(command_.output);
    else
      checkWritable(command_.output);
    if (kind_ == Kind::Film) checkFilm(command_.output, settings_.transparent);
    if (command_.resume && kind_ != Kind::Sequence)
      throw InputError("", "--resume",
                       "goes on with a folder of frames; a single file is made anew");
  }

  /// Throws for options of time, which a single picture does not have.
  void checkStill() const {
    const TimeArguments& time = command_.time;
    refuseGiven({{"--frames", time.frames > 1},
                 {"--fps", time.framesPerSecond > 0},
                 {"--duration", time.duration > 0},
                 {"--cycles", time.cycles > 0},
                 {"--slow-motion", time.slowMotion > 0}},
                command_.output + " is one picture; frames need a folder or a film");
  }

  /// Throws for options of a part of the picture that the layout does not have.
  void checkParts() const {
    const auto refuse = [&](const char* option, const char* part) {
      throw InputError(
          "", option,
          message("applies only to {}, which --layout {} does not show", part, command_.layout));
    };
    if (layout_ == PictureLayout::Curve) {
      if (!command_.overlay.empty()) refuse("--overlay", "the contact");
      if (const char* option = command_.view.firstOption()) refuse(option, "the contact");
      if (command_.time.slid) refuse("--slid", "the contact");
      if (command_.time.at && scene_.sliding.kind == SlidingKind::Steady)
        refuse("--at", "the contact");
    }
    if (!showsCurve(layout_))
      if (const char* option = command_.curves.firstOption()) refuse(option, "the curve");
    if (layout_ == PictureLayout::Contact)
      refuseChartOptions(
          command_.picture,
          message("applies only to charts, which --layout {} does not show", command_.layout));
  }

  void checkLayout() const {
    if (layout_ == PictureLayout::Transient)
      requireMotion(scene_, Message::name("--layout transient"));
    if (layout_ == PictureLayout::Curve && kind_ != Kind::Picture)
      throw InputError(
          "", "--layout",
          "curve cannot be a film, because it does not move; --layout both shows the contact, too");
  }

  /// Computes the curves. They are those of steady sliding, for every motion of the scene.
  void computeCurves() {
    ComparedScene steady{scene_, compared_.given};
    steady.scene.sliding.kind = SlidingKind::Steady;
    curves_.set = plannedCurveSet(command_.curves, steady);
    PictureComposer(settings_, content()).checkPlanned();
    curves_ = makeCurveSet(command_.curves, steady, computeCurve(steady.scene, command_.common),
                           command_.common);
  }

  /// Returns the provenance of the whole run: scene, command, version, seed and the options of the
  /// picture.
  Json origin() const {
    const ProvenanceOptions given(optionsFor(command_.common.given, command_.output + ".png"));
    Json origin = lineProvenance("render", scene_);
    if (showsCurve(layout_)) addCurveOversampling(origin, scene_);
    Json& picture = origin["picture"] = settings_.json();
    picture["layout"] = command_.layout;
    if (overlay_ != ContactOverlay::Pressure) picture["overlay"] = command_.overlay;
    command_.view.addTo(picture);
    command_.curves.addTo(picture);
    if (command_.time.at) picture["at"] = *command_.time.at;
    if (command_.time.slid) picture["slid"] = *command_.time.slid;
    if (kind_ != Kind::Picture) {
      picture["frames"] = count();
      picture["frames_per_second"] = frames_->plan().framesPerSecond;
      if (frames_->plan().periodsPerFrame > 0)
        picture["periods_per_frame"] = frames_->plan().periodsPerFrame;
    }
    return origin;
  }

  DrawList compose(std::int64_t index) {
    last_ = frames_->frame(index);
    return composer_->compose(last_);
  }

  PictureContent content() const {
    return {layout_, curves_.set, overlay_, command_.view, kind_ != Kind::Picture};
  }

  void writePicture() {
    HeadlessPictures pictures(settings_.backend);
    pictures.write(command_.output, compose(0),
                   settings_.properties(translated(scene_.title), provenanceLine(origin())));
    pictures.finish();
    files_ = {command_.output};
  }

  /// Returns frames spread over the whole film, from which a gif takes its colours. It is empty for
  /// other films.
  std::vector<std::int64_t> sampledIndices() const {
    constexpr std::int64_t kSamples = 8;
    if (fileExtension(command_.output) != ".gif") return {};
    if (count() <= kSamples) return allIndices();
    std::vector<std::int64_t> indices;
    for (std::int64_t i = 0; i < kSamples; ++i)
      indices.push_back(i * (count() - 1) / (kSamples - 1));
    return indices;
  }

  /// Simulates and draws these frames in addition to those of the film.
  void addSamples(const std::vector<std::int64_t>& indices, HeadlessPictures& pictures,
                  FilmFile& film) const {
    if (indices.empty()) return;
    FrameSource frames(scene_, command_.time, false, command_.view.fields(overlay_),
                       command_.view.finest());
    PictureComposer composer(settings_, content());
    for (const std::int64_t index : indices)
      film.add(pictures.draw(composer.compose(frames.frame(index))));
  }

  void writeFilm() {
    const std::vector<std::int64_t> samples = sampledIndices();
    FilmOptions options{settings_.width,
                        settings_.height,
                        frames_->plan().framesPerSecond,
                        settings_.transparent,
                        static_cast<int>(samples.size()),
                        translated(scene_.title),
                        provenanceLine(origin())};
    HeadlessPictures pictures(settings_.backend);
    FilmFile film(command_.output, options);
    addSamples(samples, pictures, film);
    PipelineStages stages = pipelineStages(pictures);
    stages.sink = [&film](std::int64_t, const QImage& image, StageSeconds& seconds) {
      const StageTimer timer(seconds.encode);
      film.add(image);
    };
    runStages(allIndices(), stages);
    const StageTimer timer(seconds_.write);
    film.finish();
    files_ = {command_.output};
  }

  void writeSequence() {
    SequenceFiles sequence(command_.output, count(), origin());
    files_ = sequence.files();
    const std::vector<std::int64_t> missing = command_.resume ? sequence.missing() : allIndices();
    HeadlessPictures pictures(settings_.backend);
    PipelineStages stages = pipelineStages(pictures);
    stages.workers = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 4U));
    stages.sink = [&](std::int64_t index, const QImage& image, StageSeconds& seconds) {
      std::string png;
      {
        const StageTimer timer(seconds.encode);
        png = encodePng(image,
                        settings_.properties(translated(scene_.title), sequence.metadata(index)));
      }
      const StageTimer timer(seconds.write);
      writeFileAtomically(sequence.file(index), png);
    };
    runStages(missing, stages);
    if (missing.empty()) last_ = frames_->frame(count() - 1);
    removed_ = sequence.removeLeftOver();
  }

  std::vector<std::int64_t> allIndices() const {
    std::vector<std::int64_t> indices(static_cast<std::size_t>(count()));
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::int64_t>(i);
    return indices;
  }

  PipelineStages pipelineStages(HeadlessPictures& pictures) {
    PipelineStages stages;
    stages.compose = [this](std::int64_t index) { return compose(index); };
    stages.draw = [&pictures](const DrawList& list) { return pictures.draw(list); };
    return stages;
  }

  void runStages(const std::vector<std::int64_t>& indices, PipelineStages& stages) {
    ProgressBar bar(Words::tr("frames"), command_.common.quiet);
    drawn_ = static_cast<std::int64_t>(indices.size());
    stages.progress = [&](std::int64_t done) { bar.show(done, drawn_); };
    seconds_ = runPipeline(indices, stages);
  }

  /// Returns the fractions of time of the stages. They are the only part of an answer that differs
  /// from run to run.
  Json pipelineJson() const {
    const double total = seconds_.simulate + seconds_.draw + seconds_.encode + seconds_.write;
    const auto share = [total](double part) { return total > 0 ? part / total : 0; };
    return {{"frames_drawn", drawn_},
            {"frames_per_second", elapsed_ > 0 ? static_cast<double>(drawn_) / elapsed_ : 0},
            {"share",
             {{"simulate", share(seconds_.simulate)},
              {"draw", share(seconds_.draw)},
              {"encode", share(seconds_.encode)},
              {"write", share(seconds_.write)}}}};
  }

  const RenderCommand& command_;
  ComparedScene compared_;
  const Scene& scene_;
  Kind kind_;
  PictureSettings settings_;
  PictureLayout layout_;
  ContactOverlay overlay_;
  ComputedCurves curves_;
  std::optional<FrameSource> frames_;
  std::optional<PictureComposer> composer_;
  std::vector<Message> reading_;  // how the file of the surface was read
  Frame last_;                    // only the composing thread uses it while it runs
  std::vector<std::string> files_;
  std::int64_t drawn_ = 0, removed_ = 0;
  StageSeconds seconds_;
  double elapsed_ = 0;
};

}  // namespace

int runRender(const RenderCommand& command) {
  if (isTableFile(command.output)) return runContactTable(command);
  refuseGiven({{"--table", !command.table.empty()}, {"--columns", !command.columns.empty()}},
              "belongs to tables, and the output is none");
  Rendering rendering(command);
  rendering.run();
  printSummary(command.common, rendering.summary());
  if (command.common.json) printJson(rendering.json());
  rendering.requireTargets();
  return kDone;
}

}  // namespace asperity
