#include "app/command_table.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <utility>

#include "app/batch/batch_file.h"
#include "core/base/input_error.h"
#include "core/lesson/lesson_file.h"
#include "core/material/material_options.h"
#include "core/material/prony_fit.h"
#include "core/paper/figure.h"
#include "core/study/study_file.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr const char* kLastLanguage = "the one used last, or that of the desktop";

void addColumnChoice(CLI::App* command, std::string& columns) {
  command
      ->add_option("--columns", columns,
                   "Columns of tables, in this order, separated by commas ('asperity columns' "
                   "lists them; default: all)")
      ->type_name("NAMES")
      ->group(kTableGroup);
}

std::string keysFooter(const char* command) {
  return fmt::format(
      "Keys of a scene for --set, with their ranges and units: asperity {} --help keys", command);
}

void addOutputs(CLI::App* command, std::vector<std::string>& outputs, const char* sentence) {
  mayRepeat(command->add_option("-o,--output", outputs, sentence));
}

void addTimeOptions(CLI::App& command, TimeArguments& time) {
  setIntegerRange(
      command.add_option("--frames", time.frames,
                         fmt::format("Number of frames (default: {0} per period, or {0} for a "
                                     "motion)",
                                     kDefaultFrames)),
      1, 1000000);
  setNumberRange(command.add_option("--fps", time.framesPerSecond,
                                    fmt::format("Frames per second of film (default: {})",
                                                kDefaultFramesPerSecond)),
                 0.001, 1000);
  setNumberRange(command.add_option("--duration", time.duration,
                                    "Length of the film in seconds, instead of --frames"),
                 0.001, 1e6, "s");
  setNumberRange(command.add_option("--cycles", time.cycles,
                                    "Number of periods of the line that pass (default: 1)"),
                 1e-6, 1e6);
  setNumberRange(
      command.add_option("--slow-motion", time.slowMotion, "Seconds of film per simulated second"),
      1e-12, 1e15);
  setNumberRange(
      command.add_option("--at", time.at,
                         "One picture, after this time of sliding (default: the start of steady "
                         "sliding, the end of a motion)"),
      0, 1e12, "s");
  setNumberRange(command.add_option(
                     "--slid", time.slid,
                     "One picture of steady sliding, after this sliding distance, instead of --at"),
                 0, 1e12, "m");
}

/// Adds the options of material_options.h.
void addMaterialOptions(CLI::App& command, WrittenOptions& options) {
  const auto add = [&](const char* option, const char* sentence) {
    return command.add_option_function<std::string>(
        option,
        [&options, option](const std::string& value) { options.emplace_back(option, value); },
        sentence);
  };
  const auto addFlag = [&](const char* option, const char* sentence) {
    command.add_flag_callback(
        option, [&options, option] { options.emplace_back(option, "true"); }, sentence);
  };
  add("--reference-temperature",
      "Temperature of the master curve, such as 20C (default: 25C where it was measured, else "
      "the isotherm nearest to it)");
  setIntegerRange(
      add("--terms", "Number of relaxation times (default: as few as reach the smallest residual)"),
      1, kMaxTerms);
  addFlag("--vertical-shifts", "Shift the moduli as well, which a scene does not use");
  add("--shift", "Shift with temperature in material.json: auto, wlf, arrhenius or table")
      ->default_str("auto");
  add("--modulus", "What was measured: auto (by the columns), shear or tension")
      ->default_str("auto");
  setNumberRange(
      add("--poisson-ratio", "Poisson's ratio, to convert moduli of tension: G = E / (2 (1 + nu))")
          ->default_str(fmt::format("{}", MaterialChoices{}.columns.poissonRatio)),
      0, kMaxPoissonRatio);
  add("--temperature",
      "Temperature of a file that does not state one, such as 20C; of a series stated at several, "
      "the one to read");
  setNumberRange(add("--temperature-tolerance", "Rows closer in temperature are one isotherm")
                     ->default_str(fmt::format("{}", MaterialChoices{}.temperatureTolerance)),
                 kMinTemperatureTolerance, kMaxTemperatureTolerance, "K");
  mayRepeat(command.add_option_function<std::vector<std::string>>(
      "--leave-out",
      [&options](const std::vector<std::string>& values) {
        for (const std::string& value : values) options.emplace_back("--leave-out", value);
      },
      "Temperature of an isotherm that is not used; may be repeated"));
  add("--equilibrium-modulus",
      "Shear modulus in equilibrium, such as 2MPa, instead of the fitted one");
  add("--instantaneous-modulus",
      "Instantaneous shear modulus G_0, for a series of relative moduli");
  addFlag("--liquid", "Allow an equilibrium modulus of 0, with which nothing slides steadily");
  for (const char* column :
       {"--frequency-column", "--temperature-column", "--storage-column", "--loss-column",
        "--tan-delta-column", "--magnitude-column", "--phase-column", "--strain-column"})
    add(column, "Name or number of the column");
  add("--strain", "Strain amplitude to read, such as 1%, of a file with several");
  add("--frequency-unit", "Hz or rad/s, instead of the file's");
  add("--temperature-unit", "C, K or F, instead of the file's");
  add("--modulus-unit",
      "Pa, kPa, MPa or GPa, instead of the file's; viscosities are in it times s, compliances in "
      "1/it");
  add("--name", "Name of the material (default: that of the file)");
  add("--source", "Where the numbers come from, kept in material.json");
}

}  // namespace

