// A material as charts: the measurements, the master curve with its fit, the shifts; and for a
// scene that uses it the moduli over frequency with the measured range and the band that the line
// excites at the present velocity. Pure; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/chart/diagram.h"
#include "core/friction/excitation.h"
#include "core/material/material_model.h"
#include "core/scene/scene.h"

namespace asperity {

/// Returns "isotherms", "master_curve" (with fit and residuals), "loss_tangent", "shifts"; for a
/// ready series "master_curve" and "loss_tangent".
std::vector<NamedSheet> materialSheets(const Material& material);

/// Returns storage modulus, loss modulus and loss tangent of the scene's elastomer over frequency
/// at its temperature, with the measured range, and the band that the line excites at the scene's
/// velocity with its weights. The excitation may be kept while only the velocity changes.
DiagramSheet excitationSheet(const Scene& scene, const Excitation& excitation);
DiagramSheet excitationSheet(const Scene& scene);

/// Returns frequency, storage_modulus, loss_modulus, loss_tangent, excitation_weight at the
/// frequencies of the line's waves.
std::string excitationCsv(const Scene& scene, const Excitation& excitation);

/// Returns {"frequency_from", "frequency_median", "frequency_to", "measured_from", "measured_to",
/// "share_not_measured"}; null where a value does not apply.
nlohmann::ordered_json excitationJson(const Scene& scene, const Excitation& excitation);

/// Returns the band in words for explain: "5 % of the loss lies below 3 Hz, ...".
Message describeExcitation(const Scene& scene, const Excitation& excitation);

}  // namespace asperity
