#include "core/friction/curve_quantity.h"

#include <array>

namespace asperity {
namespace {

template <double CurvePoint::*kMember>
double member(const CurvePoint& point) {
  return point.*kMember;
}

constexpr std::array<QuantityEntry, 9> kEntries{{
    {CurveQuantity::Mu, "mu", "coefficient of friction \u03BC", "", member<&CurvePoint::mu>, true},
    {CurveQuantity::MuTotal, "mu_total", "coefficient of friction \u03BC with local friction", "",
     totalMu, true},
    {CurveQuantity::NormalizedMu, "normalized_mu", "normalized friction \u03BC / \u2207z", "",
     member<&CurvePoint::normalizedMu>, true},
    {CurveQuantity::ContactFraction, "contact_fraction", "contact fraction", "",
     member<&CurvePoint::contactFraction>, false},
    {CurveQuantity::RmsSlopeContact, "rms_slope_contact", "rms slope in contact", "",
     member<&CurvePoint::rmsSlopeContact>, false},
    {CurveQuantity::Indentation, "indentation", "indentation d", "m",
     member<&CurvePoint::indentation>, false},
    {CurveQuantity::TangentialForce, "tangential_force", "tangential force", "N",
     member<&CurvePoint::tangentialForce>, true},
    {CurveQuantity::Power, "power", "power", "W", member<&CurvePoint::power>, true},
    {CurveQuantity::MeanPressure, "mean_pressure", "mean pressure in contact", "Pa",
     member<&CurvePoint::contactPressure>, false},
}};

}  // namespace

std::span<const QuantityEntry> quantityEntries() {
  return kEntries;
}

const QuantityEntry& quantityEntry(CurveQuantity quantity) {
  return kEntries[static_cast<std::size_t>(quantity)];
}

std::optional<CurveQuantity> findQuantity(std::string_view word) {
  for (const QuantityEntry& entry : kEntries)
    if (std::string_view(entry.word) == word) return entry.quantity;
  return std::nullopt;
}

std::vector<std::string_view> quantityWords() {
  std::vector<std::string_view> words;
  for (const QuantityEntry& entry : kEntries) words.push_back(entry.word);
  return words;
}

}  // namespace asperity
