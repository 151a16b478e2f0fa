#include "core/chart/explanations.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/chart/curve_regions.h"
#include "core/friction/theories/theory.h"
#include "core/scene/parameters.h"

namespace asperity {

namespace {

constexpr std::array kTable{
    // ---- scene keys: their sentences are those of the table of parameters
    Explanation{"surface.length", "L", "", "rough-line"},
    Explanation{"surface.elements", "N = L/Δx, q_max = π/Δx", "", "rough-line"},
    Explanation{"surface.hurst", "C(q) ∝ q^(−2H−1)", "", "rough-line"},
    Explanation{"surface.rms_height", "h² = 2 ∫ C(q) dq", "", "rough-line"},
    Explanation{"surface.roll_off_wavelength", "C(q) = const, q < 2π/λ_r", "", "rough-line"},
    Explanation{"surface.summit_correlation", "z = z_long + z_short √(1 − κ z_long/rms(z_long))",
                "", "rough-line"},
    Explanation{"surface.seed", "z(x) = Σ a_k cos(q_k x + φ_k)", "", "rough-line"},
    Explanation{"surface.amplitude", "z = A cos(2π n x/L)", "", "rough-line"},
    Explanation{"surface.waves", "z = A cos(2π n x/L)", "", "rough-line"},
    Explanation{"surface.slope", "z(x) = ∓s x, |z'| = s", "", "rough-line"},
    Explanation{"surface.radius", "z = x²/(2R)", "", "rough-line"},
    Explanation{"elastomer.shear_modulus", "f = −4 Δx (G u + η ∂u/∂t), Eq. (1)", "", "foundation"},
    Explanation{"elastomer.relaxation_time", "τ = η/G", "", "foundation"},
    Explanation{"elastomer.equilibrium_modulus", "G(t) = G∞ + Σ G_i exp(−t/τ_i)", "", "arms"},
    Explanation{"elastomer.viscosity", "G''(ω) = ωη + Σ G_i ωτ_i/(1 + ω²τ_i²)", "", "arms"},
    Explanation{"elastomer.arms", "G(t) = G∞ + Σ G_i exp(−t/τ_i)", "", "arms"},
    Explanation{"elastomer.temperature", "τ(T) = a_T τ", "", "temperature"},
    Explanation{"elastomer.shift.c1", "log₁₀ a_T = −C₁ (T − T_r)/(C₂ + T − T_r)", "",
                "temperature"},
    Explanation{"elastomer.shift.c2", "log₁₀ a_T = −C₁ (T − T_r)/(C₂ + T − T_r)", "",
                "temperature"},
    Explanation{"elastomer.shift.reference_temperature", "a_T(T_r) = 1", "", "temperature"},
    Explanation{"elastomer.shift.activation_energy", "ln a_T = E_a/R (1/T − 1/T_r)", "",
                "temperature"},
    Explanation{"load.normal_force", "F_N = 4 ∫ [G (d − z) + η v z'] dx, Eq. (3)", "", "eq-3"},
    Explanation{"load.depth", "u = z − d in contact", "", "foundation"},
    Explanation{"load.nominal_pressure", "F_N = p₀ L w", "", "pressure"},
    Explanation{"load.width", "F_N = p₀ L w", "", "pressure"},
    Explanation{"sliding.velocity", "f = 4 Δx {G [d − z] + η v z'}, Eq. (2)", "", "steady"},
    Explanation{"sliding.amplitude", "v(t) = v + Δv sin(2π f t)", "", "motion"},
    Explanation{"sliding.frequency", "v(t) = v + Δv sin(2π f t)", "", "motion"},
    Explanation{"interface.friction_coefficient", "μ_total = μ + μ_interface", "",
                "local-friction"},
    Explanation{"interface.shear_stress", "μ_interface = s L_c/F_N", "", "local-friction"},
    Explanation{"interface.shear_velocity", "s = s₀ exp(−c log₁₀²(a_T v/v₀))", "",
                "local-friction"},
    Explanation{"interface.shear_width", "s = s₀ exp(−c log₁₀²(a_T v/v₀))", "", "local-friction"},
    Explanation{"ensemble.realizations", "s/√n", "", "statistics"},
    Explanation{"accuracy.target_relative_error", "", "", "target-accuracy"},

    // ---- quantities of a chart's axis, by their column
    Explanation{"mu", "μ = |F_x|/F_N, F_x = −∫ p z' dx",
                "Coefficient of friction: what deforming the elastomer costs, over the normal "
                "force.",
                "eq-4"},
    Explanation{"normalized_mu", "μ/∇z", "Coefficient of friction over the rms slope of the line.",
                "eq-9"},
    Explanation{"contact_fraction", "L_c/L",
                "Share of the line's length that touches the "
                "elastomer.",
                "foundation"},
    Explanation{"rms_slope_contact", "∇z_cont = √(∫ z'² dx/L_c)",
                "Rms slope of the line where it touches the elastomer.", "eq-15"},
    Explanation{"indentation", "d",
                "How deep the lowest point of the line lies below the undeformed surface.",
                "foundation"},
    Explanation{"tangential_force", "F_x = −4 ∫ z' [G (d − z) + η v z'] dx, Eq. (4)",
                "The force that sliding takes, on one period of the line.", "eq-4"},
    Explanation{"power", "P = |F_x| v", "Power that sliding turns into heat.", "steady"},
    Explanation{"mean_pressure", "F_N/(L_c w)",
                "Normal force over the area in contact, contact length times width.", "pressure"},
    Explanation{"dimensionless_velocity", "v̄ = τ v ∇z/(√2 h), Eq. (13)",
                "Velocity without a dimension: at 1 contacts become one-sided.", "eq-13"},
    Explanation{"dimensionless_force", "F̄ = F_N/(G h L), Eq. (14)",
                "Force without a dimension: at 1 contact becomes complete.", "eq-14"},

    // ---- regions of the curve: their sentences are those of the regions
    Explanation{"region I", "μ ∝ v", "", "region-1"},
    Explanation{"region II", "1/μ² = 1/μ_I² + 1/μ_III², Eq. (11)", "", "regions"},
    Explanation{"region III", "μ ≈ √2 ∇z_cont", "", "region-3"},
    Explanation{"region IV", "F_N/(4 η v) < 0.1 h", "", "regions"},
    Explanation{"few summits carry the load", "F_N/(4 η v) < 0.1 h",
                "The contacts of one period climb together less than a tenth of the rms height: "
                "results depend on single summits and on the period.",
                "regions"},

    // ---- legends, by their English text
    Explanation{"this line", "μ = |F_x|/F_N",
                "Friction of the one line that the picture shows, at every velocity of the curve.",
                "steady"},
    Explanation{"this line, deformation alone", "μ = |F_x|/F_N",
                "Friction of the one line that the picture shows, without what the interface adds.",
                "steady"},
    Explanation{"mean of %1 lines ± standard error", "⟨μ⟩ ± s/√n",
                "Mean over random lines with the same statistics; the bars are the standard error "
                "of that mean, not the scatter of the lines.",
                "statistics"},
    Explanation{"mean of %1 lines ± standard error, deformation alone", "⟨μ⟩ ± s/√n",
                "Mean over random lines of what the deformation costs, without what the interface "
                "adds.",
                "statistics"},
    Explanation{"this line, now", "μ = |F_x|/F_N",
                "The state that the picture shows. Drag it, or use the arrow keys, and the picture "
                "follows.",
                "steady"},
    Explanation{"this motion, now", "μ(t) = |F_x(t)|/F_N",
                "The motion at this moment, beside the curve of steady sliding.", "motion"},
    Explanation{"now", "", "The moment that the picture shows.", "motion"},
    Explanation{"before the change", "",
                "The state before the change; the new one is being computed.", "steady"},
    Explanation{"%1 minus the curve above", "(μ − μ_above)/μ_above",
                "How far friction changes where the same lines are computed with another setting.",
                "accuracy"},

    // ---- words and signs in the picture of the contact
    Explanation{"rigid body", "z(x)",
                "The rigid line and what is above it. It slides and does not deform.",
                "rough-line"},
    Explanation{"elastomer", "f = −4 Δx {G u + η ∂u/∂t}, Eq. (1)",
                "Springs and dashpots side by side, each for itself; arms are springs and dashpots "
                "in series beside them.",
                "foundation"},
    Explanation{"total friction", "μ_total = μ + μ_interface",
                "Of deformation and interface together: friction force over normal force.",
                "local-friction"},
    Explanation{"pace", "",
                "How many times slower or faster than in reality the picture moves; below the "
                "contact it can be chosen.",
                "motion"},
    Explanation{"contact pressure", "p = −4 (G u + η ∂u/∂t)",
                "Line load: the force with which the bodies press on each other, per length of the "
                "line.",
                "foundation"},
    Explanation{"glow of the pressure", "p = −4 (G u + η ∂u/∂t)",
                "The glow is brighter and deeper where the pressure is larger. It does not show "
                "how deep stresses reach, which the model does not know.",
                "foundation"},
    Explanation{"time since contact", "u ∝ exp(−t/τ)",
                "How long ago the elastomer was in contact at this place. It recovers within a few "
                "relaxation times.",
                "foundation"},
    Explanation{"dissipated power", "4 η (∂u/∂t)²",
                "What the dashpots and, in contact, the interface turn into heat, per length of "
                "the line; of the free surface, too, while it recovers.",
                "steady"},
    Explanation{"dot at a contact", "",
                "A contact too narrow to be seen at this size stands under the dot.", "foundation"},
    Explanation{"vertical exaggeration", "",
                "Heights are drawn this many times larger than lengths; true slopes are as many "
                "times flatter.",
                "rough-line"},
    Explanation{"position along the line", "0 ≤ x < L",
                "The place in the direction of sliding. The line repeats after its period.",
                "rough-line"},
    Explanation{"height above the surface", "u = z − d in contact",
                "0 is the surface of the elastomer where nothing has pressed on it.", "foundation"},

    // ---- numbered equations of the paper
    Explanation{"Eq. (1)", "f = −4 Δx {G u + η ∂u/∂t}",
                "Force of one element of the elastomer: a spring and a dashpot side by side.",
                "eq-1"},
    Explanation{"Eq. (2)", "f = 4 Δx {G [d − z] + η v z'}",
                "Force of an element in contact with a line that slides.", "eq-2"},
    Explanation{"Eq. (3)", "F_N = 4 ∫ [G (d − z) + η v z'] dx",
                "The contact carries the normal force, which gives the indentation.", "eq-3"},
    Explanation{"Eq. (4)", "F_x = −4 ∫ z' [G (d − z) + η v z'] dx",
                "Tangential force: pressure on slopes.", "eq-4"},
    Explanation{"Eq. (5)", "μ = β τ v ∇z²/h · (G h L/F_N)^α",
                "Friction in slow sliding and partial contact.", "eq-5"},
    Explanation{"Eq. (6)", "μ = 4 L_c η ∇z_cont² v/F_N",
                "Friction in slow sliding, from the slope where there is contact.", "eq-6"},
    Explanation{"Eq. (7)", "α = H/(1 + H)",
                "How friction in slow sliding falls with the normal force.", "eq-7"},
    Explanation{"Eq. (8)", "μ = 4 L η ∇z² v/F_N", "Friction in slow sliding and complete contact.",
                "eq-8"},
    Explanation{"Eq. (9)", "μ ≈ √2 ∇z_cont",
                "Friction on the plateau: only rising slopes carry load.", "eq-9"},
    Explanation{"Eq. (10)", "μ = ∫ z'² dx/∫ |z'| dx", "Friction of a purely viscous contact.",
                "eq-10"},
    Explanation{"Eq. (11)",
                "μ = [1/(2∇z²) + (F_N/(4 L η ∇z² v))² + (h/(β τ ∇z² v) (F_N/(G h L))^α)²]^(−1/2)",
                "The law of the paper: it joins slow sliding, complete contact and the plateau; "
                "region IV is not in it.",
                "law"},
    Explanation{"Eq. (12)", "μ̄ = [1 + ((F̄/4)² + F̄^(2α))/v̄²]^(−1/2)", "The law without dimensions.",
                "eq-12"},
    Explanation{"Eq. (13)", "v̄ = τ v ∇z/(√2 h)",
                "Velocity without a dimension: at 1 contacts become one-sided.", "eq-13"},
    Explanation{"Eq. (14)", "F̄ = F_N/(G h L)",
                "Force without a dimension: at 1 contact becomes complete.", "eq-14"},
    Explanation{"Eq. (15)", "∇z_cont = (2 ∫ C q² dq)^(1/2), 2π/L_c ≈ q_cont ≤ q ≤ q_max",
                "The slope in contact when few summits are left.", "eq-15"},
    Explanation{"Eq. (16)", "μ = ∇z_cont(F̄) g[v̄/f(F̄)]",
                "All curves fall on one, when they are shifted along velocity and friction.",
                "eq-16"},
    Explanation{"Eq. (17)", "μ = ∇z_cont(F̄) g[τ v ∇z_cont/(√2 h)/f(F̄)]",
                "The same with the slope in contact in the velocity.", "eq-17"},
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

std::string_view placeOfKey(std::string_view key) {
  for (const auto& [beginning, anchor] : kSections)
    if (key.starts_with(beginning)) return anchor;
  return "scenes";
}

/// Returns the sentence that another table has for the id.
std::string_view sentenceElsewhere(std::string_view id) {
  if (const Parameter* row = findParameter(id)) return row->sentence;
  constexpr std::string_view kRegion = "region ";
  if (id.starts_with(kRegion)) return sentenceOfRegion(id.substr(kRegion.size()));
  return {};
}

}  // namespace

std::span<const Explanation> explanations() {
  return kTable;
}

std::optional<Explanation> explanationOf(std::string_view id) {
  Explanation found{id, {}, {}, {}};
  if (const auto row = std::ranges::find(kTable, id, &Explanation::id); row != kTable.end())
    found = *row;
  if (found.sentence.empty()) found.sentence = sentenceElsewhere(id);
  for (const TheoryEntry& entry : theoryEntries())
    if (found.sentence.empty() && id == entry.name) found = {id, {}, entry.range, "theories"};
  if (found.sentence.empty()) return std::nullopt;
  if (found.guideAnchor.empty()) found.guideAnchor = placeOfKey(id);
  return found;
}

std::optional<Explanation> explanationOf(const Message& text) {
  return text.empty() ? std::nullopt : explanationOf(std::string_view(text.text));
}

std::vector<std::string_view> equationsIn(std::string_view text) {
  std::vector<std::string_view> found;
  for (const Explanation& one : kTable)
    if (one.id.starts_with("Eq. (") && text.find(one.id) != std::string_view::npos)
      found.push_back(one.id);
  return found;
}

}  // namespace asperity