void CommandTable::declareIn(CLI::App& app, std::string_view word,
                             std::function<int(const OpenCommand&)> remake) {
  app_ = &app;
  remake_ = std::move(remake);
  app.add_option("SCENE", window_.scene, "Scene file (JSON) to open in the window");
  addShared(app, window_, kLastLanguage);
  using Command = std::pair<const char*, void (CommandTable::*)(const char* name)>;
  static constexpr Command kCommands[] = {
      {"check", &CommandTable::addCheck},       {"curve", &CommandTable::addCurve},
      {"map", &CommandTable::addMap},           {"sensitivity", &CommandTable::addSensitivity},
      {"cutoff", &CommandTable::addCutoff},     {"motion", &CommandTable::addMotion},
      {"render", &CommandTable::addRender},     {"surface", &CommandTable::addSurface},
      {"material", &CommandTable::addMaterial}, {"fit", &CommandTable::addFit},
      {"figure", &CommandTable::addFigure},     {"open", &CommandTable::addOpen},
      {"batch", &CommandTable::addBatch},       {"study", &CommandTable::addStudy},
      {"accuracy", &CommandTable::addAccuracy}, {"explain", &CommandTable::addExplain},
      {"columns", &CommandTable::addColumns},   {"lesson", &CommandTable::addLesson}};
  const bool isCommand = std::ranges::find(kCommands, word, &Command::first) != std::end(kCommands);
  for (const auto& [name, add] : kCommands)
    if (!isCommand || word == name) (this->*add)(name);
}

int CommandTable::run() const {
  return selected_ ? selected_() : runWindowCommand(window_);
}

void CommandTable::addShared(CLI::App& app, CommonOptions& common, const char* defaultLanguage) {
  mayRepeat(app.add_option("--set", common.assignments,
                           "Set a scene key, e.g. --set load.normal_force=0.1; may be repeated, "
                           "the last value of a key counts"))
      ->type_name("KEY=VALUE");
  addSharedWithoutScene(app, common, defaultLanguage);
}

void CommandTable::addSharedWithoutScene(CLI::App& app, CommonOptions& common,
                                         const char* defaultLanguage) {
  common_.push_back(&common);
  setIntegerRange(app.add_option("--threads", common.threads,
                                 "Number of threads; 0: as many as the machine has"),
                  0, 1024);
  if (&app != app_) {  // the command that opens the window prints nothing
    app.add_flag("--quiet", common.quiet, "Show neither progress nor summary");
    app.add_flag("--json", common.json, "Write the answer as JSON to standard output");
  }
  app.add_flag("--timing", common.timing, "Write the run time to standard error");
  app.add_option("--language", common.language,
                 fmt::format("Language of pictures and summaries: {} (default: {})",
                             languageCodes(), defaultLanguage));
}

CLI::App* CommandTable::addCommand(const char* name, const char* sentence,
                                   std::function<int()> action) {
  CLI::App* command = app_->add_subcommand(name, sentence);
  command->callback([this, action = std::move(action)] { selected_ = action; });
  return command;
}

CLI::App* CommandTable::addSceneCommand(const char* name, const char* sentence,
                                        CommonOptions& common, std::function<int()> action) {
  CLI::App* command = addCommand(name, sentence, std::move(action));
  command
      ->add_option("SCENE", common.scene,
                   "Scene file (JSON), or the name of a shipped scene (figure_1)")
      ->required();
  addShared(*command, common);
  command->footer(keysFooter(name));
  return command;
}

