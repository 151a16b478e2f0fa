// asperity render: pictures of the contact without a screen, by OSMesa.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "app/command_line.h"
#include "app/headless_pictures.h"
#include "app/output.h"
#include "app/progress_bar.h"
#include "core/run/simulation.h"
#include "core/run/steady_frames.h"
#include "core/scene/input_error.h"
#include "core/scene/provenance.h"
#include "ui/picture/contact_picture.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr int kSmallest = 160, kLargest = 16384;  // pixels
constexpr std::int64_t kFramesOfFolder = 60;

struct Size {
  int width, height;
};

Size sizeFrom(const std::string& text) {
  Size size{};
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  bool good = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
  if (good) {
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    good = height.ec == std::errc{} && height.ptr == end;
  }
  const auto fits = [](int pixels) { return pixels >= kSmallest && pixels <= kLargest; };
  if (!good || !fits(size.width) || !fits(size.height))
    throw InputError(
        "", "--size",
        fmt::format("{} is not WIDTHxHEIGHT with {} to {} pixels each", text, kSmallest, kLargest));
  return size;
}

std::int64_t frameCount(const RenderCommand& command) {
  if (extensionOf(command.output) == ".png") return 1;
  return command.frames > 0 ? command.frames : kFramesOfFolder;
}

/// The file of each frame, and the folder made where one is named.
std::vector<std::string> filesFor(const RenderCommand& command) {
  if (extensionOf(command.output) == ".png") {
    if (command.frames > 1)
      throw InputError(command.output, "", "is one file; --frames needs a folder");
    checkOutputs({command.output}, {".png"});
    return {command.output};
  }
  const fs::path folder = command.output;
  if (folder.has_extension() && !fs::is_directory(folder))
    throw InputError(command.output, "", "is neither a folder nor a .png file");
  makeFolder(command.output);
  const std::int64_t frames = frameCount(command);
  std::vector<std::string> files;
  for (std::int64_t i = 1; i <= frames; ++i)
    files.push_back((folder / fmt::format("frame_{:04}.png", i)).string());
  checkOutputs({files.front()}, {".png"});
  return files;
}

/// The frames asked for, one after the other: of steady sliding they divide a period, of other
/// motions the duration.
class Frames {
 public:
  Frames(const Scene& scene, std::int64_t count, double framesPerSecond)
      : count_(count), framesPerSecond_(framesPerSecond) {
    const auto shared = std::make_shared<const Scene>(scene);
    if (scene.sliding.kind == SlidingKind::Steady)
      steady_.emplace(shared);
    else
      motion_.emplace(shared, 0, std::numeric_limits<double>::infinity());
  }

  Frame next() {
    const std::int64_t index = made_++;
    if (steady_) return steady_->frame(index, count_, framesPerSecond_);
    // A single picture shows the end.
    const auto steps = static_cast<double>(std::max<std::int64_t>(count_ - 1, 1));
    if (index > 0 || count_ == 1) motion_->advance(1 / steps, 1 / framesPerSecond_);
    return motion_->frame();
  }

 private:
  std::int64_t count_, made_ = 0;
  double framesPerSecond_;
  std::optional<SteadyFrames> steady_;
  std::optional<Simulation> motion_;
};

double frictionOf(const Frame& frame) {
  return frame.transient ? frame.muMarch : frame.muSteady;
}

void printJson(const Scene& scene, const Frame& frame, const std::vector<std::string>& files) {
  nlohmann::ordered_json answer = provenance("render", scene);
  const double mu = frictionOf(frame);
  answer["mu"] = std::isfinite(mu) ? nlohmann::ordered_json(mu) : nlohmann::ordered_json();
  if (frame.muInterface > 0) answer["mu_interface"] = frame.muInterface;
  answer["indentation"] = frame.indentation;
  answer["contact_fraction"] = frame.contactFraction;
  answer["files"] = files;
  fmt::print("{}\n", answer.dump(2));
}

}  // namespace

int runRender(const RenderCommand& command) {
  const Scene scene = sceneOf(command.common);
  const Size size = sizeFrom(command.size);
  if (!std::isfinite(command.framesPerSecond))
    throw InputError("", "--fps", "is not a finite number");
  const std::int64_t count = frameCount(command);
  Frames frames =
      saidOfScene(command.common, [&] { return Frames(scene, count, command.framesPerSecond); });
  const std::vector<std::string> files = filesFor(command);  // makes the folder: after all checks
  Frame frame;
  {
    HeadlessPictures pictures;
    const PictureFacts facts{scene.title, provenanceLine(provenance("render", scene))};
    ProgressBar bar("frames", command.common.quiet);
    for (std::int64_t i = 0; i < count; ++i) {
      ContactPictureOptions options;
      options.width = size.width;
      options.height = size.height;
      frame = frames.next();
      pictures.write(files[static_cast<std::size_t>(i)], composeContact(frame, options), facts);
      bar.show(i + 1, count);
    }
    pictures.finish();
  }
  const std::string what =
      count == 1 ? files.front() : fmt::format("{} frames in {}", count, command.output);
  printSummary(command.common.json, command.common.quiet,
               fmt::format("mu = {:.6g}\nwrote {}\n", frictionOf(frame), what));
  if (command.common.json) printJson(scene, frame, files);
  return kDone;
}

}  // namespace asperity
