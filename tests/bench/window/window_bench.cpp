// asperity_window_bench [--quick] [--output FOLDER]
// How fast the window is: its start, a slider's new curve on the screen, pictures a second while an
// ensemble runs. Prints a table and writes it to FOLDER/<CPU name>_window.md. Without a display on
// Qt's offscreen platform; pictures of contacts by software either way.
// Exit: 0 done, 1 failed, 2 bad usage.
#include <fmt/format.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <cstdio>
#include <exception>
#include <fstream>
#include <optional>
#include <string>

#include "tests/bench/machine.h"
#include "tests/bench/table.h"
#include "tests/bench/window/window_measures.h"
#include "ui/window/main/run_window.h"

namespace asperity::bench {
namespace {

struct Options {
  bool isQuick = false;
  std::string output;
};

std::optional<Options> readOptions(int count, char** arguments) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    if (argument == "--quick")
      options.isQuick = true;
    else if (argument == "--output" && i + 1 < count)
      options.output = arguments[++i];
    else
      return std::nullopt;
  }
  return options;
}

void addRow(Table& table, const WindowMeasure& measure) {
  const std::string value = number(measure.value) + " " + measure.unit;
  if (!measure.limit) return table.add({measure.what, "-", value, "-", ""});
  const double ratio = measure.value / *measure.limit;
  const bool isMet = measure.isAtMost ? ratio <= 1 : ratio >= 1;
  table.add(
      {measure.what,
       fmt::format("{} {:g} {}", measure.isAtMost ? "<=" : ">=", *measure.limit, measure.unit),
       value, number(ratio), isMet ? "met" : "missed"});
}

std::string page(bool isQuick) {
  const double load = loadAverage();
  Table table({"what", "target", "measured", "of the target", ""});
  for (const WindowMeasure& measure : measureWindow(isQuick)) addRow(table, measure);
  return fmt::format(
      "# The window\n\n{}, {} platform, contacts drawn by software, load average {:.1f} "
      "before the run.\nTimes by the wall clock: from the start of the process, or from the "
      "slider's step until the new curve's first picture is whole.\n\n{}",
      cpuName(), QGuiApplication::platformName().toStdString(), load, table.text());
}

int run(QApplication& application, const Options& options) {
  const QTemporaryDir settings;  // never the user's own
  for (const QSettings::Format format : {QSettings::NativeFormat, QSettings::IniFormat})
    QSettings::setPath(format, QSettings::UserScope, settings.path());
  prepareApplication(application);
  const std::string text = page(options.isQuick);
  std::printf("\n%s", text.c_str());
  if (options.output.empty()) return 0;
  std::ofstream out(options.output + "/" + cpuFileName() + "_window.md");
  out << text;
  out.close();
  return out ? 0 : 1;
}

}  // namespace
}  // namespace asperity::bench

int main(int count, char** arguments) {
  const auto options = asperity::bench::readOptions(count, arguments);
  if (!options) {
    std::fprintf(stderr, "usage: asperity_window_bench [--quick] [--output FOLDER]\n");
    return 2;
  }
  qputenv("ASPERITY_CANVAS", "software");
  if (!qEnvironmentVariableIsSet("DISPLAY") && !qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(count, arguments);
  try {
    return asperity::bench::run(application, *options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "asperity_window_bench: %s\n", error.what());
    return 1;
  }
}
