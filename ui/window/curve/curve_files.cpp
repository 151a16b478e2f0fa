#include "ui/window/curve/curve_files.h"

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/chart/curve_diagram.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/draw/png_file.h"
#include "ui/language/translated.h"
#include "ui/window/main/picture_files.h"

namespace asperity {

namespace {

constexpr int kPixelsAlong = 2400, kPixelsUp = 1600, kPixelsOfStrip = 500;
constexpr float kScale = 2;

/// Returns the provenance of the present scene, as `asperity curve` writes it, with the other
/// curves.
nlohmann::ordered_json curveOrigin(const CurveSet& set) {
  nlohmann::ordered_json origin = provenance("curve", set.present.scene);
  if (set.axes == CurveAxes::Dimensionless) origin["axes"] = "dimensionless";
  for (const NamedCurve& curve : set.pinned)
    origin["pinned"].push_back(provenance("curve", curve.scene)["scene"]);
  if (set.difference) origin["compared_with"] = settingName(set.difference->setting).english();
  return origin;
}

DiagramOptions printed(const CurveSet& set) {
  DiagramOptions options;
  options.width = kPixelsAlong;
  options.height = kPixelsUp + (set.difference ? kPixelsOfStrip : 0);
  options.scale = kScale;
  options.theme = printTheme();
  return options;
}

}  // namespace

void writeCurves(const std::filesystem::path& file, const CurveSet& set) {
  nlohmann::ordered_json origin = curveOrigin(set);
  if (file.extension() == ".csv")
    return writeFileAtomically(file,
                               "# asperity: " + provenanceLine(origin) + "\n" + curveSetCsv(set));
  nameLanguage(origin);
  const DiagramSheet sheet = curveSheet(set);
  try {
    writePicture(file, composeDiagrams(sheet, printed(set)),
                 {translated(sheet.title), provenanceLine(origin), kScale});
  } catch (const InputError&) {
    throw unknownExtension(file.string(), file.extension().string(),
                           {".png", ".svg", ".pdf", ".csv"});
  }
}

QImage renderCurves(const CurveSet& set, int width, int height, double scale, const Theme& theme) {
  DiagramOptions options;
  options.width = width;
  options.height = height;
  options.scale = static_cast<float>(scale);
  options.theme = theme;
  return renderImage(contextOfThread(), composeDiagrams(curveSheet(set), options));
}

}  // namespace asperity