void CommandTable::addCheck(const char* name) {
  CLI::App* command = addCommand(name, "Read scenes, check them, and print what they describe",
                                 [this] { return runCheck(check_); });
  command
      ->add_option("SCENE", check_.scenes,
                   "Scene files (JSON), names of shipped scenes, or - for standard input")
      ->required();
  addShared(*command, check_.common);
  command->footer(keysFooter(name));
}

void CommandTable::addCurve(const char* name) {
  CLI::App* command =
      addSceneCommand(name, "Friction over velocity, averaged over the realizations", curve_.common,
                      [this] { return runCurve(curve_); });
  addOutputs(command, curve_.outputs,
             "FILE.csv (its first line, # asperity: ..., says how it was made), .json, .png, .svg "
             "or .pdf; may be repeated (default: CSV to standard output)");
  addCurveOptions(*command, curve_.curves);
  addPictureOptions(*command, curve_.picture, {1200, 800, "print"}, FigurePart::Curve);
  addColumnChoice(command, curve_.columns);
  command
      ->add_option("--realizations-table", curve_.realizationTable,
                   "FILE.csv or .json for the values of each random line at each velocity")
      ->type_name("FILE")
      ->group(kTableGroup);
}

void CommandTable::addMap(const char* name) {
  CLI::App* command =
      addSceneCommand(name, "Friction over two parameters, as colours and as a table", map_.common,
                      [this] { return runMap(map_); });
  const auto side = [&](const char* option, std::string& value, const char* sentence) {
    command->add_option(option, value, sentence)->type_name("KEY=FROM:TO:N")->required();
  };
  side("--x", map_.x,
       "Parameter along x, such as sliding.velocity=1e-5:1e3:64; units, :log and :linear as in "
       "load.normal_force=1mN:10N:64:log");
  side("--y", map_.y, "Parameter along y");
  command
      ->add_option("--show", map_.quantity,
                   "What the picture shows: a column of a curve (asperity columns), or exponent, "
                   "d ln mu / d ln x")
      ->capture_default_str();
  addOutputs(command, map_.outputs,
             "FILE.csv (one row a cell, x fastest), .json, .png, .svg, .pdf, .eps or .tif; may be "
             "repeated (default: CSV to standard output)");
  addPictureOptions(*command, map_.picture, {1200, 900, "print"}, FigurePart::Chart);
  addColumnChoice(command, map_.columns);
}

void CommandTable::addSensitivity(const char* name) {
  CLI::App* command =
      addSceneCommand(name, "How much friction changes with each parameter of a scene",
                      sensitivity_.common, [this] { return runSensitivity(sensitivity_); });
  addOutputs(command, sensitivity_.outputs,
             "FILE.csv, .json, .png, .svg, .pdf, .eps or .tif; may be repeated (default: a table "
             "for people to standard output)");
  addPictureOptions(*command, sensitivity_.picture, {1200, 800, "print"}, FigurePart::Chart);
}

void CommandTable::addCutoff(const char* name) {
  CLI::App* command = addSceneCommand(
      name, "Friction against the short-wave cut-off: which waves of the line make it",
      cutoff_.common, [this] { return runCutoff(cutoff_); });
  addOutputs(command, cutoff_.outputs,
             "FILE.csv, .json, .png, .svg, .pdf, .eps or .tif; may be repeated (default: CSV to "
             "standard output)");
  addPictureOptions(*command, cutoff_.picture, {1200, 1000, "print"}, FigurePart::Chart);
}

void CommandTable::addMotion(const char* name) {
  CLI::App* command = addSceneCommand(name, "Friction, indentation, contact and power in time",
                                      motion_.common, [this] { return runMotion(motion_); });
  addOutputs(command, motion_.outputs,
             "FILE.csv (its first line, # asperity: ..., says how it was made), .json, .png, .svg "
             "or .pdf; may be repeated (default: CSV to standard output)");
  setIntegerRange(
      command
          ->add_option("--every", motion_.every,
                       "Write one row for this number of time steps, and the last step; "
                       "pictures show all steps")
          ->capture_default_str(),
      1, 1000000000);
  setIntegerRange(
      command
          ->add_option("--lines", motion_.lines,
                       "Number of random lines; the column realization numbers them, and "
                       "pictures show their mean")
          ->capture_default_str(),
      1, 1000000);
  addPictureOptions(*command, motion_.picture, {1200, 1000, "print"}, FigurePart::Chart);
  addColumnChoice(command, motion_.columns);
}

