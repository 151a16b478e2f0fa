// The dictionary of columns: every column of every table that the program writes is declared here
// once, with its unit, its meaning and its equation. Writers name their columns by ColumnName,
// which does not compile for a word that is not in the dictionary, so that no table can have a
// column that `asperity columns` does not know. Constant; any thread.
#pragma once

#include <array>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

struct Column {
  std::string_view name;
  std::string_view unit;      // SI; empty for a pure number or a word
  std::string_view meaning;   // one sentence
  std::string_view equation;  // where there is one
  std::string_view tables;    // that have it, separated by ", "
};

/// Tables of curves and of other states; the figures of the paper beside them.
inline constexpr std::string_view kCurveTables = "curve, curves, map, cutoff",
                                  kFrictionTables =
                                      "curve, curves, map, cutoff, figure 2, figure 3, figure 4, "
                                      "figure master, figure spacing";

// Symbols in equations: z(x) the rigid line, x along the line, u <= 0 the surface of the elastomer,
// y = -u, d the indentation, p the line load, L the period, L_c the length in contact, F_N the
// normal force, F_x the tangential force, h the rms height, grad the rms slope.
inline constexpr auto kColumns = std::to_array<Column>({
    // ---- friction over velocity
    {"velocity", "m/s", "Velocity of steady sliding.", "v_i = from (to/from)^(i/(points - 1))",
     kFrictionTables},
    {"mu", "", "Coefficient of friction of the deformation: mean over the realizations.",
     "mu = |F_x|/F_N, F_x = -integral p z' dx", kFrictionTables},
    {"mu_standard_error", "",
     "Standard error of that mean, for rows of a topography with their correlation; empty for one "
     "realization.",
     "s/sqrt(realizations) of independent lines",
     "curve, curves, map, cutoff, figure 2, figure 3, figure 4, figure master, figure spacing, "
     "batch"},
    {"mu_law", "",
     "Friction by Eq. (11) of Li et al. (2013) with the rms slope of the whole line and the "
     "tabulated beta.",
     "Eq. (11), alpha = H/(1 + H)", kFrictionTables},
    {"contact_fraction", "", "Share of the period that is in contact.", "L_c/L",
     "curve, curves, map, cutoff, figure 2, figure 3, figure 4, figure 6, figure master, figure "
     "spacing, batch"},
    {"rms_slope_contact", "", "Root mean square of the line's slope where it is in contact.",
     "sqrt(integral over contact of z'^2 dx / L_c)", kFrictionTables},
    {"indentation", "m",
     "Indentation of the line: how deep its lowest point lies below the undeformed surface.", "d",
     "curve, curves, map, cutoff, figure 2, figure 3, figure 4, figure master, figure spacing, "
     "batch"},
    {"normalized_mu", "", "Coefficient of friction over the rms slope of the whole line.",
     "mu/grad", kFrictionTables},
    {"dimensionless_velocity", "", "Velocity without a dimension.",
     "Eq. (13): tau v grad/(sqrt(2) h)", kFrictionTables},
    {"dimensionless_force", "", "Normal force without a dimension.", "Eq. (14): F_N/(G h L)",
     "curve, curves, map, cutoff, figure 2, figure 3, figure 4, figure 6, figure master, figure "
     "spacing"},
    {"realizations", "", "Random lines that were averaged over.", "",
     "curve, curves, map, cutoff, figure 2, figure 3, figure 4, figure 5, figure 6, figure master, "
     "figure spacing, batch"},
    {"mu_interface", "",
     "Coefficient of local friction in contact, beside that of the deformation; only in scenes "
     "that have some.",
     "friction_coefficient, or shear_stress L_c/F_N", kCurveTables},
    {"reduced_velocity", "m/s",
     "Velocity at which the rubber is as fast at the temperature of the scene; only where measured "
     "friction is of another temperature.",
     "v a_T(T)/a_T(T_scene)", "curves"},
    {"temperature", "K",
     "Temperature of the curve, or of the measured point; only where measured friction is of "
     "another temperature.",
     "T", "curves"},
    {"mu_total", "", "Friction of deformation and interface together.", "mu + mu_interface",
     "curve, curves, map, cutoff, batch"},
    {"mu_mean_of_ratios", "",
     "Mean over the lines of each line's own coefficient, which is mu; only at a constant "
     "indentation.",
     "<F_x/F_N>", kCurveTables},
    {"mu_ratio_of_means", "",
     "Mean tangential force over mean normal force; only at a constant indentation.", "<F_x>/<F_N>",
     kCurveTables},
    {"marginal_share", "",
     "Share of its load that the element on the edge of contact carries, mean over the lines; 1 "
     "where the force does not jump; only with the scheme nodal.",
     "", kCurveTables},
    {"mu_low", "",
     "Lower end of the 95 % confidence interval of mu, errors of resolution included; only with a "
     "target accuracy.",
     "", kCurveTables},
    {"mu_high", "", "Upper end of the same interval.", "", kCurveTables},
    {"extrapolated", "",
     "1 where more than a tenth of the friction rests on frequencies at which the elastomer was "
     "not measured, else 0; only where the measured ones are known.",
     "share of q C(q) G''(q v) dq", kCurveTables},
    {"notes", "",
     "What to know before the row is used, separated by blanks; only where there is something. "
     "unresolved_friction: the elements are too few in contact for the tangential force; "
     "slope_above_0.3: the model assumes small slopes; few_contacts: single summits carry the "
     "load; seam_jump: the period repeats with a step; spikes: single points of the measured "
     "surface stand far out of their neighbours; coarse_heights: its heights have steps that make "
     "its lines too steep; round_form: it is part of a circle, which no parabola removes; "
     "few_independent_rows: its rows count as fewer than about ten "
     "independent lines, and the standard error is only roughly known; "
     "extrapolated_material, extrapolated_temperature, strain_beyond_measured: the elastomer was "
     "not measured at the frequencies that friction rests on, at this temperature, at strains as "
     "large as the slopes.",
     "", kCurveTables},
    {"normal_force", "N",
     "Normal force on one period; only where a nominal pressure means it, over another key than "
     "velocity, and in maps.",
     "F_N = p_0 L width", kCurveTables},
    {"tangential_force", "N",
     "Mean tangential force of the deformation on one period; only over another key than velocity, "
     "where a chart shows forces, and in maps.",
     "|F_x| = mu F_N", kCurveTables},
    {"power", "W",
     "Mean power that sliding puts into the deformation on one period; where tangential_force is.",
     "|F_x| v", kCurveTables},
    {"nominal_pressure", "Pa", "Normal force over the area of one period and the width.", "p_0",
     kCurveTables},
    {"mean_pressure", "Pa", "Normal force over the area in contact: contact length times width.",
     "p_0 L/L_c", kCurveTables},
    {"contact_spots", "",
     "Separate contact spots in one period: mean over the realizations; only in scenes with "
     "a measured surface or spectrum, a nominal pressure, or a measured material.",
     "", kCurveTables},
    {"exponent", "",
     "Exponent of friction along the first parameter, by a parabola through neighbouring cells.",
     "d ln mu / d ln x", "map"},
    {"series", "", "Which curve a row belongs to.", "", "curves"},
    {"relative_difference", "", "Difference from the present curve over that curve.",
     "mu_compared/mu - 1", "curves"},
    {"relative_difference_standard_error", "", "Standard error of the relative difference.", "",
     "curves"},

    // ---- waves and parameters that friction rests on
    {"cutoff_wavelength", "m", "Waves of the line shorter than it are removed.", "lambda_c",
     "cutoff"},
    {"share_of_decade", "",
     "Part of all friction that one decade of wavelengths makes, from the cut-off before.",
     "(mu_i - mu_(i-1)) / (mu log10(lambda_(i-1)/lambda_i))", "cutoff"},
    {"share_of_decade_standard_error", "", "Its standard error, on common lines.", "", "cutoff"},
    {"key", "", "Key of a parameter of the scene.", "", "sensitivity"},
    {"value", "", "Its value in the scene, in SI units.", "p", "sensitivity"},
    {"mu_exponent", "",
     "By how many per cent friction changes where the parameter changes by one per cent, "
     "deformation and interface together.",
     "d ln mu / d ln p", "sensitivity"},
    {"mu_exponent_standard_error", "", "Its standard error.", "", "sensitivity"},

    // ---- a motion in time
    {"time", "s",
     "Time since the motion began, at the end of the time step. Velocity, forces and friction are "
     "means over the step: compare them with a formula at its middle, half a step earlier.",
     "t", "motion"},
    {"displacement", "m", "Distance that the line has moved along x since the beginning.",
     "integral v dt", "motion"},
    {"velocity", "m/s", "Velocity of the line along x: mean over the time step.",
     "v = displacement in the step / dt", "motion"},
    {"normal_force", "N", "Normal force on one period, in the time step.", "F_N = integral p dx",
     "motion"},
    {"tangential_force", "N",
     "Force of the elastomer on the line along x, below 0 while it resists motion towards +x. It "
     "is defined at rest, too, where contact is still one-sided.",
     "F_x = -integral p z' dx, z' over the way of the time step", "motion"},
    {"mu", "", "Coefficient of friction of the deformation in the time step.", "mu = |F_x|/F_N",
     "motion"},
    {"indentation", "m", "Indentation at the end of the time step, from the lowest point.", "d",
     "motion"},
    {"contact_fraction", "", "Share of the period that is in contact, in whole elements.", "L_c/L",
     "motion"},
    {"contact_spots", "", "Separate contact spots in one period.", "", "motion"},
    {"power_in", "W",
     "Power that sliding puts into the elastomer; below 0 where the elastomer pushes the line on.",
     "-F_x v", "motion"},
    {"power_dissipated", "W",
     "Power that the dashpots of all elements turn into heat; the springs store the rest.",
     "-F_x v + F_N dd/dt = power_dissipated + rate of the stored energy", "motion"},
    {"mu_interface", "",
     "Coefficient of local friction in contact, beside that of the deformation; empty at rest and "
     "where the scene has none.",
     "friction_coefficient, or shear_stress L_c/F_N", "motion"},
    {"realization", "", "Number of the line, from 0 on.", "", "motion"},

    // ---- the line and the contact
    {"position", "m", "Place along the line.", "x_i = i dx", "surface, figure 1"},
    {"height", "m", "Height of the rigid line above its mean.", "z", "surface"},
    {"line_height", "m", "Height of the rigid line above the undeformed surface.", "z - d",
     "figure 1"},
    {"surface_height", "m", "Height of the elastomer's surface above the undeformed one.", "u",
     "figure 1"},
    {"pressure", "N/m", "Line load; 0 where nothing touches.",
     "p = -4 (G u + eta du/dt) in contact", "figure 1"},

    // ---- the contact at one moment; each point stands for one spacing of the line
    {"position", "m", "Place in the elastomer, within one period.", "x_i = i dx", "shape"},
    {"rigid_height", "m", "Height of the rigid line above the undeformed surface.", "z - d",
     "shape"},
    {"surface_height", "m", "Height of the elastomer's surface above the undeformed one.", "u",
     "shape"},
    {"gap", "m", "Distance of line and surface; 0 in contact.", "z - d - u", "shape"},
    {"line_load", "N/m", "Normal force over length; 0 where nothing touches.",
     "p = -4 (G u + eta du/dt) in contact", "shape"},
    {"time_in_contact", "s",
     "Time since the point came into contact; 0 outside of contact, empty where it is not known: "
     "at rest, in complete contact, in a motion.",
     "way to the edge of contact ahead / v", "shape"},
    {"power", "W/m",
     "Power over length that the point turns into heat, by its dashpots and by local friction.",
     "4 eta (du/dt)^2 + tau |v|", "shape"},
    {"time_since_contact", "s",
     "Time since the point was last in contact; 0 in contact, empty where it never was.", "",
     "shape"},
    {"start", "m", "Left edge of the contact spot or gap; it may pass the end of the period.", "",
     "contacts, gaps"},
    {"length", "m", "Length of the contact spot or gap, in whole spacings.", "", "contacts, gaps"},
    {"normal_force", "N", "Normal force of the contact spot.", "integral p dx", "contacts"},
    {"tangential_force", "N",
     "Force of the elastomer on the line along x, below 0 where it resists motion towards +x.",
     "-integral p z' dx", "contacts"},
    {"mean_line_load", "N/m", "Normal force over the length of the contact spot.", "", "contacts"},
    {"largest_line_load", "N/m", "Largest line load of the contact spot.", "max p", "contacts"},
    {"mean_gap", "m", "Area of the gap over its length.", "", "gaps"},
    {"largest_gap", "m", "Largest distance of line and surface in the gap.", "", "gaps"},
    {"area", "m^2", "Area between line and surface.", "integral (z - d - u) dx", "gaps"},
    {"velocity", "m/s", "Velocity of the line.", "v", "power"},
    {"power_in", "W", "Power of the whole friction.", "(|F_x| + interface) |v|", "power"},
    {"power_contact", "W", "Power that the elastomer dissipates in contact.",
     "integral over contact of 4 eta (du/dt)^2 dx", "power"},
    {"power_free", "W", "Power that the elastomer dissipates while its surface recovers.",
     "integral outside of contact of 4 eta (du/dt)^2 dx", "power"},
    {"power_interface", "W", "Power of local friction in contact.",
     "(friction_coefficient F_N + shear_stress L_c) |v|", "power"},
    {"power_dissipated", "W", "Sum of the three.", "", "power"},
    {"power_difference", "W",
     "Power in minus power dissipated: in steady sliding the error of the points, in a motion also "
     "what the springs store.",
     "", "power"},
    {"realization", "", "Number of the random line, from 0 on.", "", "realizations"},
    {"velocity", "m/s", "Velocity of steady sliding.", "v", "realizations"},
    {"mu", "", "Coefficient of friction of the deformation of this line.", "mu = |F_x|/F_N",
     "realizations"},
    {"mu_interface", "", "Coefficient of local friction in contact; 0 where the scene has none.",
     "", "realizations"},
    {"contact_fraction", "", "Share of the period that is in contact.", "L_c/L", "realizations"},
    {"rms_slope_contact", "", "Root mean square of this line's slope where it is in contact.", "",
     "realizations"},
    {"indentation", "m", "Indentation of this line, from its lowest point.", "d", "realizations"},
    {"normal_force", "N", "Normal force on one period.", "F_N", "realizations"},
    {"tangential_force", "N", "Tangential force on one period, its magnitude.", "|F_x|",
     "realizations"},
    {"rms_slope", "", "Rms slope of this whole line.", "grad", "realizations"},
    {"wave_number", "1/m", "Wave number of a wave of the line.", "q_k = 2 pi k/L", "spectrum"},
    {"power_spectral_density", "m^3", "Two-sided spectral density of the line.",
     "C(q_k) = |a_k|^2/(4 dq), h^2 = 2 sum C dq", "spectrum"},
    {"reliable", "",
     "1 where the wave number lies in the reliable band of a measured surface, else 0.", "",
     "spectrum"},
    {"quantity", "", "Name of a value of the line, or of a measured surface (ISO 21920-2).", "",
     "statistics"},
    {"unit", "", "Unit of the value; empty for a pure number.", "", "statistics"},
    {"value", "",
     "The value: of the line that slides; of a parameter of ISO 21920-2, of the measured row after "
     "processing, before its seam and its isotropic equivalent.",
     "", "statistics"},
    {"raw", "", "The same of the file before processing; empty where there is none.", "",
     "statistics"},

    // ---- fits of measured friction, and a material
    {"mu_measured", "", "Measured coefficient of friction.", "", "fit"},
    {"mu_error", "", "Its error as the table gives it; empty where there is none.", "", "fit"},
    {"mu_band", "", "Standard error of the computed friction by the errors of the parameters.",
     "sqrt(J C J')", "fit"},
    {"measured_over_computed", "", "Measured over computed coefficient of friction.", "", "fit"},
    {"temperature", "K", "Temperature of the isotherm, or of the measurement.", "T",
     "material, fit"},
    {"frequency", "Hz", "Frequency at which it was measured.", "f", "material"},
    {"storage_modulus", "Pa", "Storage modulus of shear.", "G'", "material"},
    {"loss_modulus", "Pa", "Loss modulus of shear.", "G''", "material"},
    {"loss_tangent", "", "Loss over storage modulus.", "tan delta = G''/G'", "material"},
    {"reduced_frequency", "Hz", "Frequency shifted to the reference temperature.", "f a_T",
     "material"},
    {"reduced_storage_modulus", "Pa", "Storage modulus shifted to the reference temperature.",
     "G'/b_T", "material"},
    {"reduced_loss_modulus", "Pa", "Loss modulus shifted to the reference temperature.", "G''/b_T",
     "material"},
    {"fitted_storage_modulus", "Pa", "Storage modulus of the Prony series there.",
     "G_inf + sum G_i w^2 tau_i^2/(1 + w^2 tau_i^2)", "material"},
    {"fitted_loss_modulus", "Pa", "Loss modulus of the Prony series there.",
     "sum G_i w tau_i/(1 + w^2 tau_i^2)", "material"},
    {"log10_shift", "", "Logarithm of the factor on all relaxation times.", "log10 a_T",
     "material"},
    {"log10_shift_standard_error", "", "Its standard error against the reference temperature.", "",
     "material"},
    {"log10_vertical_shift", "", "Logarithm of the factor on the moduli; not used by a scene.",
     "log10 b_T", "material"},
    {"log10_shift_storage", "", "The horizontal shift from the storage modulus alone.", "log10 a_T",
     "material"},
    {"log10_shift_loss", "", "The horizontal shift from the loss modulus alone.", "log10 a_T",
     "material"},
    {"log10_shift_wlf", "", "The shift by the fitted formula of Williams, Landel and Ferry.",
     "-c1 (T - T_r)/(c2 + T - T_r)", "material"},
    {"log10_shift_arrhenius", "", "The shift by the fitted formula of Arrhenius.",
     "E_a/(R ln 10) (1/T - 1/T_r)", "material"},
    {"overlap_mismatch", "",
     "Rms difference from the next warmer isotherm where both overlap, in decades of modulus.", "",
     "material"},
    {"overlap_decades", "", "Decades of frequency in which the two overlap.", "", "material"},
    {"excitation_weight", "",
     "Loss in complete contact per decade of frequency, over its largest value.",
     "q^2 C(q) G''(q v)", "material"},
    {"relaxation_time", "s", "Relaxation time of an arm; empty for the equilibrium modulus.",
     "tau_i", "material"},
    {"modulus", "Pa", "Shear modulus of the arm.", "G_i", "material"},

    // ---- what accuracy costs
    {"region", "", "Region of the friction curve, I to IV.", "", "accuracy"},
    {"velocity_from", "m/s", "Lowest velocity of the region.", "", "accuracy"},
    {"velocity_to", "m/s", "Highest velocity of the region.", "", "accuracy"},
    {"method", "", "How contact is computed.", "", "accuracy"},
    {"oversampling", "", "Points per element.", "", "accuracy"},
    {"relative_error", "",
     "Error of mu against the reference: root mean square over velocities and "
     "lines.",
     "rms(mu/mu_reference - 1)", "accuracy"},
    {"largest_error", "", "The largest of these errors.", "max |mu/mu_reference - 1|", "accuracy"},
    {"is_model_difference", "",
     "1 where the method solves another model, so that it is a difference and not an error.", "",
     "accuracy"},
    {"seconds", "s", "Processor time of one simulation: median.", "", "accuracy"},
    {"seconds_lower_quartile", "s", "Lower quartile of that time.", "", "accuracy"},
    {"seconds_upper_quartile", "s", "Upper quartile of that time.", "", "accuracy"},
    {"line_seconds", "s", "Processor time of making the line.", "", "accuracy"},
    {"seconds_with_line", "s", "Processor time of one simulation with its part of making the line.",
     "", "accuracy"},
    {"is_extrapolated", "", "1 where the time was extrapolated from a part of the work.", "",
     "accuracy"},
    {"is_on_front", "", "1 where no other method has less error in less time.", "", "accuracy"},
    {"is_present_choice", "", "1 for the method of the scene.", "", "accuracy"},
    {"reference_error", "", "Estimated relative error of the reference itself.", "", "accuracy"},

    // ---- figures of the paper
    {"curve", "", "Which way of computing a row comes from.", "", "figure 2"},
    {"hurst", "", "Hurst exponent of the line.", "H", "figure 3, figure 5, figure 6"},
    {"normal_force", "N", "Normal force on one period.", "F_N", "figure 4, figure 6"},
    {"alpha", "", "Fitted exponent of the force.", "Eq. (7): mu ~ F_N^(-alpha)", "figure 5"},
    {"alpha_standard_error", "", "Standard error of alpha.", "", "figure 5"},
    {"alpha_law", "", "Exponent that the paper gives.", "H/(1 + H)", "figure 5"},
    {"alpha_up_to_1", "", "The same exponent, fitted up to a dimensionless force of 1.",
     "Eq. (7): mu ~ F_N^(-alpha)", "figure 5"},
    {"alpha_up_to_1_standard_error", "", "Standard error of that exponent.", "", "figure 5"},
    {"beta", "", "Fitted prefactor.", "Eq. (11)", "figure 5"},
    {"beta_standard_error", "", "Standard error of beta.", "", "figure 5"},
    {"plateau", "", "Height of the plateau.", "largest mu/grad", "figure 6"},
    {"plateau_standard_error", "", "Standard error of that height.", "", "figure 6"},
    {"velocity_of_plateau", "m/s", "Velocity at which it is reached.", "", "figure 6"},
    {"slope_in_contact_over_slope", "", "Rms slope in contact over that of the whole line.",
     "grad_contact/grad", "figure 6"},
    {"variant", "", "Which set of parameters a row belongs to.", "", "figure master"},
    {"velocity_shift", "m/s", "Velocity by which the velocities of the curve are divided.",
     "Eq. (16)", "figure master"},
    {"friction_shift", "", "Number by which the friction of the curve is divided.", "Eq. (17)",
     "figure master"},
    {"spacing", "m", "Distance of the elements: the shortest wave is two of them long.", "dx",
     "figure spacing"},
    {"rms_slope", "", "Rms slope of the whole line.", "grad", "figure spacing"},

    // ---- a study: with these the keys that it varies and its outputs
    {"simulation", "", "Number of the simulation in the study, from 0 on.", "", "study"},
    {"output", "",
     "The number of a curve that a row is about; curve.NAME for one of a whole curve, fit.NAME for "
     "what sums it up.",
     "", "study"},
    {"sweep_value", "",
     "Value of the key over which the curve goes; empty at the scene's velocity.", "", "study"},
    {"value", "", "The number itself.", "", "study"},
    {"key", "", "Scene key that is varied.", "", "study"},
    {"key_value", "", "Mean of the key in a part of its axis.", "", "study"},
    {"first_order", "",
     "Share of the variance that the key explains alone (first-order Sobol index).",
     "Var(E(y|x))/Var(y), Saltelli et al. (2010), Table 2 (b)", "study"},
    {"first_order_low", "", "Lower end of its 95 % confidence interval.", "", "study"},
    {"first_order_high", "", "Upper end of the same interval.", "", "study"},
    {"total_effect", "",
     "Share of the variance that is left when all other keys are fixed (total-effect Sobol index).",
     "E(Var(y|others))/Var(y), Jansen (1999)", "study"},
    {"total_effect_low", "", "Lower end of its 95 % confidence interval.", "", "study"},
    {"total_effect_high", "", "Upper end of the same interval.", "", "study"},
    {"correlation", "",
     "Pearson's correlation with the key, or with its logarithm where it is varied over it.", "",
     "study"},
    {"rank_correlation", "", "Spearman's correlation with the key.", "", "study"},
    {"mean", "", "Mean over the simulations in a part of the key's axis.", "", "study"},
    {"mean_standard_error", "", "Standard error of that mean.", "", "study"},
    {"count", "", "Simulations in the mean.", "", "study"},
    {"percentile_5", "", "Number below which 5 % of the simulations are.", "", "study"},
    {"percentile_25", "", "Number below which 25 % of them are.", "", "study"},
    {"percentile_50", "", "The median.", "", "study"},
    {"percentile_75", "", "Number below which 75 % of them are.", "", "study"},
    {"percentile_95", "", "Number below which 95 % of them are.", "", "study"},
    {"error", "", "Why the simulation could not be computed; empty where it could.", "", "study"},

    {"fit.maximum", "",
     "Largest mu of the curve over the sweep: of the parabola in ln x through the highest three "
     "points on a logarithmic axis, else of the highest point.",
     "", "study"},
    {"fit.place_of_maximum", "",
     "Value of the swept key there, in its SI unit; empty where the highest point is an end of the "
     "curve.",
     "", "study"},
    {"fit.half_width", "",
     "Decades of the swept key over which mu is above half its maximum; empty where the curve ends "
     "before.",
     "log10(x_2/x_1), mu(x_1) = mu(x_2) = mu_max/2", "study"},
    {"fit.exponent", "",
     "Exponent of the power law through all points of the curve, by least squares of logarithms.",
     "mu ~ x^exponent", "study"},
    {"fit.exponent_residual", "", "Rms distance of the points from that law, in ln mu.", "",
     "study"},
    {"fit.plateau", "",
     "Mean of mu in region III; empty where the curve has none, and of regions only where the "
     "elastomer has one relaxation time.",
     "", "study"},
    {"fit.begin_of_region_2", "m/s",
     "Velocity from which on mu is 20 % below its line through region I; empty where the curve "
     "does not show it.",
     "", "study"},
    {"fit.begin_of_region_3", "m/s",
     "Velocity at which 95 % of the maximum is reached; empty where the curve does not show it.",
     "", "study"},
    {"fit.begin_of_region_4", "m/s",
     "Velocity at which mu falls below 95 % of its maximum; empty where the curve does not show "
     "it.",
     "", "study"},
    {"fit.exponent_region_1", "",
     "Exponent of the power law through the points in region I; empty with fewer than three.",
     "mu ~ v^exponent", "study"},
    {"fit.exponent_region_2", "", "The same in region II.", "mu ~ v^exponent", "study"},
    {"fit.exponent_region_3", "", "The same in region III.", "mu ~ v^exponent", "study"},
    {"fit.exponent_region_4", "", "The same in region IV.", "mu ~ v^exponent", "study"},

    // ---- batch: with these the keys that its sweeps vary
    {"name", "", "Name of the scene and of its files.", "", "batch"},
    {"mu", "",
     "Coefficient of friction at the scene's velocity: mean over the realizations; empty for a "
     "motion.",
     "mu = |F_x|/F_N", "batch"},
    {"line_mu", "", "Coefficient of friction of the line that the picture shows.", "mu = |F_x|/F_N",
     "batch"},
    {"line_indentation", "m", "Indentation of that line.", "d", "batch"},
    {"line_contact_fraction", "", "Share of the period of that line that is in contact.", "L_c/L",
     "batch"},
    {"error", "", "Why the scene could not be computed; empty where it could.", "", "batch"},
});

/// The name of a column of the dictionary; a word that is not there does not compile.
class ColumnName {
 public:
  consteval ColumnName(const char* name) : name_(name) {
    for (const Column& column : kColumns)
      if (column.name == name_) return;
    throw std::logic_error("a column that is not in the dictionary");
  }

  constexpr operator std::string_view() const { return name_; }
  std::string text() const { return std::string(name_); }

 private:
  std::string_view name_;
};

/// Returns the column of a scene key over which a curve or a map goes: the last word of the key.
constexpr std::string_view columnOfKey(std::string_view key) {
  return key.substr(key.rfind('.') + 1);
}

/// Returns the names as the columns of a table.
std::vector<std::string> columnNames(std::initializer_list<ColumnName> names);

/// For people: names with units, then meaning, equation and tables; and for machines.
std::string columnsText();
std::string columnsJson();

}  // namespace asperity
