#include "core/contact/arms/arm_tangent.h"

#include <algorithm>
#include <cmath>

namespace asperity {

ArmTangent::ArmTangent(const ArmCoefficients& memory)
    : memory_(memory),
      unknowns_(memory.arms() + 1),
      strain_(memory.arms() * unknowns_),
      mode_(memory.modes() * unknowns_),
      row_(unknowns_),
      volume_(unknowns_),
      change_(memory.arms() * unknowns_) {}

void ArmTangent::begin() {
  std::fill(strain_.begin(), strain_.end(), 0);
  std::fill(volume_.begin(), volume_.end(), 0);
  std::fill(change_.begin(), change_.end(), 0);
  for (std::size_t i = 0; i < memory_.arms(); ++i) strain_[i * unknowns_ + i + 1] = 1;
}

/// Strains decay; what they lose is yielded.
void ArmTangent::contact(double length) {
  volume_[0] += length;
  for (std::size_t i = 0; i < memory_.arms(); ++i) {
    const double lost = -std::expm1(-length * memory_.inverse[i]);
    double *strain = &strain_[i * unknowns_], *change = &change_[i * unknowns_];
    for (std::size_t k = 0; k < unknowns_; ++k) {
      change[k] += lost * strain[k];
      strain[k] -= lost * strain[k];
    }
  }
}

void ArmTangent::leave(double length) {
  contact(length);
  const std::size_t arms = memory_.arms();
  for (std::size_t j = 0; j < memory_.modes(); ++j) {
    double* mode = &mode_[j * unknowns_];
    std::fill(mode, mode + unknowns_, 0);
    const double* ofYield = &memory_.conversion.ofYield[j * arms];
    mode[0] = memory_.settled[j];
    for (std::size_t i = 0; i < arms; ++i) {
      const double* strain = &strain_[i * unknowns_];
      for (std::size_t k = 0; k < unknowns_; ++k) mode[k] -= ofYield[i] * strain[k];
    }
  }
}

void ArmTangent::arc(double length) {
  const std::size_t arms = memory_.arms();
  for (std::size_t j = 0; j < memory_.modes(); ++j) {
    const double z = memory_.rate[j] * length, back = std::expm1(-z);
    const double mean = z > 0 ? -back / z * length : length;
    double* mode = &mode_[j * unknowns_];
    for (std::size_t k = 0; k < unknowns_; ++k) {
      volume_[k] += mean * mode[k];
      row_[k] = back * mode[k];
      mode[k] += row_[k];
    }
    const double* toYield = &memory_.conversion.toYield[j * arms];
    for (std::size_t i = 0; i < arms; ++i) {
      double* change = &change_[i * unknowns_];
      for (std::size_t k = 0; k < unknowns_; ++k) change[k] += toYield[i] * row_[k];
    }
  }
}

void ArmTangent::enter(double length) {
  arc(length);
  const std::size_t arms = memory_.arms();
  // Strains of the free surface, and what the line presses it in beyond.
  std::fill(row_.begin(), row_.end(), 0);
  row_[0] = 1;
  for (std::size_t j = 0; j < memory_.modes(); ++j)
    for (std::size_t k = 0; k < unknowns_; ++k) row_[k] -= mode_[j * unknowns_ + k];
  for (std::size_t i = 0; i < arms; ++i)
    std::copy(row_.begin(), row_.end(), &strain_[i * unknowns_]);
  for (std::size_t j = 0; j < memory_.modes(); ++j) {
    const double *mode = &mode_[j * unknowns_], *toStrain = &memory_.conversion.toStrain[j * arms];
    for (std::size_t i = 0; i < arms; ++i) {
      double* strain = &strain_[i * unknowns_];
      for (std::size_t k = 0; k < unknowns_; ++k) strain[k] += toStrain[i] * mode[k];
    }
  }
}

void ArmTangent::finish(double length, bool touching) {
  touching ? contact(length) : arc(length);
}

}  // namespace asperity