void CommandTable::addRender(const char* name) {
  CLI::App* command = addSceneCommand(name, "Pictures and films of the contact, without a screen",
                                      render_.common, [this] { return runRender(render_); });
  command
      ->add_option("-o,--output", render_.output,
                   "FILE.png, .svg, .pdf, .eps or .tif for one picture; FILE.mp4, .webm, .gif or "
                   ".webp for a film; a folder for frame_0001.png and on; FILE.csv, .json or - "
                   "(CSV to standard output) for a table of the contact")
      ->required();
  command
      ->add_option("--layout", render_.layout,
                   "contact, curve, both, or transient: the contact above strips over time")
      ->capture_default_str();
  command->add_option("--overlay", render_.overlay,
                      "Colour the contact by none, pressure, relaxation (time since contact) or "
                      "power (dissipated) (default: pressure)");
  addViewOptions(*command, render_.view);
  addCurveOptions(*command, render_.curves);
  addPictureOptions(*command, render_.picture, {1280, 720, "light"}, FigurePart::Curve);
  addTimeOptions(*command, render_.time);
  command->add_flag("--resume", render_.resume,
                    "Keep the frames of an interrupted run and make the missing ones");
  command
      ->add_option("--table", render_.table,
                   "Of .csv and .json: shape (point by point), contacts, gaps, or power (its "
                   "balance) (default: shape)")
      ->type_name("NAME")
      ->group(kTableGroup);
  addColumnChoice(command, render_.columns);
}

void CommandTable::addSurface(const char* name) {
  CLI::App* command = addSceneCommand(
      name, "A measured surface or the rigid line of a scene: values, spectrum, the line",
      surface_.common, [this] { return runSurface(surface_); });
  command->get_option("SCENE")->description(
      "Measured surface of any kind, scene file (JSON), or the name of a shipped scene (figure_1)");
  addOutputs(
      command, surface_.outputs,
      "FILE.csv (a line # asperity: ..., then position, height of the rigid line), FILE.json, "
      "FILE.png, .svg, .pdf, .eps or .tif; - is CSV to standard output; may repeat");
  command
      ->add_option("--table", surface_.table,
                   "Of .csv: line (position, height), spectrum, or statistics")
      ->type_name("NAME")
      ->capture_default_str()
      ->group(kTableGroup);
  addColumnChoice(command, surface_.columns);
  addPictureOptions(*command, surface_.picture, {1280, 800, "light"}, FigurePart::Chart);
}

void CommandTable::addFit(const char* name) {
  CLI::App* command = addSceneCommand(name, "Parameters of a scene that fit measured friction",
                                      fit_.common, [this] { return runFit(fit_); });
  mayRepeat(command->add_option("--data", fit_.data,
                                "Table of velocity and mu, where known with mu_error, normal_force "
                                "or nominal_pressure, temperature, label; may be repeated"))
      ->type_name("FILE");
  mayRepeat(command->add_option("--vary", fit_.varied,
                                "Key that is fitted, with limits if there are some; may be "
                                "repeated"))
      ->type_name("KEY[=LOW:HIGH]")
      ->required();
  command
      ->add_option("-o,--output", fit_.output,
                   "Folder for fit.json, fitted.scene.json, fit.csv, pictures")
      ->required();
  command->add_flag("--no-profiles", fit_.withoutProfiles,
                    "Leave out the profiles of the objective, which take most of the time");
  addPictureOptions(*command, fit_.picture, {1200, 900, "print"}, FigurePart::Curve);
  addColumnChoice(command, fit_.columns);
}

void CommandTable::addMaterial(const char* name) {
  CLI::App* command =
      addCommand(name, "Make a material for scenes from measured moduli or a Prony series",
                 [this] { return runMaterial(material_); });
  MaterialCommand& material = material_;
  command
      ->add_option("FILE", material.common.scene,
                   "Table of moduli over frequency at one or more temperatures, or a Prony "
                   "series as finite-element programs write them; of a scene it is shown where "
                   "its rubber is used")
      ->required();
  command->add_option("-o,--output", material.output, "Folder for material.json, tables, pictures")
      ->required();
  addMaterialOptions(*command, material.options);
  addPictureOptions(*command, material.picture, {1200, 800, "print"}, FigurePart::Chart);
  addColumnChoice(command, material.columns);
  addShared(*command, material.common);
}

