#include "ui/panels/profile_defaults.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/scene/scene_files.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"

namespace asperity {

namespace {

constexpr std::string_view kFile = "surface.file";
constexpr std::string_view kSpectrumKind = "surface.spectrum_kind";
constexpr std::string_view kRealizations = "ensemble.realizations";
constexpr int kDefaultDigits = 6;

/// Returns whether 0 means that the profile's file or the scene determines the value.
bool mayBeLeftOpen(const Parameter& parameter, const Scene& scene) {
  return isChosenWhereOpen(parameter) || isTakenFromSurfaceFile(parameter, scene, 0);
}

/// Sets a number to 0, which setValue() refuses where it is outside the limits.
void clearValue(const Parameter& parameter, Scene& scene) {
  if (const auto* real = std::get_if<RealField>(&parameter.field))
    real->member(scene) = 0;
  else
    std::get<IntegerField>(parameter.field).member(scene) = 0;
}

bool hasContent(const Parameter& parameter, TextContent content) {
  const auto* text = std::get_if<TextField>(&parameter.field);
  return text && text->content == content;
}

/// Returns the oversampling for one line and, if it differs, for the curve.
Placeholder chosenOversampling(const Scene& scene, const LineSize& known) {
  const Surface& surface = scene.surface;
  const LineSize size{surface.length > 0 ? surface.length : known.length,
                      surface.elements > 0 ? surface.elements : known.elements};
  const std::int64_t line = pointsPerElement(scene, size), curve = curvePointsPerElement(scene);
  return {line == curve ? ParameterPanel::tr("chosen: %1").arg(line)
                        : ParameterPanel::tr("%1 (curve: %2)").arg(line).arg(curve),
          static_cast<double>(line), false};
}

Placeholder fromFile(const Parameter& parameter, double known) {
  if (!(known > 0)) return {ParameterPanel::tr("as in file"), {}, false};
  const UnitText text =
      inReadableUnit(roundedToDigits(known, kDefaultDigits), fromUtf8(parameter.unit));
  return {inLanguage(text.number), known, false, text.unit};
}

}  // namespace

QString zeroText(const Parameter& parameter) {
  switch (parameter.zero) {
    case ZeroMeaning::None:
      return ParameterPanel::tr("none");
    case ZeroMeaning::NotSet:
      return ParameterPanel::tr("not set");
    case ZeroMeaning::Automatic:
      return ParameterPanel::tr("automatic");
    case ZeroMeaning::AsFileStates:
      return ParameterPanel::tr("as in file");
    case ZeroMeaning::TenthOfProfile:
      return ParameterPanel::tr("a tenth");
    case ZeroMeaning::AllRows:
      return ParameterPanel::tr("all rows");
    default:
      return {};
  }
}

std::optional<Placeholder> placeholderFor(const Parameter& parameter, const Scene& scene,
                                          const LineSize& known) {
  if (parameter.zero == ZeroMeaning::EveryRow && !mayHaveManyLines(scene.surface))
    return Placeholder{QStringLiteral("1"), 1, true};
  const QString meaning = zeroText(parameter);
  if (meaning.isEmpty() && !mayBeLeftOpen(parameter, scene)) return {};
  if (parameterNumber(parameter, scene) != 0) return {};
  if (!meaning.isEmpty()) return Placeholder{meaning, 0, false};
  if (parameter.zero == ZeroMeaning::EveryRow)
    return Placeholder{ParameterPanel::tr("every row"), {}, false};
  if (isChosenWhereOpen(parameter)) return chosenOversampling(scene, known);
  return fromFile(parameter,
                  isWholeNumber(parameter) ? static_cast<double>(known.elements) : known.length);
}

ParameterValue resetValue(const Parameter& parameter, const Scene& scene) {
  if (!mayBeLeftOpen(parameter, scene)) return defaultValue(parameter);
  return isWholeNumber(parameter) ? ParameterValue(std::int64_t{0}) : ParameterValue(0.0);
}

void assignValue(const Parameter& parameter, Scene& scene, const ParameterValue& value) {
  if (isMaterial(parameter) && std::holds_alternative<std::string>(value))
    useMaterial(scene, std::get<std::string>(value));
  else if (mayBeLeftOpen(parameter, scene) && value == resetValue(parameter, scene))
    clearValue(parameter, scene);
  else
    setValue(parameter, scene, value);
}

void assignText(const Parameter& parameter, Scene& scene, std::string_view text) {
  if (isMaterial(parameter))
    useMaterial(scene, std::string(text));
  else if (mayBeLeftOpen(parameter, scene) && (text.empty() || text == "0"))
    clearValue(parameter, scene);
  else if (text.empty() && !zeroText(parameter).isEmpty())
    setFromText(parameter, scene, "0");
  else
    setFromText(parameter, scene, text);
}

bool isChosenWhereOpen(const Parameter& parameter) {
  return parameter.zero == ZeroMeaning::ChosenByScene;
}

bool isFile(const Parameter& parameter) {
  return hasContent(parameter, TextContent::File);
}

bool isMaterial(const Parameter& parameter) {
  return hasContent(parameter, TextContent::Material);
}

bool isLongText(const Parameter& parameter) {
  return hasContent(parameter, TextContent::Sentences);
}

Missing missingValue(const Scene& scene) {
  if (scene.surface.kind == SurfaceKind::Profile && scene.surface.file.empty())
    return {kFile, ParameterPanel::tr("choose a profile file")};
  if (hasSurfaceFile(scene.surface) && scene.surface.file.empty())
    return {kFile, ParameterPanel::tr("choose a file")};
  if (scene.surface.kind == SurfaceKind::Spectrum &&
      scene.surface.spectrumKind == SpectrumKind::Unstated)
    return {kSpectrumKind, ParameterPanel::tr("choose the kind of spectrum")};
  return {};
}

RememberedSizes::RememberedSizes(const Surface& surface)
    : others_{Surface{}.length, Surface{}.elements} {
  sizeOf(surface) = {surface.length, surface.elements};
}

LineSize& RememberedSizes::sizeOf(const Surface& surface) {
  return hasSurfaceFile(surface) ? fromFile_ : others_;
}

void RememberedSizes::update(const Surface& before, Surface& next) {
  if (hasSurfaceFile(before) == hasSurfaceFile(next)) return;
  sizeOf(before) = {before.length, before.elements};
  const LineSize& size = sizeOf(next);
  next.length = size.length;
  next.elements = size.elements;
}

void updateRealizations(const Scene& before, Scene& next) {
  const Parameter& row = *findParameter(kRealizations);
  const bool wasOpen = isTakenFromSurfaceFile(row, before, 0),
             isOpen = isTakenFromSurfaceFile(row, next, 0);
  if (wasOpen != isOpen) next.ensemble.realizations = isOpen ? 0 : Ensemble{}.realizations;
  // One row is one line.
  if (isOpen && next.surface.reading.row > 0)
    next.ensemble.realizations = std::min<std::int64_t>(next.ensemble.realizations, 1);
}

}  // namespace asperity
