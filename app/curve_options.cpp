#include "app/curve_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

#include "app/command_options.h"
#include "app/output.h"
#include "app/progress_bar.h"
#include "core/accuracy/compute_curve.h"
#include "core/accuracy/target_curve.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/named_choices.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/chart/curve_words.h"
#include "core/fit/friction_data.h"
#include "core/friction/curve_file.h"
#include "core/scene/list_text.h"
#include "core/scene/parameters.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_assignments.h"
#include "core/scene/scene_check.h"
#include "core/scene/scene_file.h"
#include "core/scene/sweep.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr const char *kAxes = "--axes", *kCompare = "--compare", *kWith = "--with",
                     *kData = "--data", *kTheory = "--theory";
constexpr const char *kXRange = "--x-range", *kYRange = "--y-range";
constexpr const char *kOver = "--over", *kY = "--y", *kXScale = "--x-scale", *kYScale = "--y-scale",
                     *kFamily = "--family";
constexpr std::int64_t kMaxFamily = 100;
constexpr std::int64_t kMaxOversampling = 64;
constexpr NamedChoices<CurveAxes, 2> kAxesNames{
    {{"physical", CurveAxes::Physical}, {"dimensionless", CurveAxes::Dimensionless}}};

[[noreturn]] void refuseComparison(const std::string& text) {
  throw InputError("", kCompare,
                   message("{} is not SCHEME[:OVERSAMPLING[:LINES]] with nodal, linear or cubic, "
                           "1 to {} (nodal: 1) and 1 line or more",
                           shortened(text), kMaxOversampling));
}

std::int64_t wholeFrom(std::string_view part, const std::string& all, std::int64_t most) {
  std::int64_t number = 0;
  if (!readNumber(part, number) || number < 1 || number > most) refuseComparison(all);
  return number;
}

CurveSetting settingFrom(const std::string& text, const Scene& scene) {
  const std::vector<std::string_view> parts = splitText(text, ":");
  const auto& schemes = std::get<ChoiceField>(findParameter("accuracy.scheme")->field).choices;
  const auto& lines = std::get<IntegerField>(findParameter("ensemble.realizations")->field);
  CurveSetting setting;
  const auto found = std::find(schemes.begin(), schemes.end(), parts[0]);
  if (found == schemes.end() || parts.size() > 3) refuseComparison(text);
  setting.scheme = static_cast<Scheme>(found - schemes.begin());
  const bool isNodal = setting.scheme == Scheme::Nodal;
  if (isNodal) setting.oversampling = 1;
  if (parts.size() > 1)
    setting.oversampling = wholeFrom(parts[1], text, isNodal ? 1 : kMaxOversampling);
  setting.realizations = mayHaveManyLines(scene.surface) ? scene.ensemble.realizations : 1;
  if (parts.size() > 2) setting.realizations = wholeFrom(parts[2], text, lines.maximum);
  return setting;
}

CurveAxes axesFrom(const std::string& name) {
  return chosen(kAxesNames, name, kAxes);
}

/// Reads a range of an axis. Throws InputError where the axis cannot show an end.
NumberRange axisRange(const char* option, const std::string& text, AxisScale scale) {
  const NumberRange range = rangeFrom(option, text, "");
  if (scale == AxisScale::Logarithmic && !(range.from > 0))
    throw InputError("", option, shortened(text) + " is not above 0 on a logarithmic axis");
  return range;
}

CurveQuantity quantityFrom(const std::string& word) {
  if (const auto quantity = findQuantity(word)) return *quantity;
  throw InputError("", kY, notOneOf(word, quantityWords()));
}