void CommandTable::addFigure(const char* name) {
  CLI::App* command = addCommand(
      name, "The figures of Li et al. (2013): data, pictures, and a check of the paper's claims",
      [this] { return runFigure(figure_); });
  std::string words;
  for (const FigureEntry& entry : figureEntries())
    words += fmt::format("  {:8} {}\n", entry.word, entry.headline);
  command
      ->add_option("NAME", figure_.names,
                   "One or more of the figures below, paper for 1 to 6, or all")
      ->required();
  command->add_option("-o,--output", figure_.output, "Folder for CSV, PNG, SVG and claims.json")
      ->required();
  setIntegerRange(command
                      ->add_option("--realizations", figure_.realizations,
                                   "Number of random lines to average over")
                      ->capture_default_str(),
                  1, 1000000);
  addPictureOptions(*command, figure_.picture, {1200, 800, "print", 1, "that of the figure"},
                    FigurePart::Curve);
  addColumnChoice(command, figure_.columns);
  addShared(*command, figure_.common);
  command->footer("Figures:\n" + words);
}

void CommandTable::addOpen(const char* name) {
  CLI::App* command = app_->add_subcommand(name, "Open the window with the scene that made a file");
  command
      ->add_option("FILE", open_.common.scene,
                   "PNG, SVG, PDF, film, CSV or JSON that Asperity wrote; a scene may be dropped "
                   "on the window in the same way")
      ->required();
  addShared(*command, open_.common, kLastLanguage);
  command->add_flag("--remake", open_.remakes,
                    "Make the file again from the scene and options it contains, without a window; "
                    "further options replace its own");
  command->add_option("-o,--output", open_.output,
                      "With --remake: the new file (default: the file itself)");
  command
      ->add_option("--from", open_.from,
                   "With --remake: the folder of the files that FILE was made from, or the store "
                   "of its study (default: looked for beside FILE, in the folders above it and "
                   "in the present one)")
      ->type_name("PATH");
  command->allow_extras();
  command->footer(
      "With --json the scene is printed as a scene file, and no window opens.\n"
      "Everything that says how it was made can be remade: what curve, map, sensitivity, cutoff, "
      "motion, render and surface wrote, and each picture and table in a folder of fit, "
      "material, "
      "study analyse, batch, accuracy (whose run times are measured again) and figure.");
  command->callback([this, command] {
    open_.others = command->remaining();
    if (!open_.remakes && !open_.others.empty())
      throw CLI::ExtrasError(command->get_name(), open_.others);
    selected_ = [this] {
      for (const auto& [option, value] :
           {std::pair{"--output", &open_.output}, {"--from", &open_.from}})
        if (!open_.remakes && !value->empty())
          throw InputError("", option, "applies only with --remake");
      return open_.remakes ? remake_(open_) : runOpen(open_);
    };
  });
}

void CommandTable::addBatch(const char* name) {
  CLI::App* command = addCommand(
      name, "Run many scenes and sweeps of their keys: pictures, data and one page that shows all",
      [this] { return runBatch(batch_); });
  command->add_option("FILE", batch_.common.scene, "The batch (JSON), see below")->required();
  command->add_option("-o,--output", batch_.output, "Folder for all files")->required();
  command->add_flag("--contact-sheet", batch_.contactSheet,
                    "Make contact sheets of more than 100 scenes, too");
  addPictureOptions(*command, batch_.picture, {960, 900, "light", 1, "the batch's"},
                    FigurePart::Curve);
  addColumnChoice(command, batch_.columns);
  addSharedWithoutScene(*command, batch_.common);  // each entry of the batch has its own "set"
  command->footer(kBatchFormat);
}

