#include "tests/fuzz/readers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/batch_file.h"
#include "core/base/input_error.h"
#include "core/lesson/lesson_file.h"
#include "core/material/dma_file.h"
#include "core/material/prony_file.h"
#include "core/measured/measured_file.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "core/study/study_file.h"
#include "core/surface/profile_file.h"
#include "core/surface/spectrum_file.h"
#include "tests/core/measured/written_surface.h"

namespace asperity {
namespace {

void require(bool holds, const char* promise) {
  if (!holds) throw BrokenPromise(promise);
}

void requireShortLine(const std::string& message) {
  require(message.size() < 1000, "a message is shorter than 1000 bytes");
  require(std::none_of(message.begin(), message.end(),
                       [](char letter) { return static_cast<unsigned char>(letter) < ' '; }),
          "a message is one line");
}

/// Calls read(), which may refuse its input.
template <class Read>
void readOrRefuse(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    require(error.what()[0] != '\0', "a refusal has a message");
    requireShortLine(error.what());
  }
}

/// Stands for a scene that a file names: no other file is read.
Scene anyScene(const std::string&, const std::filesystem::path& folder,
               const std::vector<std::string>& assignments) {
  return readScene("{}", "scene", folder, assignments);
}

/// Requires that the scene is written as text that reads back to the same.
void requireRoundTrip(const Scene& scene) {
  const std::string first = writeScene(scene);
  require(writeScene(readScene(first, "scene")) == first, "a scene reads back to the same");
}

void readSceneText(std::string_view text) {
  readOrRefuse([text] { requireRoundTrip(readScene(text, "scene")); });
}

/// Reads one assignment KEY=VALUE from each line, over an empty scene.
void readAssignments(std::string_view text) {
  std::vector<std::string> assignments;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    assignments.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  readOrRefuse([&] { requireRoundTrip(readScene("{}", "scene", {}, assignments)); });
}

/// Looks for the scene in a picture or table.
void openAnyFile(std::string_view bytes) {
  readOrRefuse([bytes] { requireRoundTrip(findScene(bytes, "file").scene); });
}

void readBatchFile(std::string_view text) {
  readOrRefuse([text] {
    for (const BatchItem& item : readBatch(text, "batch.json").items) {
      requireShortLine(item.error.english());
      if (item.error.empty()) requireRoundTrip(item.scene);
    }
  });
}

void readStudyFile(std::string_view text) {
  readOrRefuse([text] {
    const ParameterStudy study = readStudy(text, "study.json", "/nowhere", anyScene);
    require(study.simulations() > 0 && !study.outputs.empty(), "a study computes something");
    const ParameterStudy again = readStudy(study.canonical, "study.json", "/nowhere", anyScene);
    require(again.canonical == study.canonical && again.digest == study.digest,
            "a study reads back to the same");
  });
}

void readLessonFile(std::string_view text) {
  readOrRefuse([text] {
    const Lesson lesson = readLesson(text, "lesson.json", "/nowhere", anyScene);
    require(!lesson.steps.empty(), "a lesson has steps");
    const std::string first = writeLesson(lesson);
    require(writeLesson(readLesson(first, "lesson.json", "/nowhere", anyScene)) == first,
            "a lesson reads back to the same");
  });
}

void readProfileFile(std::string_view text) {
  readOrRefuse([text] {
    const Profile profile = parseProfile(text, "profile");
    require(profile.height.size() >= 3, "a profile has at least three heights");
    require(std::isfinite(profile.length) && profile.length >= 0, "a length is finite");
    for (const double height : profile.height) require(std::isfinite(height), "heights are finite");
  });
}

void readSpectrumFile(std::string_view text) {
  for (const SpectrumKind kind :
       {SpectrumKind::C1TwoSided, SpectrumKind::C1OneSided, SpectrumKind::C2})
    readOrRefuse([text, kind] {
      const SpectralDensity density = parseSpectrumTable(text, "spectrum", kind).density;
      const std::vector<double>& wave = density.waveNumber;
      require(wave.size() >= 2 && density.density.size() == wave.size(),
              "a spectrum has at least two values");
      for (std::size_t i = 0; i < wave.size(); ++i) {
        require(std::isfinite(wave[i]) && wave[i] > 0, "wave numbers are above 0");
        require(std::isfinite(density.density[i]) && density.density[i] >= 0,
                "densities are finite");
        require(i == 0 || wave[i] > wave[i - 1], "wave numbers rise");
      }
    });
}

bool isAboveZero(double value) {
  return std::isfinite(value) && value > 0;
}

void requireSound(const std::vector<Isotherm>& isotherms) {
  require(!isotherms.empty(), "moduli have an isotherm");
  for (std::size_t i = 0; i < isotherms.size(); ++i) {
    require(isAboveZero(isotherms[i].temperature), "temperatures are above 0 K");
    require(i == 0 || isotherms[i].temperature > isotherms[i - 1].temperature, "temperatures rise");
    const std::vector<DynamicModulus>& points = isotherms[i].points;
    require(points.size() >= 2, "an isotherm has at least two points");
    for (std::size_t k = 0; k < points.size(); ++k) {
      require(isAboveZero(points[k].frequency) && isAboveZero(points[k].storage) &&
                  isAboveZero(points[k].loss),
              "moduli are above 0");
      require(k == 0 || points[k].frequency > points[k - 1].frequency, "frequencies rise");
    }
  }
}

/// A file may leave units and temperature open. It is read with and without a choice of them, so
/// that they are not always the reason of a refusal.
void readModuli(std::string_view text) {
  DmaChoices open, chosen;
  chosen.frequencyUnit = "Hz";
  chosen.modulusUnit = "MPa";
  chosen.modulus = ModulusKind::Shear;
  chosen.temperature = 293.15;
  for (const DmaChoices& choices : {open, chosen})
    readOrRefuse([&] {
      TextTableOptions options;
      options.keepsTexts = options.readsCells = true;
      const DmaFile file = readDmaFile(readTextTable(text, "moduli", options), "moduli", choices);
      requireSound(groupIsotherms(file.rows));
    });
}

void requireSound(const PronyFile& file) {
  require(std::isfinite(file.equilibriumModulus) && file.equilibriumModulus >= 0,
          "the equilibrium modulus is finite");
  require(!file.arms.empty(), "a series has an arm");
  for (std::size_t i = 0; i < file.arms.size(); ++i) {
    require(isAboveZero(file.arms[i].modulus) && isAboveZero(file.arms[i].relaxationTime),
            "arms are above 0");
    require(i == 0 || file.arms[i].relaxationTime < file.arms[i - 1].relaxationTime,
            "relaxation times fall");
  }
}

/// Returns the table in the text; nothing where it has keywords in place of a table.
std::optional<TextTable> tableIn(std::string_view text) {
  TextTableOptions options;
  options.keepsTexts = options.readsCells = true;
  try {
    return readTextTable(text, "series", options);
  } catch (const InputError&) {
    return {};
  }
}

void readProny(std::string_view text) {
  PronyChoices open, chosen;
  chosen.instantaneousModulus = 1e7;
  chosen.modulusUnit = "Pa";
  chosen.modulus = ModulusKind::Shear;
  chosen.isLiquid = true;
  for (const PronyChoices& choices : {open, chosen})
    readOrRefuse([&] {
      const std::optional<TextTable> table = tableIn(text);
      if (const auto file = readPronyFile(text, table ? &*table : nullptr, "series", choices))
        requireSound(*file);
    });
}

/// Reads a measured surface in this format. Units are chosen, so that they are no reason of a
/// refusal.
void readSurface(std::string_view bytes, std::string_view format) {
  ReadingChoices choices;
  choices.positionUnit = choices.heightUnit = "um";
  choices.format = format;
  readOrRefuse([&] {
    const MeasuredFile file = readMeasuredBytes(bytes, "surface", choices);
    const Topography& grid = file.topography;
    require(grid.columns >= 3 && grid.rows >= 1, "a surface has three points along x");
    require(grid.height.size() == static_cast<std::size_t>(grid.columns * grid.rows),
            "every point has a height or a gap");
    require(isAboveZero(grid.columnSpacing), "the spacing along x is above 0");
    require(std::isfinite(grid.rowSpacing) && grid.rowSpacing >= 0, "the spacing is finite");
    for (const double height : grid.height)
      require(!std::isinf(height), "heights are finite or gaps");
    for (const Message& note : file.facts.notes)
      require(!note.english().empty(), "a note has a text");
  });
}

template <const char* Format>
void readSurfaceAs(std::string_view bytes) {
  readSurface(bytes, Format);
}

/// Reads main.xml in an archive that is otherwise whole, which random bytes hardly ever are.
void readX3pXml(std::string_view text) {
  readSurface(
      written::zipped(
          {{"main.xml", std::string(text)}, {"bindata/data.bin", std::string(224, '\x40')}}, false),
      "auto");
}

constexpr char kGsf[] = "gsf", kGwy[] = "gwy", kNpy[] = "npy", kSdf[] = "sdf", kSmd[] = "smd",
               kSur[] = "sur", kSurfer[] = "surfer", kText[] = "text", kWyko[] = "wyko",
               kX3p[] = "x3p", kZygo[] = "zygo";

constexpr ReaderUnderTest kReaders[] = {
    {"batch", readBatchFile},
    {"gsf", readSurfaceAs<kGsf>},
    {"gwy", readSurfaceAs<kGwy>},
    {"lesson", readLessonFile},
    {"moduli", readModuli},
    {"npy", readSurfaceAs<kNpy>},
    {"open", openAnyFile},
    {"profile", readProfileFile},
    {"prony", readProny},
    {"scene", readSceneText},
    {"sdf", readSurfaceAs<kSdf>},
    {"set", readAssignments},
    {"smd", readSurfaceAs<kSmd>},
    {"spectrum", readSpectrumFile},
    {"study", readStudyFile},
    {"sur", readSurfaceAs<kSur>},
    {"surfer", readSurfaceAs<kSurfer>},
    {"text", readSurfaceAs<kText>},
    {"wyko", readSurfaceAs<kWyko>},
    {"x3p", readSurfaceAs<kX3p>},
    {"x3p_xml", readX3pXml},
    {"zygo", readSurfaceAs<kZygo>},
};

}  // namespace

std::span<const ReaderUnderTest> readersUnderTest() {
  return kReaders;
}

const ReaderUnderTest* findReader(std::string_view name) {
  const auto found = std::find_if(std::begin(kReaders), std::end(kReaders),
                                  [name](const ReaderUnderTest& it) { return it.name == name; });
  return found == std::end(kReaders) ? nullptr : found;
}

}  // namespace asperity