/// Sets axes, quantity, scales and ranges. Throws InputError naming the option.
void setAxes(CurveSet& set, const CurveArguments& arguments) {
  set.axes = axesFrom(arguments.axes);
  set.y = quantityFrom(arguments.y);
  if (set.axes == CurveAxes::Dimensionless && set.y != CurveQuantity::Mu)
    throw InputError("", kY, "belongs to physical axes; dimensionless ones show mu over the slope");
  if (set.axes == CurveAxes::Dimensionless && !set.isOfVelocity())
    throw InputError(
        "", kAxes,
        message("dimensionless goes over velocities, not over {}", set.present.scene.sweep.key));
  if (!arguments.xScale.empty()) set.xScale = chosen(kAxisScales, arguments.xScale, kXScale);
  if (!arguments.yScale.empty()) set.yScale = chosen(kAxisScales, arguments.yScale, kYScale);
  if (!arguments.xRange.empty()) {
    const NumberRange range = axisRange(kXRange, arguments.xRange, set.scaleOfX());
    set.xFrom = range.from;
    set.xTo = range.to;
  }
  if (!arguments.yRange.empty()) {
    const NumberRange range = axisRange(kYRange, arguments.yRange, set.scaleOfY());
    set.yFrom = range.from;
    set.yTo = range.to;
  }
}

/// Returns the scene with the assignments applied.
Scene sceneWith(const Scene& scene, const std::string& assignments) {
  const std::vector<std::string> each = separatedAssignments(assignments);
  for (const std::string& assignment : each)
    if (each.size() > 1 && assignment.find('=') == std::string::npos)
      throw InputError("", kWith,
                       message("'{}' between two ; is not KEY=VALUE; a ; that belongs to a "
                               "value is written \\;",
                               shortened(assignment)));
  try {
    Scene other = changedScene(scene, each, kWith);
    if (other.sliding.kind != scene.sliding.kind) requireSteadySliding(other, "a curve");
    if (other.sweep.key != scene.sweep.key)
      throw InputError("", "sweep.key", "all curves of a chart go over the same key");
    return other;
  } catch (const InputError& error) {
    throw InputError(kWith, error.key(), error.message());
  }
}

/// Returns the range of a family. Throws InputError naming the option or the key.
ParameterRange familyRange(const CurveArguments& arguments, const Scene& scene) {
  const ParameterRange range = parseRangeOption(kFamily, arguments.family);
  if (range.key() == scene.sweep.key)
    throw InputError("", kFamily, message("{} is the axis of the curves already", range.key()));
  if (Message reason = whyNotBeside(*range.row, scene, sweepRange(scene)); !reason.empty())
    throw InputError("", kFamily, std::move(reason));
  checkRange(range, scene);
  if (range.points > kMaxFamily)
    throw InputError("", kFamily, message("{} curves are more than {}", range.points, kMaxFamily));
  return range;
}

/// A curve of a family, not yet computed.
struct FamilyMember {
  double value;
  Scene scene;
};

std::vector<FamilyMember> familyMembers(const CurveArguments& arguments, const Scene& scene) {
  std::vector<FamilyMember> members;
  if (arguments.family.empty()) return members;
  const ParameterRange range = familyRange(arguments, scene);
  for (const double value : rangeValues(range)) try {
      members.push_back(
          {value, sceneWith(scene, std::string(range.key()) + "=" + fmt::format("{}", value))});
    } catch (const InputError& error) {
      throw InputError(kFamily, error.key(), error.message());
    }
  return members;
}

}  // namespace

const char* CurveArguments::firstOption() const {
  return firstGiven({{kOver, !over.empty()},
                     {kAxes, axes != "physical"},
                     {kY, y != "mu"},
                     {kXScale, !xScale.empty()},
                     {kYScale, !yScale.empty()},
                     {kFamily, !family.empty()},
                     {kXRange, !xRange.empty()},
                     {kYRange, !yRange.empty()},
                     {kCompare, !compare.empty()},
                     {kData, !data.empty()},
                     {kTheory, !theory.empty()},
                     {kWith, !with.empty()}});
}

bool CurveArguments::hasMore(const Scene& scene) const {
  const Comparisons none;
  return !compare.empty() || !with.empty() || !family.empty() || !(scene.comparison == none);
}

void CurveArguments::addTo(nlohmann::ordered_json& picture) const {
  if (axes != "physical") picture["axes"] = axes;
  if (y != "mu") picture["y"] = y;
  if (!xScale.empty()) picture["x_scale"] = xScale;
  if (!yScale.empty()) picture["y_scale"] = yScale;
  if (!xRange.empty()) picture["x_range"] = xRange;
  if (!yRange.empty()) picture["y_range"] = yRange;
  if (!compare.empty()) picture["compared_with"] = compare;
  if (!family.empty()) picture["family"] = family;
  if (!with.empty()) picture["with"] = with;
}

