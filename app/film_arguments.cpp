#include "app/film_arguments.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace asperity {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kToVideo = "scale=out_color_matrix=bt709:out_range=tv,format=";

// clang-format off
Words mp4() {
  return {"-vf", std::string("pad=ceil(iw/2)*2:ceil(ih/2)*2,") + kToVideo + "yuv420p",
          "-c:v", "libx264", "-preset", "medium", "-crf", "18",
          "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709",
          "-movflags", "+faststart", "-f", "mp4"};
}

Words webm(bool transparent) {
  return {"-vf", std::string(kToVideo) + (transparent ? "yuva420p" : "yuv420p"),
          "-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used", "5",
          "-auto-alt-ref", "0", "-colorspace", "bt709", "-f", "webm"};
}

/// The samples in front give the colours and are cut off: no need to hold the whole film.
Words gif(int samples, bool transparent) {
  return {"-filter_complex",
          fmt::format("[0:v]split[a][b];[a]trim=end_frame={0},palettegen=reserve_transparent={1}[p];"
                      "[b]trim=start_frame={0},setpts=PTS-STARTPTS[f];"
                      "[f][p]paletteuse=dither=sierra2_4a",
                      samples, transparent ? 1 : 0),
          "-c:v", "gif", "-loop", "0", "-f", "gif"};
}

Words webp(bool transparent) {
  return {"-c:v", "libwebp_anim", "-lossless", "0", "-quality", "88", "-compression_level", "3",
          "-loop", "0", "-pix_fmt", transparent ? "yuva420p" : "yuv420p", "-f", "webp"};
}
// clang-format on

Words encodingFor(const std::string& extension, const FilmOptions& options) {
  if (extension == ".mp4") return mp4();
  if (extension == ".webm") return webm(options.transparent);
  return extension == ".gif" ? gif(options.samples, options.transparent)
                             : webp(options.transparent);
}

/// What ends a value or begins a key is text behind a backslash; a zero ends the line even so.
std::string escaped(const std::string& value) {
  std::string text;
  for (const char letter : value) {
    if (std::string_view("=;#\\\n\r").find(letter) != std::string_view::npos) text += '\\';
    text += letter == '\0' ? ' ' : letter;
  }
  return text;
}

}  // namespace

std::vector<std::string> ffmpegArguments(const std::string& extension, const FilmOptions& options,
                                         const std::string& output, const std::string& metadata) {
  // clang-format off
  Words words{"ffmpeg", "-hide_banner", "-nostdin", "-xerror", "-loglevel", "error", "-y",
              "-threads", "1", "-filter_threads", "1", "-filter_complex_threads", "1",
              "-f", "rawvideo", "-pix_fmt", "rgba",
              "-s", fmt::format("{}x{}", options.width, options.height),
              "-r", fmt::format("{}", options.framesPerSecond), "-i", "pipe:0"};
  // clang-format on
  const auto add = [&words](const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  if (metadata.empty())
    add({"-map_metadata", "-1"});
  else
    add({"-f", "ffmetadata", "-i", metadata, "-map", "0:v", "-map_metadata", "1"});
  add({"-fflags", "+bitexact", "-flags:v", "+bitexact"});
  add(encodingFor(extension, options));
  add({"-threads", "1", output});
  return words;
}

std::string filmMetadata(const std::string& extension, const FilmOptions& options) {
  if (extension == ".gif" || extension == ".webp") return {};
  std::string text;
  for (const auto& [key, value] :
       {std::pair{"title", &options.title}, {"comment", &options.metadata}})
    if (!value->empty()) text += fmt::format("{}={}\n", key, escaped(*value));
  return text.empty() ? text : ";FFMETADATA1\n" + text;
}

}  // namespace asperity
