// Pictures as EPS, which some publishers still require: the program's own PDF, turned into
// PostScript by pdftops (poppler-utils).
#include <QProcess>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/program.h"
#include "core/base/text.h"
#include "ui/draw/picture_file.h"

namespace asperity {
namespace {

constexpr const char* kTool = "pdftops";

/// Returns the metadata as comments, whose lines PostScript limits to 255 characters.
std::string metadataComments(const std::string& metadata) {
  constexpr std::size_t kLine = 200;
  std::string text;
  for (std::size_t at = 0; at < metadata.size(); at += kLine)
    text += "%asperity: " + metadata.substr(at, kLine) + "\n";
  return text;
}

/// Returns whether a part of the picture fades out, as the light of contacts does.
bool isSoft(const DrawLayer& layer) {
  for (std::size_t i = 0; i + 2 < layer.triangles.size(); i += 3)
    for (const std::size_t other : {i + 1, i + 2})
      if (layer.triangles[i].colour.a != layer.triangles[other].colour.a) return true;
  return false;
}

/// Returns the picture in opaque colours, each blended with the background. PostScript has no
/// translucency: a page with translucent colours would become one image.
DrawList opaque(DrawList list) {
  const Rgba ground = list.background.a > 0 ? list.background : Rgba{1, 1, 1, 1};
  const auto flatten = [&](Rgba& colour) {
    const auto mixed = [&](float above, float below) {
      return above * colour.a + below * (1 - colour.a);
    };
    colour = {mixed(colour.r, ground.r), mixed(colour.g, ground.g), mixed(colour.b, ground.b), 1};
  };
  const auto isUnseen = [](const Rgba& colour) { return colour.a <= 0; };
  for (DrawLayer& layer : list.layers) {
    std::vector<DrawVertex> seen;
    for (std::size_t i = 0; i + 2 < layer.triangles.size(); i += 3)
      if (!isUnseen(layer.triangles[i].colour))
        seen.insert(seen.end(), layer.triangles.begin() + static_cast<std::ptrdiff_t>(i),
                    layer.triangles.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    layer.triangles = std::move(seen);
    std::erase_if(layer.lines, [&](const DrawLine& line) {
      return line.vertices.empty() || isUnseen(line.vertices.front().colour);
    });
    for (DrawVertex& vertex : layer.triangles) flatten(vertex.colour);
    for (DrawLine& line : layer.lines)
      for (DrawVertex& vertex : line.vertices) flatten(vertex.colour);
  }
  for (DrawText& text : list.texts) flatten(text.colour);
  flatten(list.background);
  return list;
}

}  // namespace

bool canWriteEps() {
  return !findProgram(kTool).empty();
}

void writeEps(const std::filesystem::path& file, const DrawList& list,
              const PictureProperties& properties) {
  const auto fail = [&](const std::string& why) {
    throw std::runtime_error(printable(file.string()) + ": cannot be written: " + printable(why));
  };
  const bool isImage = std::ranges::any_of(list.layers, isSoft);
  const std::string pdf = pdfBytes(isImage ? list : opaque(list), properties);
  constexpr double kPointsPerInch = 72;
  const auto dotsPerInch =
      QString::number(std::lround(kPointsPerInch / properties.pointsPerPixel()));
  const QString rasterize = isImage ? QStringLiteral("always") : QStringLiteral("never");
  QProcess tool;
  tool.start(QString::fromStdString(findProgram(kTool)),
             {"-eps", "-level3", "-rasterize", rasterize, "-r", dotsPerInch, "-aaRaster", "yes",
              "-", "-"});
  if (!tool.waitForStarted()) fail("pdftops cannot be started");
  tool.write(pdf.data(), static_cast<qint64>(pdf.size()));
  tool.closeWriteChannel();
  constexpr int kLongest = 120000;  // ms
  if (!tool.waitForFinished(kLongest)) {
    tool.kill();
    tool.waitForFinished();
    fail("pdftops did not finish within two minutes");
  }
  std::string eps = tool.readAllStandardOutput().toStdString();
  const std::string end = "%%EndComments\n";
  const std::size_t header = eps.find(end);
  if (tool.exitCode() != 0 || !eps.starts_with("%!PS") || header == eps.npos)
    fail("pdftops failed: " + tool.readAllStandardError().simplified().toStdString());
  eps.insert(header + end.size(), metadataComments(properties.metadata));
  writeFileAtomically(file, eps);
}

}  // namespace asperity
