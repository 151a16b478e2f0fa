// Makes a material from a file of measurements. material_summary.h writes it and says in sentences
// what it is, core/scene/material_tables.h has its tables and core/chart/material_sheets.h its
// charts.
// Pure; any thread; equal bytes and choices give the same material to the last bit.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/statistics.h"
#include "core/material/dma_file.h"
#include "core/material/elastomer.h"
#include "core/material/isotherms.h"
#include "core/material/master_curve.h"
#include "core/material/prony_file.h"
#include "core/material/prony_fit.h"
#include "core/material/temperature_shift.h"

namespace asperity {

/// Everything that a user may choose about the file and the fit. The defaults leave it to the
/// program.
struct MaterialChoices {
  DmaChoices columns{};
  double temperatureTolerance = kIsothermTolerance;  // K, within which rows are one isotherm
  std::vector<double> leftOut{};                     // K, isotherms that are not used
  std::optional<double> strainAmplitude{};           // of a file with several; 0.01 is 1 %
  double referenceTemperature = kNaN;                // K; NaN: usualReference
  bool isVertical = false;
  PronyOptions series{};
  double instantaneousModulus = kNaN;  // Pa, of relative series
  std::optional<ShiftKind> shift{};    // none: the formula that is good enough, or else the table
  std::string name{};                  // of the material; empty: that of the file
  std::string source{};                // a sentence: where the measurements come from
  std::vector<std::pair<std::string, std::string>> options{};  // as written, for the origin
  std::stop_token stop{};                                      // of the fits
};

struct Material {
  std::string name, source;
  std::string fileName, fileDigest;  // of the measurements, without folder; its SHA-256
  std::vector<std::pair<std::string, std::string>> options;  // with which it was made
  double referenceTemperature = 298.15;                      // K
  PronySeries series;
  double viscosity = 0;  // Pa s
  TemperatureShift shift;
  MeasuredRange measured;

  // Of measurements; empty and undefined where the file holds a ready series.
  std::vector<Isotherm> isotherms;
  MasterCurve curve;
  TemperatureFit wlf, arrhenius;
  DmaFacts facts;
  double strainAmplitude = kNaN;  // median; NaN: not stated
  // whether vertical shifts would explain what neighbours differ by, and leave a simple material
  bool isExplainedByVertical = false;
  std::vector<Message> strays;  // points that their neighbours contradict, the worst first
  bool isVertical = false;
  double poissonRatio = 0.5;
  Message format;              // of a ready series: "keywords of Abaqus"
  std::vector<Message> notes;  // of a ready series: what was assumed and what was left out

  bool isMeasured() const { return !isotherms.empty(); }
};

/// Makes the material of a file. Throws InputError that names the file, a line, a column or an
/// option, and StopRequested where the fit was stopped.
Material makeMaterial(std::string_view bytes, const std::string& fileName,
                      const MaterialChoices& choices);

/// Makes the material of sweeps that have been read.
Material fitMaterial(std::vector<Isotherm> isotherms, const MaterialChoices& choices);

}  // namespace asperity