void CommandTable::addStudy(const char* name) {
  CLI::App* study = app_->add_subcommand(
      name, "Very many simulations: a space of scene keys, in a store that survives kills");
  study->require_subcommand(1);
  study->footer(kStudyFormat);
  // The first word of an action is its input, and there is no --set: the study has all values.
  const auto action = [&](const char* word, const char* sentence, StudyCommand& command,
                          int (*work)(const StudyCommand&)) {
    CLI::App* app = study->add_subcommand(word, sentence);
    addSharedWithoutScene(*app, command.common);
    app->callback(
        [this, &command, work] { selected_ = [&command, work] { return work(command); }; });
    return app;
  };
  CLI::App* run = action("run", "Run a study, or the rest of it", studyRun_, runStudyRun);
  run->add_option("STUDY", studyRun_.study, "The study (JSON), see below")->required();
  run->add_option("-o,--output", studyRun_.output,
                  "STORE: a file that keeps all results; run again, it goes on");
  run->add_option("--shard", studyRun_.shard,
                  "Only part I of N, into a store of its own that 'merge' joins with the others")
      ->type_name("I/N");
  run->add_flag("--plan", studyRun_.plan, "Show what it will cost, and compute nothing");
  run->add_flag(
      "--allow-failures", studyRun_.allowsFailures,
      "End with exit status 0 although some simulations failed; without it the status is 1 "
      "then, after all results were stored");
  run->footer(kStudyFormat);
  CLI::App* merge =
      action("merge", "Join the stores of shards, in any order", studyMerge_, runStudyMerge);
  merge->add_option("STORES", studyMerge_.stores, "Stores of one study")->required();
  merge
      ->add_option("-o,--output", studyMerge_.output,
                   "STORE for all of them; what it has already counts too")
      ->required();
  CLI::App* table = action("table", "The results as a table", studyTable_, runStudyTable);
  table->add_option("STORE", studyTable_.study, "Store of a study")->required();
  addOutputs(table, studyTable_.outputs,
             "FILE.csv (its first line, # asperity: ..., says how it was made) or FILE.json; may "
             "be repeated (default: CSV to standard output)");
  table
      ->add_option("--shape", studyTable_.shape,
                   "wide: a row for each simulation; long: a row for each of its numbers")
      ->capture_default_str();
  CLI::App* show = action("show", "What a store has: state, rate, failures with their messages",
                          studyShow_, runStudyShow);
  show->add_option("STORE", studyShow_.study, "Store of a study")->required();
  CLI::App* analyse =
      action("analyse", "Sensitivity indices, main effects, correlations, percentiles",
             studyAnalyse_, runStudyAnalyse);
  analyse->add_option("STORE", studyAnalyse_.study, "Store of a study")->required();
  analyse
      ->add_option("-o,--output", studyAnalyse_.output,
                   "Folder for analysis.json, tables and pictures")
      ->required();
  addPictureOptions(*analyse, studyAnalyse_.picture, {1400, 900, "print"});
}

void CommandTable::addAccuracy(const char* name) {
  CLI::App* command =
      addSceneCommand(name, "What accuracy costs: error against time of every method",
                      accuracy_.common, [this] { return runAccuracy(accuracy_); });
  command->add_option("-o,--output", accuracy_.output, "Folder for tables and diagrams")
      ->required();
  addPictureOptions(*command, accuracy_.picture, {1200, 800, "print", 1, "that of the diagrams"},
                    FigurePart::Chart);
  addColumnChoice(command, accuracy_.columns);
}

void CommandTable::addExplain(const char* name) {
  CLI::App* command =
      addSceneCommand(name, "The plan: what runs, what does not run and why, and the expected cost",
                      explain_.common, [this] { return runExplain(explain_); });
  command->add_flag("--analyze", explain_.analyze, "Run it as well and add the measured cost");
  CLI::Option* x = command->add_option(
      "--x", explain_.x, "With --y: expected cost of 'asperity map' with this x axis");
  CLI::Option* y = command->add_option("--y", explain_.y, "The y axis of that map");
  for (CLI::Option* side : {x, y}) side->type_name("KEY=FROM:TO:N");
  x->needs(y);
  y->needs(x);
}

void CommandTable::addColumns(const char* name) {
  CLI::App* command = addCommand(name, "All columns of all tables: name, unit, meaning, equation",
                                 [this] { return runColumns(columns_); });
  addSharedWithoutScene(*command, columns_);
}

void CommandTable::addLesson(const char* name) {
  CLI::App* command = addCommand(
      name,
      "Lessons: what they ask, handouts for students and teachers, and the results of a class",
      [this] { return runLesson(lesson_); });
  command->add_option("LESSON", lesson_.lessons,
                      "Name of a shipped lesson, or a file (default: lists the shipped ones); or "
                      "files and folders of results, of which it prints a table");
  addSharedWithoutScene(*command, lesson_.common);  // its scenes are the lesson's own
  addOutputs(command, lesson_.outputs,
             "Handout FILE.html or FILE.pdf, table of results FILE.csv; may be repeated");
  command->add_flag("--teacher", lesson_.forTeacher,
                    "The handout has the answers, as computed, and the teacher's notes");
  command->footer(kLessonFormat);
}

}  // namespace asperity