void addCurveOptions(CLI::App& command, CurveArguments& arguments) {
  command
      .add_option(kOver, arguments.over,
                  "Go over another key than velocity: any number that changes friction, such as "
                  "load.normal_force=1mN:10N:41; logarithmic where the key's slider is, unless "
                  ":log or :linear says otherwise")
      ->type_name("KEY=FROM:TO:N");
  command
      .add_option(kFamily, arguments.family,
                  "Add one curve for each value of a second key, such as "
                  "elastomer.temperature=280:320:5")
      ->type_name("KEY=FROM:TO:N");
  command
      .add_option(
          kY, arguments.y,
          "What the vertical axis shows: mu, mu_total (with local friction), normalized_mu, "
          "contact_fraction, rms_slope_contact, indentation, tangential_force, power or "
          "mean_pressure")
      ->type_name("QUANTITY")
      ->capture_default_str();
  command
      .add_option(
          kCompare, arguments.compare,
          "Compute the curve in a second way on the same lines and show the difference below "
          "it and in tables: nodal, linear or cubic, points per element, lines")
      ->type_name("SCHEME[:OVERSAMPLING[:LINES]]");
  mayRepeat(command.add_option(
                kWith, arguments.with,
                "Add the curve of the scene with these keys set; write a ; inside a value as "
                "\\;; may be repeated"))
      ->type_name("KEY=VALUE[;KEY=VALUE...]");
  mayRepeat(command.add_option(
                kData, arguments.data,
                "Show measured friction: a table of velocity and mu, where known with mu_error, "
                "normal_force or nominal_pressure, temperature, label; may be repeated"))
      ->type_name("FILE");
  command
      .add_option(kTheory, arguments.theory,
                  "Theories beside the curve, separated by commas: eq_11, gaussian_foundation, "
                  "complete_contact, persson_half_space; or none")
      ->type_name("WORDS");
  command
      .add_option(kAxes, arguments.axes,
                  "physical, or dimensionless: Eq. (13), and mu over the rms slope")
      ->capture_default_str()
      ->group(kPictureGroup);
  command
      .add_option(kXScale, arguments.xScale, "log or linear (default: as the values are spaced)")
      ->type_name("SCALE")
      ->group(kPictureGroup);
  command.add_option(kYScale, arguments.yScale, "log or linear (default: log)")
      ->type_name("SCALE")
      ->group(kPictureGroup);
  command
      .add_option(kXRange, arguments.xRange,
                  "Limits of the x-axis, in its unit (default: automatic)")
      ->type_name("FROM:TO")
      ->group(kPictureGroup);
  command.add_option(kYRange, arguments.yRange, "Limits of the vertical axis (default: automatic)")
      ->type_name("FROM:TO")
      ->group(kPictureGroup);
}

ComparedScene withCurveOptions(Scene scene, const CurveArguments& arguments) {
  if (!arguments.over.empty()) try {
      scene = changedScene(sceneOver(parseRangeOption(kOver, arguments.over), scene), {}, "");
    } catch (const InputError& error) {
      throw error.key() == kOver ? error : InputError(kOver, error.key(), error.message());
    }
  std::vector<FrictionData> given = addComparisonData(scene, arguments.data);
  if (arguments.theory.empty()) return {std::move(scene), std::move(given)};
  nlohmann::ordered_json words = nlohmann::ordered_json::array();
  std::istringstream list(arguments.theory);
  for (std::string word; std::getline(list, word, ',');)
    if (word != "none") words.push_back(word);
  scene.comparison.theory = parseTheories(jsonLine(words), kTheory);
  return {std::move(scene), std::move(given)};
}

void checkCurves(const CurveArguments& arguments, const Scene& scene) {
  CurveSet set;
  set.present.scene = scene;
  setAxes(set, arguments);
  if (!arguments.compare.empty()) {
    settingFrom(arguments.compare, scene);
    requireVelocityAxis(scene, kCompare);
    requireNoTarget(scene, "--compare needs the same resolution at every velocity");
  }
  familyMembers(arguments, scene);
  for (const std::string& assignments : arguments.with) sceneWith(scene, assignments);
}

