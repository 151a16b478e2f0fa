#include "core/chart/explanations.h"

#include <algorithm>
#include <array>

#include "core/chart/curve_regions.h"
#include "core/friction/theory_curve.h"
#include "core/scene/parameters.h"

namespace asperity {

namespace {

// The states of arms: ∂s_i/∂t = ∂u/∂t − s_i/τ_i.
constexpr std::string_view kPressureOfArms =
    "p = −4 (G∞ u + Σ G_i s_i + η ∂u/∂t), ∂s_i/∂t = ∂u/∂t − s_i/τ_i";

constexpr std::array kTable{
    // ---- scene keys: their sentences are those of the table of parameters
    HoverExplanation{"surface.length", "L", "", "rough-line"},
    HoverExplanation{"surface.elements", "N = L/Δx, q_max = π/Δx", "", "rough-line"},
    HoverExplanation{"surface.hurst", "C(q) ∝ q^(−2H−1)", "", "rough-line"},
    HoverExplanation{"surface.rms_height", "h² = 2 ∫ C(q) dq", "", "rough-line"},
    HoverExplanation{"surface.roll_off_wavelength", "C(q) = const, q < 2π/λ_r", "", "rough-line"},
    HoverExplanation{"surface.summit_correlation",
                     "z = z_long + z_short √(1 − κ z_long/rms(z_long))", "", "rough-line"},
    HoverExplanation{"surface.seed", "z(x) = Σ a_k cos(q_k x + φ_k)", "", "rough-line"},
    HoverExplanation{"surface.amplitude", "z = A cos(2π n x/L)", "", "rough-line"},
    HoverExplanation{"surface.waves", "z = A cos(2π n x/L)", "", "rough-line"},
    HoverExplanation{"surface.slope", "z(x) = ∓s x, |z′| = s", "", "rough-line"},
    HoverExplanation{"surface.radius", "z = x²/(2R)", "", "rough-line"},
    HoverExplanation{"elastomer.shear_modulus", "p = −4 (G u + η ∂u/∂t)", "", "foundation"},
    HoverExplanation{"elastomer.relaxation_time", "τ = η/G", "", "foundation"},
    HoverExplanation{"elastomer.equilibrium_modulus", "G(t) = G∞ + Σ G_i exp(−t/τ_i)", "", "arms"},
    HoverExplanation{"elastomer.viscosity", "G″(ω) = ωη + Σ G_i ωτ_i/(1 + ω²τ_i²)", "", "arms"},
    HoverExplanation{"elastomer.arms", "G(t) = G∞ + Σ G_i exp(−t/τ_i)", "", "arms"},
    HoverExplanation{"elastomer.temperature", "τ(T) = a_T τ", "", "temperature"},
    HoverExplanation{"elastomer.shift.c1", "log₁₀ a_T = −C₁ (T − T_r)/(C₂ + T − T_r)", "",
                     "temperature"},
    HoverExplanation{"elastomer.shift.c2", "log₁₀ a_T = −C₁ (T − T_r)/(C₂ + T − T_r)", "",
                     "temperature"},
    HoverExplanation{"elastomer.shift.reference_temperature", "a_T(T_r) = 1", "", "temperature"},
    HoverExplanation{"elastomer.shift.activation_energy", "ln a_T = E_a/R (1/T − 1/T_r)", "",
                     "temperature"},
    HoverExplanation{"load.normal_force", "F_N = 4 ∫ [G (d − z) + η v z′] dx, Eq. (3)", "", "eq-3",
                     "F_N = −4 ∫ (G∞ u + Σ G_i s_i + η ∂u/∂t) dx"},
    HoverExplanation{"load.depth", "u = z − d (p > 0)", "", "foundation"},
    HoverExplanation{"load.nominal_pressure", "F_N = p₀ L w", "", "pressure"},
    HoverExplanation{"load.width", "F_N = p₀ L w", "", "pressure"},
    HoverExplanation{"sliding.velocity", "p = 4 (G [d − z] + η v z′)", "", "steady",
                     kPressureOfArms},
    HoverExplanation{"sliding.amplitude", "v(t) = v + Δv sin(2π f t)", "", "motion"},
    HoverExplanation{"sliding.frequency", "v(t) = v + Δv sin(2π f t)", "", "motion"},
    HoverExplanation{"interface.friction_coefficient", "μ_total = μ + μ_interface", "",
                     "local-friction"},
    HoverExplanation{"interface.shear_stress", "μ_interface = s L_c/F_N", "", "local-friction"},
    HoverExplanation{"interface.shear_velocity", "s = s₀ exp(−c log₁₀²(a_T v/v₀))", "",
                     "local-friction"},
    HoverExplanation{"interface.shear_width", "s = s₀ exp(−c log₁₀²(a_T v/v₀))", "",
                     "local-friction"},
    HoverExplanation{"ensemble.realizations", "s/√n", "", "statistics"},
    HoverExplanation{"accuracy.target_relative_error", "", "", "target-accuracy"},

    // ---- quantities of a chart's axis, by their column
    HoverExplanation{"mu", "μ = |F_x|/F_N, F_x = −∫ p z′ dx",
                     "Coefficient of friction: the tangential force that deforms the elastomer, "
                     "over the normal force.",
                     "eq-4"},
    HoverExplanation{"mu_total", "μ_total = μ + μ_interface",
                     "Coefficient of friction as it is measured: what deforming the elastomer "
                     "costs and local friction together.",
                     "local-friction"},
    HoverExplanation{"normalized_mu", "μ/∇z",
                     "Coefficient of friction over the rms slope of the line.", "eq-9"},
    HoverExplanation{"contact_fraction", "L_c/L",
                     "Share of the line's length that touches the "
                     "elastomer.",
                     "foundation"},
    HoverExplanation{"rms_slope_contact", "∇z_cont = √(∫ z′² dx/L_c)",
                     "Rms slope of the line where it touches the elastomer.", "eq-15"},
    HoverExplanation{"indentation", "u = z − d (p > 0)",
                     "How deep the lowest point of the line lies below the undeformed surface.",
                     "foundation"},
    HoverExplanation{"tangential_force", "F_x = −4 ∫ z′ [G (d − z) + η v z′] dx, Eq. (4)",
                     "The force that sliding takes, on one period of the line.", "eq-4",
                     "F_x = 4 ∫ z′ (G∞ u + Σ G_i s_i + η ∂u/∂t) dx"},
    HoverExplanation{"power", "P = |F_x| v", "Power that sliding turns into heat.", "steady"},
    HoverExplanation{"mean_pressure", "F_N/(L_c w)",
                     "Normal force over the area in contact, contact length times width.",
                     "pressure"},
    HoverExplanation{"dimensionless_velocity", "v̄ = τ v ∇z/(√2 h), Eq. (13)",
                     "Velocity without a dimension: at 1 contacts become one-sided.", "eq-13"},
    HoverExplanation{"dimensionless_force", "F̄ = F_N/(G h L), Eq. (14)",
                     "Force without a dimension: at 1 contact becomes complete.", "eq-14"},

    // ---- regions of the curve: their sentences are those of the regions
    HoverExplanation{"region I", "μ ∝ v", "", "region-1"},
    HoverExplanation{"region II", "1/μ² = 1/μ_I² + 1/μ_III², Eq. (11)", "", "regions"},
    HoverExplanation{"region III", "μ ≈ √2 ∇z_cont", "", "region-3"},
    HoverExplanation{"region IV", "", "", "regions"},
    HoverExplanation{
        "few contacts carry the load", "F_N/(4 η v) < h/10",
        "The contacts of one period climb together less than a tenth of the rms height: "
        "results depend on single summits and on the period.",
        "regions"},

    // ---- legends, by their English text
    HoverExplanation{
        "this line", "μ = |F_x|/F_N",
        "Friction of the one line that the picture shows, at every velocity of the curve.",
        "steady"},
    HoverExplanation{
        "deformation alone, this line", "μ = |F_x|/F_N",
        "Friction of the one line that the picture shows, without what the interface adds.",
        "steady"},
    HoverExplanation{
        "mean of %1 lines ± standard error", "⟨μ⟩ ± s/√n",
        "Mean over random lines with the same statistics; the bars are the standard error "
        "of that mean, not the scatter of the lines.",
        "statistics"},
    HoverExplanation{
        "deformation alone, mean of %1 lines ± standard error", "⟨μ⟩ ± s/√n",
        "Mean over random lines of what the deformation costs, without what the interface "
        "adds.",
        "statistics"},
    HoverExplanation{
        "this line, now", "μ = |F_x|/F_N",
        "The state that the picture shows. Drag it, or use the arrow keys, and the picture "
        "follows.",
        "steady"},
    HoverExplanation{"this line, settled", "μ = |F_x|/F_N",
                     "The steady state to which the picture still moves. Drag it, or use the arrow "
                     "keys, and the picture follows.",
                     "steady"},
    HoverExplanation{"this motion, now", "μ(t) = |F_x(t)|/F_N",
                     "The motion at this moment, beside the curve of steady sliding.", "motion"},
    HoverExplanation{"now", "", "The moment that the picture shows.", "motion"},
    HoverExplanation{"before the change", "",
                     "The state before the change; the new one is being computed.", "steady"},
    HoverExplanation{
        "%1 minus the curve above", "(μ − μ_above)/μ_above",
        "How far friction changes where the same lines are computed with another setting.",
        "accuracy"},

    // ---- words and signs in the picture of the contact
    HoverExplanation{"rigid body", "z(x)",
                     "The rigid line and what is above it. It slides and does not deform.",
                     "rough-line"},
    HoverExplanation{
        "elastomer", "p = −4 (G u + η ∂u/∂t)",
        "Springs and dashpots side by side, each for itself; arms are springs and dashpots "
        "in series beside them.",
        "foundation", kPressureOfArms},
    HoverExplanation{"total friction", "μ_total = μ + μ_interface",
                     "Of deformation and interface together: friction force over normal force.",
                     "local-friction"},
    HoverExplanation{"pace", "",
                     "How many times slower or faster than in reality the picture moves; below the "
                     "contact it can be chosen.",
                     "motion"},
    HoverExplanation{
        "line load", "p = −4 (G u + η ∂u/∂t)",
        "The force with which the bodies press on each other, per length of the line. It is to a "
        "line what pressure is to an area.",
        "foundation", kPressureOfArms},
    HoverExplanation{
        "glow of the pressure", "p = −4 (G u + η ∂u/∂t)",
        "The glow is brighter and deeper where the line load is larger. It does not show "
        "how deep stresses reach, which the model does not know.",
        "foundation", kPressureOfArms},
    HoverExplanation{
        "time since contact", "u ∝ exp(−t/τ)",
        "How long ago the elastomer was in contact at this place. It recovers within a few "
        "relaxation times.",
        "foundation", "G∞ u + Σ G_i s_i + η ∂u/∂t = 0"},
    HoverExplanation{
        "dissipated power", "4 η (∂u/∂t)²",
        "What the dashpots and, in contact, the interface turn into heat, per length of "
        "the line; of the free surface, too, while it recovers.",
        "steady", "4 [η (∂u/∂t)² + Σ G_i s_i²/τ_i]"},
    HoverExplanation{
        "dot at a contact", "",
        "The dot marks a contact that is too narrow for its colour to be seen at this size.",
        "foundation"},
    HoverExplanation{
        "vertical exaggeration", "",
        "Heights are drawn this many times larger than lengths; true slopes are as many "
        "times flatter.",
        "rough-line"},
    HoverExplanation{"position along the line", "z(x + L) = z(x)",
                     "The place in the direction of sliding. The line repeats after its period.",
                     "rough-line"},
    HoverExplanation{"height above the surface", "z − d, u",
                     "0 is the surface of the elastomer where nothing has pressed on it.",
                     "foundation"},

    // ---- numbered equations of the paper
    HoverExplanation{"Eq. (1)", "f = −4 Δx {G u + η ∂u/∂t}",
                     "Force of one element of the elastomer: a spring and a dashpot side by side.",
                     "eq-1"},
    HoverExplanation{"Eq. (2)", "f = 4 Δx {G [d − z] + η v z′}",
                     "Force of an element in contact with a line that slides.", "eq-2"},
    HoverExplanation{"Eq. (3)", "F_N = 4 ∫ [G (d − z) + η v z′] dx",
                     "The contact carries the normal force, which gives the indentation.", "eq-3"},
    HoverExplanation{"Eq. (4)", "F_x = −4 ∫ z′ [G (d − z) + η v z′] dx",
                     "Tangential force: line load on slopes.", "eq-4"},
    HoverExplanation{"Eq. (5)", "μ = β τ v ∇z²/h · (G h L/F_N)^α",
                     "Friction in slow sliding and partial contact.", "eq-5"},
    HoverExplanation{"Eq. (6)", "μ = 4 L_c η ∇z_cont² v/F_N",
                     "Friction in slow sliding, from the slope where there is contact.", "eq-6"},
    HoverExplanation{"Eq. (7)", "α = H/(1 + H)",
                     "How friction in slow sliding falls with the normal force.", "eq-7"},
    HoverExplanation{"Eq. (8)", "μ = 4 L η ∇z² v/F_N",
                     "Friction in slow sliding and complete contact.", "eq-8"},
    HoverExplanation{"Eq. (9)", "μ ≈ √2 ∇z_cont",
                     "Friction on the plateau: only rising slopes carry load.", "eq-9"},
    HoverExplanation{"Eq. (10)", "μ = ∫ z′² dx/∫ |z′| dx", "Friction of a purely viscous contact.",
                     "eq-10"},
    HoverExplanation{
        "Eq. (11)",
        "μ = [1/(2∇z²) + (F_N/(4 L η ∇z² v))² + (h/(β τ ∇z² v) (F_N/(G h L))^α)²]^(−1/2)",
        "The law of the paper: it joins slow sliding, complete contact and the plateau; "
        "region IV is not in it. α = H/(1 + H); β falls from 2.7 at H = 0 to 1.3 at H = 1.",
        "law"},
    HoverExplanation{"Eq. (12)", "μ̄ = [1 + ((F̄/4)² + F̄^(2α))/v̄²]^(−1/2)",
                     "The law without dimensions.", "eq-12"},
    HoverExplanation{"Eq. (13)", "v̄ = τ v ∇z/(√2 h)",
                     "Velocity without a dimension: at 1 contacts become one-sided.", "eq-13"},
    HoverExplanation{"Eq. (14)", "F̄ = F_N/(G h L)",
                     "Force without a dimension: at 1 contact becomes complete.", "eq-14"},
    HoverExplanation{"Eq. (15)", "∇z_cont = (2 ∫ C q² dq)^(1/2), 2π/L_c ≈ q_cont ≤ q ≤ q_max",
                     "The slope in contact when few contacts are left.", "eq-15"},
    HoverExplanation{"Eq. (16)", "μ = ∇z_cont(F̄) g[v̄/f(F̄)]",
                     "All curves fall on one, when they are shifted along velocity and friction.",
                     "eq-16"},
    HoverExplanation{"Eq. (17)", "μ = ∇z_cont(F̄) g[τ v ∇z_cont/(√2 h)/f(F̄)]",
                     "The same with the slope in contact in the velocity.", "eq-17"},
};

constexpr std::array kSymbols{
    FormulaSymbol{"p", "line load"},
    FormulaSymbol{"G", "shear modulus"},
    FormulaSymbol{"η", "viscosity (G τ in Kelvin elements)"},
    FormulaSymbol{"d", "indentation"},
    FormulaSymbol{"u", "displacement of the surface"},
    FormulaSymbol{"z", "height of the line above its lowest point"},
    FormulaSymbol{"Δx", "distance between elements"},
    FormulaSymbol{"G_i", "modulus of an arm"},
    FormulaSymbol{"τ_i", "relaxation time of an arm"},
    FormulaSymbol{"s_i", "stretch of the spring of an arm"},
    FormulaSymbol{"∇z", "rms slope"},
    FormulaSymbol{"∇z_cont", "rms slope in contact"},
    FormulaSymbol{"L_c", "length in contact"},
    FormulaSymbol{"q", "wave number"},
    FormulaSymbol{"C", "spectral density of the line"},
    FormulaSymbol{"a_T", "factor of the relaxation times"},
};

/// Where the guide speaks of the keys of a section that have no formula.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kSections{{
    {"surface.kind", "rough-line"},
    {"surface.", "measured-surfaces"},
    {"elastomer.shift.", "temperature"},
    {"elastomer.measured.", "frequencies"},
    {"elastomer.", "foundation"},
    {"load.", "foundation"},
    {"sliding.", "motion"},
    {"sweep.", "axes"},
    {"accuracy.", "accuracy"},
    {"comparison.", "theories"},
}};

