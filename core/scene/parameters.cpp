#include "core/scene/parameters.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/material/temperature_shift.h"
#include "core/measured/measured_file.h"
#include "core/scene/list_text.h"

namespace asperity {
namespace {

constexpr std::array<std::string_view, 7> kSurfaceKinds{
    "self_affine", "sine", "wedge", "parabola", "profile", "measured", "spectrum"};
constexpr std::array<std::string_view, 2> kDirections{"along_x", "along_y"};
constexpr std::array<std::string_view, 2> kGaps{"refuse", "interpolate"};
constexpr std::array<std::string_view, 4> kForms{"line", "none", "mean", "parabola"};
constexpr std::array<std::string_view, 4> kSeams{"mirror", "blend", "random_phases", "periodic"};
constexpr std::array<std::string_view, 2> kLineKinds{"as_measured", "isotropic_equivalent"};
constexpr std::array<std::string_view, 2> kContactSides{"summits", "valleys"};
constexpr std::array<std::string_view, 4> kSpectrumKinds{"unstated", "c1_two_sided", "c1_one_sided",
                                                         "c2"};
constexpr std::array<std::string_view, 4> kRheologies{"elastic", "kelvin", "standard_solid",
                                                      "prony"};
constexpr std::array<std::string_view, 3> kLoadKinds{"force", "indentation", "pressure"};
constexpr std::array<std::string_view, 5> kSlidingKinds{"steady", "start", "step", "oscillation",
                                                        "reversal"};
constexpr std::array<std::string_view, 3> kSchemes{"nodal", "linear", "cubic"};
constexpr std::array<std::string_view, 2> kSweepScales{"log", "linear"};

constexpr Scale kLog = Scale::Logarithmic;
constexpr Scale kLin = Scale::Linear;
constexpr Scale kNoneOrLog = Scale::LogarithmicFromNone;
constexpr Change kLive = Change::Live;
constexpr Change kRebuild = Change::Rebuild;
constexpr FileRule kOfMaterial{.isOfMaterial = true};
// Scene files from before such a key do not state it.
constexpr FileRule kNewOfMaterial{.isOfMaterial = true, .isLeftOutAtDefault = true};
constexpr FileRule kUnlessDefault{.isLeftOutAtDefault = true};
constexpr FileRule kRequired{.isRequired = true};
constexpr FileRule kOfReading{.isOfReading = true};
constexpr std::int64_t kLargestInteger = (std::int64_t{1} << 53) - 1;  // exact in JSON

/// A field that reads and writes `scene.section.member`.
#define ASPERITY_MEMBER(section, member) \
  +[](Scene & scene) -> auto& {          \
    return scene.section.member;         \
  }
#define ASPERITY_CHOICE(section, member, words)                                      \
  ChoiceField {                                                                      \
    [](const Scene& scene) { return static_cast<int>(scene.section.member); },       \
        [](Scene& scene, int index) {                                                \
          scene.section.member = static_cast<decltype(scene.section.member)>(index); \
        },                                                                           \
        words                                                                        \
  }
/// A choice that the scene holds as its word.
#define ASPERITY_WORD(section, member, words)                                         \
  ChoiceField {                                                                       \
    [](const Scene& scene) {                                                          \
      return static_cast<int>(std::ranges::find(words, scene.section.member) -        \
                              std::ranges::begin(words));                             \
    },                                                                                \
        [](Scene& scene, int index) {                                                 \
          scene.section.member = std::string(words[static_cast<std::size_t>(index)]); \
        },                                                                            \
        words                                                                         \
  }

// clang-format off
const std::array kTable{
    Parameter{"title", "title", "", "", "A name for the scene, shown above its pictures.", kLive, {},
              TextField{+[](Scene& scene) -> auto& { return scene.title; }}},
    Parameter{"description", "description", "", "", "What to look for in the scene.", kLive, {},
              TextField{+[](Scene& scene) -> auto& { return scene.description; }, TextContent::Sentences}},
    Parameter{"chapter", "chapter", "", "", "The group of scenes that it belongs to.", kLive, {},
              TextField{+[](Scene& scene) -> auto& { return scene.chapter; }}},

    Parameter{"surface.kind", "kind of line", "", "", "The shape of the rigid line.", kRebuild, {},
              ASPERITY_CHOICE(surface, kind, kSurfaceKinds)},
    Parameter{"surface.length", "period", "L", "m", "The length after which the line repeats; where the line has a file it may be left out and is as long as the file says.", kRebuild, {},
              RealField{ASPERITY_MEMBER(surface, length), 1e-9, 1e3, 1e-4, 1, kLog}, {}, {}, ZeroMeaning::SizeOfFile},
    Parameter{"surface.elements", "elements", "N", "", "Elements per period: the shortest wave of a random line is two of them long; where the line has a file they may be left out and are as many as the file has.", kRebuild, {},
              IntegerField{ASPERITY_MEMBER(surface, elements), 3, std::int64_t{1} << 24, 50, 200000, kLog}, {}, {}, ZeroMeaning::SizeOfFile},
    Parameter{"surface.hurst", "Hurst exponent", "H", "", "How the roughness grows with length: 0 is rough at every scale alike, with steep slopes; 1 is smooth at short ones.", kRebuild, {"surface.kind", "self_affine"},
              RealField{ASPERITY_MEMBER(surface, hurst), 0, 1, 0, 1, kLin}},
    Parameter{"surface.rms_height", "rms height", "h", "m", "How rough the line is: root mean square of the height (ISO Rq), set by the long waves.", kRebuild, {"surface.kind", "self_affine"},
              RealField{ASPERITY_MEMBER(surface, rmsHeight), 0, 1, 1e-9, 1e-4, kLog}},
    Parameter{"surface.roll_off_wavelength", "roll-off", "lambda_r", "m", "Waves longer than this are all equally strong; 0: the roughness is self-affine up to the whole period.", kRebuild, {"surface.kind", "self_affine"},
              RealField{ASPERITY_MEMBER(surface, rollOffWavelength), 0, 1e3, 2e-5, 0.05, kNoneOrLog}},
    Parameter{"surface.summit_correlation", "summit correlation", "kappa", "", "Short waves stronger on the summits, which touch first (above 0), or in the valleys (below 0); 0: everywhere alike.", kRebuild, {"surface.kind", "self_affine"},
              RealField{ASPERITY_MEMBER(surface, summitCorrelation), -10, 10, -1, 1, kLin}},
    Parameter{"surface.seed", "seed", "", "", "Picks the random phases of the line.", kRebuild, {"surface.kind", "self_affine spectrum"},
              IntegerField{ASPERITY_MEMBER(surface, seed), 0, kLargestInteger, 1, 100, kLin}, {"surface.seam", "random_phases"}},
    Parameter{"surface.amplitude", "amplitude", "A", "m", "Height of the sine's crests above its mean.", kRebuild, {"surface.kind", "sine"},
              RealField{ASPERITY_MEMBER(surface, amplitude), 0, 1, 1e-9, 1e-4, kLog}},
    Parameter{"surface.waves", "waves", "", "", "Sine waves in one period of the line.", kRebuild, {"surface.kind", "sine"},
              IntegerField{ASPERITY_MEMBER(surface, waves), 1, 1000000, 1, 100, kLog}},
    Parameter{"surface.slope", "slope", "", "", "Slope of the wedge's two sides.", kRebuild, {"surface.kind", "wedge"},
              RealField{ASPERITY_MEMBER(surface, slope), 1e-12, 1e3, 1e-5, 1, kLog}},
    Parameter{"surface.radius", "radius", "R", "m", "Radius of curvature at the parabola's vertex.", kRebuild, {"surface.kind", "parabola"},
              RealField{ASPERITY_MEMBER(surface, radius), 1e-12, 1e9, 1e-4, 1e2, kLog}},
    Parameter{"surface.file", "file", "", "", "File of the line, relative to the scene: a CSV profile of position and height in metres, a measured surface of any kind, or a table of a spectrum.", kRebuild, {"surface.kind", "profile measured spectrum"},
              TextField{ASPERITY_MEMBER(surface, file), TextContent::File}},
    Parameter{"surface.format", "file format", "", "", "What the file is taken for; auto: the program finds out and says what it found.", kRebuild, {"surface.kind", "measured"},
              ASPERITY_WORD(surface.reading, format, surfaceFormats())},
    Parameter{"surface.position_unit", "position unit", "", "", "Unit of positions along the surface; auto: as the file states.", kRebuild, {"surface.kind", "measured"},
              ASPERITY_WORD(surface.reading, positionUnit, kSurfaceUnits)},
    Parameter{"surface.height_unit", "height unit", "", "", "Unit of heights; auto: as the file states.", kRebuild, {"surface.kind", "measured"},
              ASPERITY_WORD(surface.reading, heightUnit, kSurfaceUnits)},
    Parameter{"surface.point_spacing", "point spacing", "", "m", "Distance between points where the file does not state one, as in a list of heights alone; 0: as the file states.", kRebuild, {"surface.kind", "measured"},
              RealField{ASPERITY_MEMBER(surface.reading, pointSpacing), 0, 1e3, 1e-9, 1e-3, kNoneOrLog}, {}, kUnlessDefault, ZeroMeaning::AsFileStates},
    Parameter{"surface.position_column", "position column", "", "", "Column of positions, counted from 1; 0: the program finds it.", kRebuild, {"surface.kind", "measured"},
              IntegerField{ASPERITY_MEMBER(surface.reading, positionColumn), 0, 10000, 0, 10, kLin}, {}, kOfReading, ZeroMeaning::Automatic},
    Parameter{"surface.height_column", "height column", "", "", "Column or channel of heights, counted from 1; 0: the program finds it.", kRebuild, {"surface.kind", "measured"},
              IntegerField{ASPERITY_MEMBER(surface.reading, heightColumn), 0, 10000, 0, 10, kLin}, {}, kOfReading, ZeroMeaning::Automatic},
    Parameter{"surface.row", "row of the topography", "", "", "Row of a topography that is the line, counted from 1; 0: all rows, each a realization.", kRebuild, {"surface.kind", "measured"},
              IntegerField{ASPERITY_MEMBER(surface.reading, row), 0, 1000000000, 0, 1000, kLin}, {}, {}, ZeroMeaning::AllRows},
    Parameter{"surface.direction", "sliding direction", "", "", "Direction of sliding on a topography: along its rows (x) or across them (y).", kRebuild, {"surface.kind", "measured"},
              ASPERITY_CHOICE(surface.reading, direction, kDirections)},
    Parameter{"surface.gaps", "missing points", "", "", "Points that were not measured: refused, or interpolated along the row.", kRebuild, {"surface.kind", "measured"},
              ASPERITY_CHOICE(surface.processing, gaps, kGaps)},
    Parameter{"surface.outliers", "outlier limit", "", "", "Heights farther from the form than so many median deviations are replaced by interpolation; 0: all are kept.", kRebuild, {"surface.kind", "measured"},
              RealField{ASPERITY_MEMBER(surface.processing, outliers), 0, 1e6, 0, 30, kLin}, {}, {}, ZeroMeaning::None},
    Parameter{"surface.form", "form removal", "", "", "Levelling: what is subtracted from each row by least squares, a straight line, nothing, the mean or a parabola.", kRebuild, {"surface.kind", "measured"},
              ASPERITY_CHOICE(surface.processing, form, kForms)},
    Parameter{"surface.short_wave_cut", "short-wave cut-off", "lambda_s", "m", "S-filter: cut-off wavelength below which waves are removed, by the Gaussian filter of ISO 16610-21 from a measured surface, sharply from a spectrum; 0: none.", kRebuild, {"surface.kind", "measured spectrum"},
              RealField{ASPERITY_MEMBER(surface.processing, shortWaveCut), 0, 1e3, 1e-8, 0.01, kNoneOrLog}, {}, {}, ZeroMeaning::None},
    Parameter{"surface.long_wave_cut", "long-wave cut-off", "lambda_c", "m", "L-filter: cut-off wavelength above which waves are removed in the same way; 0: none, as friction usually needs, because long waves decide where the load is carried.", kRebuild, {"surface.kind", "measured spectrum"},
              RealField{ASPERITY_MEMBER(surface.processing, longWaveCut), 0, 1e3, 1e-6, 0.1, kNoneOrLog}, {}, {}, ZeroMeaning::None},
    Parameter{"surface.seam", "profile ends", "", "", "How the ends of the profile meet where its period repeats: mirrored (the period is twice the profile), blended, with random phases, or as they are, which may be a step.", kRebuild, {"surface.kind", "measured"},
              ASPERITY_CHOICE(surface.processing, seam, kSeams)},
    Parameter{"surface.blend_length", "blend length", "", "m", "Stretch over which the end of the profile is blended into its beginning, and by which the period is shorter; 0: a tenth of the profile.", kRebuild, {"surface.seam", "blend"},
              RealField{ASPERITY_MEMBER(surface.processing, blendLength), 0, 1e3, 1e-6, 0.1, kNoneOrLog}, {}, {}, ZeroMeaning::TenthOfProfile},
    Parameter{"surface.line", "line that slides", "", "", "The line that slides: as measured, right for grooves across the sliding; or the isotropic equivalent, C_line = pi q C2, which an isotropic surface needs and which is steeper by about sqrt 2.", kRebuild, {"surface.kind", "measured"},
              ASPERITY_CHOICE(surface, line, kLineKinds)},
    Parameter{"surface.contact_side", "contact side", "", "", "Which side of the measured surface touches the rubber: its summits (the line is the heights turned over, because the lowest points of a line touch first) or its valleys (the heights as they stand).", kRebuild, {"surface.kind", "measured"},
              ASPERITY_CHOICE(surface, contactSide, kContactSides)},
    Parameter{"surface.spectrum_kind", "kind of spectrum", "", "", "What the spectrum's numbers are: c1_two_sided (<h^2> = 2 integral C1 dq), c1_one_sided (<h^2> = integral C1 dq) or c2 of an isotropic surface (<h^2> = 2 pi integral C2 q dq); per wave number where the table has that column, else per spatial frequency. It must be stated.", kRebuild, {"surface.kind", "spectrum"},
              ASPERITY_CHOICE(surface, spectrumKind, kSpectrumKinds)},

    Parameter{"elastomer.rheology", "rheology", "", "", "How the elastomer responds to deformation.", kLive, {},
              ASPERITY_CHOICE(elastomer, rheology, kRheologies)},
    Parameter{"elastomer.material", "material", "", "", "A shipped material or a material file, relative to the scene; it gives moduli, relaxation times and shift, and a key beside it replaces that one value.", kLive, {"elastomer.rheology", "prony"},
              TextField{ASPERITY_MEMBER(elastomer, material), TextContent::Material}, {}, kUnlessDefault},
    Parameter{"elastomer.shear_modulus", "shear modulus", "G", "Pa", "Static shear modulus: how stiff or soft the elastomer is.", kLive, {"elastomer.rheology", "elastic kelvin"},
              RealField{ASPERITY_MEMBER(elastomer, shearModulus), 1e-6, 1e15, 1e3, 1e9, kLog}},
    Parameter{"elastomer.relaxation_time", "relaxation time", "tau", "s", "Viscosity over shear modulus: how long the free surface takes to recover.", kLive, {"elastomer.rheology", "kelvin"},
              RealField{ASPERITY_MEMBER(elastomer, relaxationTime), 0, 1e12, 1e-7, 10, kLog}},
    Parameter{"elastomer.equilibrium_modulus", "equilibrium modulus", "G_inf", "Pa", "Shear modulus that is left when all arms have relaxed: how stiff the elastomer is at rest; steady sliding needs more than 0.", kLive, {"elastomer.rheology", "standard_solid prony"},
              RealField{ASPERITY_MEMBER(elastomer, equilibriumModulus), 0, 1e15, 1e3, 1e9, kLog}, {}, kOfMaterial},
    Parameter{"elastomer.viscosity", "viscosity", "eta", "Pa s", "Viscosity of a dashpot beside the arms; 0: none.", kLive, {"elastomer.rheology", "prony"},
              RealField{ASPERITY_MEMBER(elastomer, viscosity), 0, 1e27, 10, 1e7, kNoneOrLog}, {}, kOfMaterial},
    Parameter{"elastomer.arms", "arms", "", "", "Springs and dashpots in series: modulus in Pa and relaxation time in s of each; a standard solid has one.", kLive, {"elastomer.rheology", "standard_solid prony"},
              ArmsField{ASPERITY_MEMBER(elastomer, arms)}, {}, kOfMaterial},
    Parameter{"elastomer.temperature", "temperature", "T", "K", "Temperature of the elastomer; it shifts all relaxation times together.", kLive, {"elastomer.rheology", "kelvin standard_solid prony"},
              RealField{ASPERITY_MEMBER(elastomer, temperature), 1, 2000, 200, 450, kLin}},
    Parameter{"elastomer.shift.kind", "shift", "", "", "How temperature shifts the relaxation times: by Williams, Landel and Ferry (wlf), by an activation energy (arrhenius), or as measured (table).", kLive, {"elastomer.rheology", "kelvin standard_solid prony"},
              ASPERITY_CHOICE(elastomer.shift, kind, kShiftNames), {}, kNewOfMaterial},
    Parameter{"elastomer.shift.c1", "constant C1", "C_1", "", "First constant of the shift with temperature (Williams, Landel and Ferry).", kLive, {"elastomer.shift.kind", "wlf"},
              RealField{ASPERITY_MEMBER(elastomer.shift, c1), 0, 1e3, 1, 30, kLin}, {}, kOfMaterial},
    Parameter{"elastomer.shift.c2", "constant C2", "C_2", "K", "Second constant of the shift with temperature (Williams, Landel and Ferry).", kLive, {"elastomer.shift.kind", "wlf"},
              RealField{ASPERITY_MEMBER(elastomer.shift, c2), 1e-3, 1e4, 10, 300, kLin}, {}, kOfMaterial},
    Parameter{"elastomer.shift.reference_temperature", "reference temperature", "T_r", "K", "Temperature at which the relaxation times are as given.", kLive, {"elastomer.shift.kind", "wlf arrhenius"},
              RealField{ASPERITY_MEMBER(elastomer.shift, referenceTemperature), 1, 2000, 200, 450, kLin}, {}, kOfMaterial},
    Parameter{"elastomer.shift.activation_energy", "activation energy", "E_a", "J/mol", "Activation energy of the shift with temperature (Arrhenius).", kLive, {"elastomer.shift.kind", "arrhenius"},
              RealField{ASPERITY_MEMBER(elastomer.shift, activationEnergy), 0, 1e7, 1e4, 1e6, kLog}, {}, kOfMaterial},
    Parameter{"elastomer.shift.table", "shift table", "", "", "Measured shifts: temperature in K and log10 of the factor on all relaxation times, linear in between; there is none outside.", kLive, {"elastomer.shift.kind", "table"},
              ShiftTableField{ASPERITY_MEMBER(elastomer.shift, table)}, {}, kOfMaterial},
    Parameter{"elastomer.measured.frequency_from", "lowest measured frequency", "", "Hz", "Lowest frequency at which the elastomer was measured, at the temperature of no shift; friction that rests on others is marked. 0: not known.", kLive, {"elastomer.rheology", "prony"},
              RealField{ASPERITY_MEMBER(elastomer.measured, frequencyFrom), 0, 1e15, 1e-6, 1e12, kNoneOrLog}, {}, kNewOfMaterial, ZeroMeaning::NotSet},
    Parameter{"elastomer.measured.frequency_to", "highest measured frequency", "", "Hz", "Highest frequency at which the elastomer was measured, at the temperature of no shift. 0: not known.", kLive, {"elastomer.rheology", "prony"},
              RealField{ASPERITY_MEMBER(elastomer.measured, frequencyTo), 0, 1e15, 1e-6, 1e12, kNoneOrLog}, {}, kNewOfMaterial, ZeroMeaning::NotSet},
    Parameter{"elastomer.measured.temperature_from", "lowest measured temperature", "", "K", "Lowest temperature at which the elastomer was measured. 0: not known.", kLive, {"elastomer.rheology", "prony"},
              RealField{ASPERITY_MEMBER(elastomer.measured, temperatureFrom), 0, 2000, 0, 500, kLin}, {}, kNewOfMaterial, ZeroMeaning::NotSet},
    Parameter{"elastomer.measured.temperature_to", "highest measured temperature", "", "K", "Highest temperature at which the elastomer was measured. 0: not known.", kLive, {"elastomer.rheology", "prony"},
              RealField{ASPERITY_MEMBER(elastomer.measured, temperatureTo), 0, 2000, 0, 500, kLin}, {}, kNewOfMaterial, ZeroMeaning::NotSet},
    Parameter{"elastomer.measured.strain_amplitude", "measured strain", "", "", "Amplitude of the strain with which the elastomer was measured. 0: not known.", kLive, {"elastomer.rheology", "prony"},
              RealField{ASPERITY_MEMBER(elastomer.measured, strainAmplitude), 0, 100, 1e-5, 1, kNoneOrLog}, {}, kNewOfMaterial, ZeroMeaning::NotSet},

    Parameter{"load.kind", "load", "", "", "What is held constant: the normal force, the indentation or the nominal pressure.", kLive, {},
              ASPERITY_CHOICE(load, kind, kLoadKinds)},
    Parameter{"load.normal_force", "normal force", "F_N", "N", "Force that presses one period of the line into the elastomer.", kLive, {"load.kind", "force"},
              RealField{ASPERITY_MEMBER(load, normalForce), 1e-30, 1e30, 1e-4, 1e3, kLog}},
    Parameter{"load.depth", "indentation", "d", "m", "Indentation, measured from the lowest point of the line.", kLive, {"load.kind", "indentation"},
              RealField{ASPERITY_MEMBER(load, depth), 1e-30, 1e6, 1e-9, 1e-3, kLog}},

    Parameter{"load.nominal_pressure", "nominal pressure", "p_0", "Pa", "Normal force over the area of one period and the width: F_N = p_0 L width.", kLive, {"load.kind", "pressure"},
              RealField{ASPERITY_MEMBER(load, nominalPressure), 1e-30, 1e30, 1e3, 1e7, kLog}},
    Parameter{"load.width", "width", "w", "m", "Width that turns the nominal pressure into the force on the line; results depend on it; 0: the period, the square of the reduction method.", kLive, {"load.kind", "pressure"},
              RealField{ASPERITY_MEMBER(load, width), 0, 1e3, 1e-6, 1, kNoneOrLog}},

    Parameter{"sliding.kind", "motion", "", "", "How the line moves.", kLive, {},
              ASPERITY_CHOICE(sliding, kind, kSlidingKinds)},
    Parameter{"sliding.velocity", "velocity", "v", "m/s", "The speed of the line: how fast or slowly it slides; of an oscillation the mean velocity.", kLive, {},
              RealField{ASPERITY_MEMBER(sliding, velocity), 0, 1e12, 1e-6, 1e4, kLog}},
    Parameter{"sliding.velocity_after", "velocity after", "v_2", "m/s", "Velocity from half of the duration on; below 0 the line goes back.", kLive, {"sliding.kind", "step"},
              RealField{ASPERITY_MEMBER(sliding, velocityAfter), -1e12, 1e12, -10, 10, kLin}},
    Parameter{"sliding.amplitude", "velocity amplitude", "", "m/s", "Amplitude of the velocity about its mean: v = mean velocity + velocity amplitude sin(2 pi frequency t).", kLive, {"sliding.kind", "oscillation"},
              RealField{ASPERITY_MEMBER(sliding, amplitude), 0, 1e12, 1e-6, 1e4, kLog}},
    Parameter{"sliding.frequency", "frequency", "f", "Hz", "Oscillations of the velocity in a second.", kLive, {"sliding.kind", "oscillation"},
              RealField{ASPERITY_MEMBER(sliding, frequency), 1e-12, 1e12, 1e-2, 1e5, kLog}},
    Parameter{"sliding.duration", "duration", "", "s", "Time that the motion takes; a step or a reversal comes at half of it.", kLive, {"sliding.kind", "start step oscillation reversal"},
              RealField{ASPERITY_MEMBER(sliding, duration), 1e-15, 1e12, 1e-5, 100, kLog}},

    Parameter{"interface.friction_coefficient", "local friction", "", "", "Local coefficient of friction in contact, added to the friction of deformation and reported separately; 0: none.", kLive, {},
              RealField{ASPERITY_MEMBER(interface, frictionCoefficient), 0, 1e3, 0, 2, kLin}},
    Parameter{"interface.shear_stress", "local shear", "", "N/m", "Tangential load on each length in contact, instead of a local coefficient of friction; 0: none.", kLive, {},
              RealField{ASPERITY_MEMBER(interface, shearStress), 0, 1e15, 1e-3, 1e5, kNoneOrLog}},
    Parameter{"interface.shear_velocity", "shear velocity", "", "m/s", "Velocity (times the temperature shift) at which the local shear is largest; 0: it does not depend on the velocity.", kLive, {},
              RealField{ASPERITY_MEMBER(interface, shearVelocity), 0, 1e12, 1e-6, 1e4, kNoneOrLog}, {}, kUnlessDefault},
    Parameter{"interface.shear_width", "shear width", "", "", "How fast the local shear falls beside that velocity: it is exp(-c) of its largest value a decade away.", kLive, {},
              RealField{ASPERITY_MEMBER(interface, shearWidth), 0, 100, 0, 1, kLin}, {}, kUnlessDefault},

    Parameter{"sweep.key", "axis", "", "", "The key on the horizontal axis of the friction curve: any number that changes friction in the scene.", kLive, {},
              TextField{ASPERITY_MEMBER(sweep, key)}, {}, kUnlessDefault},
    Parameter{"sweep.velocity_from", "lowest velocity", "", "m/s", "First velocity of the friction curve.", kLive, {"sweep.key", kVelocityKey},
              RealField{ASPERITY_MEMBER(sweep, velocityFrom), 1e-30, 1e12, 1e-6, 1e4, kLog}},
    Parameter{"sweep.velocity_to", "highest velocity", "", "m/s", "Last velocity of the friction curve.", kLive, {"sweep.key", kVelocityKey},
              RealField{ASPERITY_MEMBER(sweep, velocityTo), 1e-30, 1e12, 1e-6, 1e4, kLog}},
    Parameter{"sweep.from", "axis from", "", "", "First value of another key than velocity, in its unit; from above to runs downwards.", kLive, {"sweep.key", kVelocityKey, true},
              RealField{ASPERITY_MEMBER(sweep, from), -1e30, 1e30, 1e-9, 1e9, kNoneOrLog}, {}, kRequired},
    Parameter{"sweep.to", "axis to", "", "", "Last value of another key than velocity, in its unit.", kLive, {"sweep.key", kVelocityKey, true},
              RealField{ASPERITY_MEMBER(sweep, to), -1e30, 1e30, 1e-9, 1e9, kNoneOrLog}, {}, kRequired},
    Parameter{"sweep.points", "points", "", "", "Points of the friction curve; of whole numbers, values that repeat are left out.", kLive, {},
              IntegerField{ASPERITY_MEMBER(sweep, points), 1, 100000, 5, 201, kLin}},
    Parameter{"sweep.scale", "axis scale", "", "", "How the points of the friction curve are spaced: evenly in their logarithm (log), or evenly (linear).", kLive, {},
              ASPERITY_CHOICE(sweep, scale, kSweepScales), {}, kUnlessDefault},

    Parameter{"ensemble.realizations", "realizations", "", "", "Lines that the friction curve is averaged over: random ones, or rows of a measured surface; 0, of rows alone: every row.", kLive, {},
              IntegerField{ASPERITY_MEMBER(ensemble, realizations), 1, 1000000, 1, 1000, kLog}, {}, {}, ZeroMeaning::EveryRow},

    Parameter{"accuracy.scheme", "scheme", "", "", "How the line is resolved: the paper's single elements (nodal), straight segments (linear) or smooth ones (cubic).", kLive, {},
              ASPERITY_CHOICE(accuracy, scheme, kSchemes)},
    Parameter{"accuracy.oversampling", "oversampling", "", "", "Points that resolve the line per element; 0: chosen, for a single line and for the mean over many, and files name the number used.", kLive, {"accuracy.scheme", "linear cubic"},
              IntegerField{ASPERITY_MEMBER(accuracy, oversampling), 0, 64, 1, 16, kLog}, {}, {}, ZeroMeaning::ChosenByScene},
    Parameter{"accuracy.target_relative_error", "target error", "", "", "Relative error of friction to be reached at every velocity: resolution and number of lines are then chosen by the program; 0: as scheme and realizations say.", kLive, {"accuracy.scheme", "cubic"},
              RealField{ASPERITY_MEMBER(accuracy, targetRelativeError), 0, 0.5, 0, 0.1, kLin}},

    Parameter{"comparison.data", "measured friction", "", "", "Tables of measured friction that are shown beside the curve: velocity and mu, with or without errors, force, temperature.", kLive, {},
              ListField{[](const Scene& scene) { return listText(scene.comparison.data); },
                        [](Scene& scene, std::string_view json, const std::string& key) { scene.comparison.data = parseDataFiles(json, key); },
                        allowedDataFiles}, {}, kUnlessDefault},
    Parameter{"comparison.theory", "theories", "", "", "Theories that are drawn beside the curve.", kLive, {},
              ListField{[](const Scene& scene) { return listText(scene.comparison.theory); },
                        [](Scene& scene, std::string_view json, const std::string& key) { scene.comparison.theory = parseTheories(json, key); },
                        allowedTheories}, {}, kUnlessDefault},
};
// clang-format on

}  // namespace

std::span<const Parameter> parameters() {
  return kTable;
}

const Parameter* findParameter(std::string_view key) {
  const auto row = std::find_if(kTable.begin(), kTable.end(),
                                [key](const Parameter& parameter) { return parameter.key == key; });
  return row == kTable.end() ? nullptr : &*row;
}

const Parameter& knownParameter(std::string_view key) {
  if (const Parameter* row = findParameter(key)) return *row;
  throw unknownKey(key, nearestKey(key));
}

InputError unknownKey(std::string_view key, std::string_view nearest) {
  return {"", shortened(key),
          nearest.empty() ? Message("unknown key; 'asperity check --help keys' lists all")
                          : message("unknown key; the nearest known one is {}", nearest)};
}

std::string_view nearestSection(std::string_view name) {
  std::vector<std::string_view> sections;
  for (const Parameter& row : kTable)
    for (std::size_t dot = row.key.find('.'); dot != row.key.npos; dot = row.key.find('.', dot + 1))
      sections.push_back(row.key.substr(0, dot));
  return nearestWord(name.substr(0, 100), sections);
}

std::string_view nearestKey(std::string_view key) {
  const std::string_view start = key.substr(0, 100);
  // A key without its section: "hurst".
  for (const Parameter& row : kTable)
    if (row.key.ends_with(start) && row.key.size() > start.size() &&
        row.key[row.key.size() - start.size() - 1] == '.')
      return row.key;
  // The beginning of a key: "interface.friction".
  std::string_view beginning = start;
  if (start.find('.') == start.npos) {
    beginning = nearestSection(start);  // "surfaces"
    if (beginning == start) return {};  // a section has no value itself
  }
  for (const Parameter& row : kTable)
    if (!beginning.empty() && row.key.starts_with(beginning) && !beginning.ends_with('.'))
      return row.key;
  std::vector<std::string_view> keys;
  for (const Parameter& row : kTable) keys.push_back(row.key);
  return nearestWord(key, keys);
}

namespace {

std::string valueText(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return plainNumber(*real);
  return std::visit([](const auto& held) { return fmt::format("{}", held); }, value);
}

}  // namespace

std::string parameterTableText() {
  std::string text;
  for (const Parameter& row : parameters()) {
    const std::string usual = valueText(defaultValue(row));
    text += fmt::format("  {:<28} {} ({}{})\n", row.key, row.sentence, allowedText(row),
                        usual.empty() ? "" : "; default " + usual);
  }
  return text;
}

std::string escapedMarkdown(std::string_view text) {
  std::string plain;
  for (const char letter : text) {
    if (std::string_view("\\`*_{}[]<>#+-!|~^$\"'").find(letter) != std::string_view::npos)
      plain += '\\';
    plain += letter;
  }
  return plain;
}

std::string parameterListMarkdown() {
  std::string text;
  for (const Parameter& row : parameters()) {
    std::string anchor(row.key);
    std::ranges::replace(anchor, '.', '-');
    const std::string usual = valueText(defaultValue(row));
    text += fmt::format("[`{}`]{{#key-{}}} {}{}\n\n:   {}\n\n", row.key, anchor,
                        escapedMarkdown(allowedText(row).english()),
                        usual.empty() ? "" : "; default " + escapedMarkdown(usual),
                        escapedMarkdown(row.sentence));
  }
  return text;
}

}  // namespace asperity
