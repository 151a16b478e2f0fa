// asperity figure: computes the paper's figures again, each with its data and picture, and compares
// the paper's claims about it with the results.
#include "core/paper/figure.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/headless_pictures.h"
#include "app/progress_bar.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "ui/chart/diagram_picture.h"
#include "ui/chart/figure_drawing.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/figures/claims_table.h"

namespace asperity {
namespace {

/// Returns the figures that a word means: a single figure, "paper" for Figs. 1 to 6, "all" for
/// these and the two that the paper does not have.
std::vector<FigureName> figureNames(const std::string& word) {
  std::vector<FigureName> names;
  std::vector<std::string_view> words;
  for (const FigureEntry& entry : figureEntries()) {
    if (entry.word == word) return {entry.name};
    words.push_back(entry.word);
    if (word == "all" || entry.name < FigureName::Master) names.push_back(entry.name);
  }
  if (word == "all" || word == "paper") return names;
  words.insert(words.end(), {"paper", "all"});
  throw InputError("", "NAME", notOneOf(word, words));
}

/// Returns each figure once, in the order given.
std::vector<FigureName> figureNames(const std::vector<std::string>& words) {
  std::vector<FigureName> names;
  for (const std::string& word : words)
    for (const FigureName name : figureNames(word))
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

std::string figureOutput(const FigureCommand& command, FigureName name, const char* extension) {
  return fileIn(command.output, fmt::format("figure_{}{}", figureEntry(name).word, extension));
}

std::string claimsFile(const FigureCommand& command) {
  return fileIn(command.output, "claims.json");
}

/// Checks everything that can be wrong with the output before any work begins.
void prepareFolder(const FigureCommand& command, const std::vector<FigureName>& names) {
  makeFolder(command.output);
  for (const FigureName name : names)
    for (const char* extension : {".csv", ".png", ".svg", ".pdf"})
      checkWritable(figureOutput(command, name, extension));
  checkWritable(claimsFile(command));
}

/// Throws InputError where a column is of none of the figures.
ColumnChoice columnChoice(const FigureCommand& command, const std::vector<FigureName>& names) {
  std::vector<std::string> tables;
  for (const FigureName name : names)
    tables.push_back(fmt::format("figure {}", figureEntry(name).word));
  return {command.columns, {tables.begin(), tables.end()}};
}

void writeFigure(const FigureCommand& command, const Figure& figure, HeadlessPictures& pictures) {
  const auto pictureOptions = [&](const char* extension) {
    nlohmann::ordered_json options = optionsFor(command.common.given, extension);
    options["name"] = figureEntry(figure.name).word;
    if (!command.common.assignments.empty()) options["set"] = command.common.assignments;
    return options;
  };
  {
    const ProvenanceOptions given(pictureOptions(".csv"));
    writeFileAtomically(
        figureOutput(command, figure.name, ".csv"),
        columnChoice(command, figureNames(command.names))
            .selectAvailable(provenanceComment("figure", figure.scene) + figure.csv));
  }
  const PictureSettings settings = pictureSettings(command.picture, printDefaults(figure.sheet));
  Figure shown = figure;
  shown.sheet = styled(figure.sheet, settings.style);
  DiagramOptions options = settings.diagramOptions();
  if (settings.isOnPaper && !shown.sheet.diagrams.empty())
    options.height = heightInPrint(shown.sheet, options);
  DrawList picture = composeFigure(shown, contactFrame(figure).get(), options);
  if (settings.style.isGrey) removeColours(picture);
  const ProvenanceOptions given(pictureOptions(".png"));
  const PictureProperties properties =
      settings.properties(translated(figure.sheet.title), pictureOrigin("figure", figure.scene));
  for (const char* extension : {".png", ".svg", ".pdf"})
    pictures.write(figureOutput(command, figure.name, extension), picture, properties);
}

std::string claimLines(const Figure& figure) {
  std::string text;
  for (const Claim& claim : figure.claims) {
    const std::string measured = std::isfinite(claim.measured.value)
                                     ? estimateText(claim.measured).toStdString()
                                     : Words::tr("not measured");
    text += fmt::format("  {}: {}\n      {}: {}\n", verdictText(claim).toStdString(),
                        translated(claim.claim), translated(claim.quantity), measured);
  }
  return text;
}

struct ComputedFigures {
  std::vector<Figure> figures;
  std::vector<double> seconds;
};

ComputedFigures makeFigures(const FigureCommand& command, const std::vector<FigureName>& names) {
  ComputedFigures made;
  HeadlessPictures pictures(pictureSettings(command.picture).backend);
  for (const FigureName name : names) {
    const auto start = std::chrono::steady_clock::now();
    ProgressBar bar(filled(Words::tr("figure %1"), {std::string(figureEntry(name).word)}),
                    command.common.quiet);
    FigureOptions options{.realizations = command.realizations,
                          .assignments = command.common.assignments,
                          .threads = command.common.threads,
                          .progress = [&bar](double part) { bar.showPart(part); }};
    writeFigure(command, made.figures.emplace_back(makeFigure(name, options)), pictures);
    made.seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  pictures.finish();
  return made;
}

std::string summaryText(const FigureCommand& command, const ComputedFigures& made) {
  double total = 0;
  for (const double seconds : made.seconds) total += seconds;
  std::string text;
  for (std::size_t i = 0; i < made.figures.size(); ++i) {
    const Figure& figure = made.figures[i];
    text += fmt::format("{}\n{}", translated(figure.sheet.title), claimLines(figure));
    if (made.figures.size() > 1)
      text += "  " + filledLine(Words::tr("%1 % of the run time"),
                                fmt::format("{:.0f}", 100 * made.seconds[i] / total));
  }
  for (const Figure& figure : made.figures)
    text += wroteLine(figureOutput(command, figure.name, ".csv") + " (.png, .svg, .pdf)");
  return text + wroteLine(claimsFile(command));
}

}  // namespace

int runFigure(const FigureCommand& command) {
  const std::vector<FigureName> names = figureNames(command.names);
  FigureOptions options{.realizations = command.realizations,
                        .assignments = command.common.assignments};
  for (const FigureName name : names) figureScene(name, options);
  for (const FigureName name : names) {
    // A picture of a contact has none of the parts of charts.
    if (name == FigureName::Contact)
      refuseChartOptions(command.picture, "applies only to charts, and this figure is a contact");
  }
  pictureSettings(command.picture);
  columnChoice(command, names);
  prepareFolder(command, names);
  const ComputedFigures made = makeFigures(command, names);
  const std::string claims = claimsJson(made.figures);
  writeFileAtomically(claimsFile(command), claims);
  printSummary(command.common, summaryText(command, made));
  if (command.common.json) fmt::print("{}", claims);
  return kDone;
}

}  // namespace asperity