std::vector<std::filesystem::path> filesReadBeside(const CurveArguments& arguments,
                                                   const Scene& scene) {
  std::vector<std::filesystem::path> files;
  for (const std::string& assignments : arguments.with)
    for (const std::filesystem::path& file : filesReadBy(sceneWith(scene, assignments)))
      files.push_back(file);
  return files;
}

void checkUseful(const CurveArguments& arguments, const std::vector<std::string>& files) {
  if (!std::ranges::all_of(files, isTableFile)) return;
  refuseGiven({{kAxes, arguments.axes != "physical"},
               {kXScale, !arguments.xScale.empty()},
               {kYScale, !arguments.yScale.empty()},
               {kXRange, !arguments.xRange.empty()},
               {kYRange, !arguments.yRange.empty()}},
              "belongs to pictures, and no output is one");
}

Curve computeCurve(const Scene& scene, const CommonOptions& common, RealizationTable* lines) {
  ProgressBar bar(Words::tr("realizations"), common.quiet);
  CurveOptions options{.threads = common.threads};
  options.progress = [&bar](const CurveProgress& progress) {
    bar.show(progress.realizationsDone, progress.realizationsTotal);
  };
  if (lines)
    options.eachLine = [lines](std::int64_t realization, std::span<const SteadyResult> results) {
      lines->add(realization, results);
    };
  return computeCurve(scene, options);
}

namespace {

/// Returns the curves without points, measured friction and differences.
CurveSet curvesWithoutPoints(const CurveArguments& arguments, const Scene& scene) {
  CurveSet set;
  set.present = {{}, scene, {}, 0};
  setAxes(set, arguments);
  const auto add = [&set](Message name, const Scene& other, double familyValue) {
    const int index = static_cast<int>(set.pinned.size());
    set.pinned.push_back({std::move(name), other, {}, index, index + 1, familyValue});
  };
  for (const FamilyMember& member : familyMembers(arguments, scene)) {
    set.familyKey = parseRangeOption(kFamily, arguments.family).key();
    set.isLawNamed = !arguments.theory.empty() && showsLaw(scene);
    add(describeParameter(set.familyKey, member.scene), member.scene, member.value);
  }
  for (const std::string& assignments : arguments.with) {
    const Scene other = sceneWith(scene, assignments);
    const Message words = describeDifferences(other, scene);
    add(words.empty() ? Message("same parameters") : words, other, kNotApplicable);
  }
  return set;
}

/// Returns a point of a flat line of friction, on both kinds of axes.
CurvePoint flatPoint(double velocity) {
  CurvePoint point;
  point.velocity = point.dimensionlessVelocity = velocity;
  point.mu = point.muLaw = point.normalizedMu = 1;
  point.realizations = 1;
  return point;
}

}  // namespace

CurveSet plannedCurveSet(const CurveArguments& arguments, const ComparedScene& compared) {
  CurveSet set = curvesWithoutPoints(arguments, compared.scene);
  // Over another key a table may have no row that is shown, and nothing is compared.
  if (!set.isOfVelocity()) return set;
  const std::vector<double> velocities = sweepVelocities(compared.scene.sweep);
  std::vector<CurvePoint> flat;
  for (const double velocity : velocities) flat.push_back(flatPoint(velocity));
  set.present.points = flat;
  for (NamedCurve& other : set.pinned) other.points = flat;
  for (FrictionData& data : readComparisonData(compared.scene, compared.given)) {
    MeasuredCurve measured{std::move(data), {}, {}};
    for (const MeasuredPoint& point : measured.data.points) {
      measured.abscissas.push_back(point.velocity);
      measured.computed.push_back(flatPoint(point.velocity));
    }
    set.measured.push_back(std::move(measured));
  }
  if (arguments.compare.empty()) return set;
  CurveDifference& difference = set.difference.emplace();
  difference.setting = settingFrom(arguments.compare, compared.scene);
  for (const double velocity : velocities) difference.points.push_back({velocity});
  return set;
}

void ComputedCurves::requireTargets() const {
  if (missed) throw TextError(*missed);
}