std::string_view sectionAnchor(std::string_view key) {
  for (const auto& [beginning, anchor] : kSections)
    if (key.starts_with(beginning)) return anchor;
  return "scenes";
}

/// Returns the sentence that another table has for the id.
std::string_view sentenceElsewhere(std::string_view id) {
  if (const Parameter* row = findParameter(id)) return row->sentence;
  constexpr std::string_view kRegion = "region ";
  if (id.starts_with(kRegion)) return regionSentence(id.substr(kRegion.size()));
  return {};
}

}  // namespace

std::span<const HoverExplanation> explanations() {
  return kTable;
}

std::span<const FormulaSymbol> formulaSymbols() {
  return kSymbols;
}

std::optional<HoverExplanation> findExplanation(std::string_view id) {
  HoverExplanation found{id, {}, {}, {}};
  if (const auto row = std::ranges::find(kTable, id, &HoverExplanation::id); row != kTable.end())
    found = *row;
  if (found.sentence.empty()) found.sentence = sentenceElsewhere(id);
  for (const TheoryEntry& entry : theoryEntries())
    if (found.sentence.empty() && id == entry.name) found = {id, {}, entry.range, "theories"};
  if (found.sentence.empty()) return std::nullopt;
  if (found.guideAnchor.empty()) found.guideAnchor = sectionAnchor(id);
  return found;
}

std::optional<HoverExplanation> findExplanation(const Message& text) {
  return text.empty() ? std::nullopt : findExplanation(std::string_view(text.text));
}

HoverExplanation withFormulaFor(HoverExplanation explanation, Rheology rheology) {
  if (hasArms(rheology) && !explanation.formulaOfArms.empty())
    explanation.formula = explanation.formulaOfArms;
  return explanation;
}

}  // namespace asperity