ComputedCurves makeCurveSet(const CurveArguments& arguments, const ComparedScene& compared,
                            Curve own, const CommonOptions& common) {
  const Scene& scene = compared.scene;
  ComputedCurves curves{curvesWithoutPoints(arguments, scene), missedTarget(own)};
  CurveSet& set = curves.set;
  set.present.points = std::move(own.points);
  for (NamedCurve& other : set.pinned) {
    Curve curve = computeCurve(other.scene, common);
    if (const auto missed = missedTarget(curve))
      curves.missed = curves.missed ? message("{}; {}: {}", *curves.missed, other.name,
                                              printed(curve.achievedError, 2))
                                    : message("{}: {}", other.name, *missed);
    other.points = std::move(curve.points);
  }
  if (hasComparisons(set))
    addComparisons(set, readComparisonData(scene, compared.given), {.threads = common.threads});
  if (arguments.compare.empty()) return curves;
  ProgressBar bar(Words::tr("lines compared"), common.quiet);
  DifferenceOptions options;
  options.threads = common.threads;
  options.progress = [&bar](const CurveDifference& part) { bar.show(part.done, part.total); };
  set.difference = curveDifference(scene, settingFrom(arguments.compare, scene), options);
  return curves;
}

namespace {

/// Returns the points of a table of measured friction, with the friction that was computed at them.
nlohmann::ordered_json measuredPoints(const MeasuredCurve& measured) {
  auto points = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < measured.data.points.size(); ++i) {
    const MeasuredPoint& point = measured.data.points[i];
    const double mu = measured.computedMu(i);
    points.push_back({{"velocity", point.velocity},
                      {"mu_measured", point.mu},
                      {"mu_error", numberOrNull(point.muError)},
                      {"normal_force", numberOrNull(point.normalForce)},
                      {"nominal_pressure", numberOrNull(point.nominalPressure)},
                      {"temperature", numberOrNull(point.temperature)},
                      {"label", point.label},
                      {"mu", numberOrNull(mu)},
                      {"measured_over_computed", numberOrNull(point.mu / mu)}});
  }
  return points;
}

}  // namespace

void addCurvesTo(nlohmann::ordered_json& answer, const CurveSet& set) {
  for (const NamedCurve& curve : set.pinned) {
    nlohmann::ordered_json other{{"name", curve.name.english()}};
    if (std::isfinite(curve.familyValue)) other[set.familyKey] = curve.familyValue;
    other["points"] =
        tableJson(curveTable(curve.points, columnsFor(curve.scene, showsForces(set))));
    answer[std::isfinite(curve.familyValue) ? "family" : "with"].push_back(std::move(other));
  }
  for (const TheoryCurve& theory : set.theories) {
    const TheoryEntry& entry = theoryEntry(theory.theory);
    auto points = nlohmann::ordered_json::array();
    for (const TheoryPoint& point : theory.points) {
      nlohmann::ordered_json one;
      if (!set.isOfVelocity()) one[columnOfKey(set.present.scene.sweep.key)] = point.swept;
      one.update({{"velocity", point.velocity},
                  {"mu", numberOrNull(point.mu)},
                  {"contact_fraction", numberOrNull(point.contactFraction)},
                  {"in_range", point.isInRange}});
      points.push_back(std::move(one));
    }
    answer["theories"].push_back({{"theory", theoryWords()[static_cast<std::size_t>(entry.theory)]},
                                  {"name", entry.name},
                                  {"range", entry.range},
                                  {"points", std::move(points)}});
  }
  for (const MeasuredCurve& measured : set.measured)
    answer["measured"].push_back(
        {{"name", measured.data.name}, {"points", measuredPoints(measured)}});
  if (!set.difference) return;
  auto points = nlohmann::ordered_json::array();
  for (const DifferencePoint& point : set.difference->points)
    points.push_back({{"velocity", point.velocity},
                      {"mu", numberOrNull(point.mu)},
                      {"mu_standard_error", numberOrNull(point.muStandardError)},
                      {"relative_difference", numberOrNull(point.relative)},
                      {"relative_difference_standard_error", numberOrNull(point.standardError)}});
  answer["compared"] = {{"setting", settingName(set.difference->setting).english()},
                        {"points", std::move(points)}};
}

}  // namespace asperity
