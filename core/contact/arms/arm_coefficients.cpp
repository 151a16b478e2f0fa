#include "core/contact/arms/arm_coefficients.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kSlowFrom = 10;  // relaxation length in periods
/// Relaxation length, in elements, below which everything is forgotten to the last digit.
constexpr double kMinLength = 1e-150;

}  // namespace

ArmCoefficients::ArmCoefficients(const ElementLaw& law, const RetardationModes& modes,
                                 double velocity, double spacing, double period, std::size_t levels)
    : dashpot(velocity * law.viscosity / law.equilibriumModulus), conversion(modes) {
  const double shortest = kMinLength * spacing;
  for (const Arm& arm : law.arms) {
    const double g = arm.modulus / law.equilibriumModulus;
    const double inverseLength = 1 / std::max(velocity * arm.relaxationTime, shortest);
    const double z = spacing * inverseLength;
    modulus.push_back(g);
    inverse.push_back(inverseLength);
    lossRate.push_back(g * inverseLength);
    glassy += g;
    const DrivenDecay decayed = drivenDecay(z);
    const auto moments = decayMoments(z);
    const auto drivenBy = drivenMoments(z);
    kept.push_back(decayed.kept);
    loss.push_back(lossForm(z));
    if (period * inverseLength * kSlowFrom < 1) {
      ++slow;
      creepKept.push_back(z * moments[0]);
      for (std::size_t k = 0; k < 3; ++k) creepDriven[k].push_back(z * drivenBy[0][k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      driven[k].push_back(decayed.driven[k]);
      moment[k].push_back(g * moments[k]);
      for (std::size_t l = 0; l < 3; ++l) own[k][l] += g * drivenBy[k][l];
    }
  }
  for (std::size_t j = 0; j < modes.modes(); ++j) {
    rate.push_back(std::min(modes.rate[j] / velocity, 1 / shortest));
    stiffness.push_back(modes.rate[j] / (modes.fluidity[j] * law.equilibriumModulus));
    settled.push_back(1 / stiffness.back());
  }
  double blockLength = spacing;
  for (std::size_t level = 0; level < levels; ++level, blockLength *= 4) {
    std::vector<double> left, gone;
    for (const double perMetre : rate) {
      left.push_back(std::exp(-perMetre * blockLength));
      gone.push_back(-std::expm1(-perMetre * blockLength));
    }
    decay.push_back(std::move(left));
    lost.push_back(std::move(gone));
  }
}

ArmTangent::ArmTangent(const ArmCoefficients& coefficients)
    : coefficients_(coefficients),
      unknowns_(coefficients.arms() + 1),
      strain_(coefficients.arms() * unknowns_),
      mode_(coefficients.modes() * unknowns_),
      row_(unknowns_),
      volume_(unknowns_),
      change_(coefficients.arms() * unknowns_) {}

void ArmTangent::begin() {
  std::fill(strain_.begin(), strain_.end(), 0);
  std::fill(volume_.begin(), volume_.end(), 0);
  std::fill(change_.begin(), change_.end(), 0);
  for (std::size_t i = 0; i < coefficients_.arms(); ++i) strain_[i * unknowns_ + i + 1] = 1;
}

/// The strains decay, and the creep takes what they lose.
void ArmTangent::contact(double length) {
  volume_[0] += length;
  for (std::size_t i = 0; i < coefficients_.arms(); ++i) {
    const double lost = -std::expm1(-length * coefficients_.inverse[i]);
    double *strain = &strain_[i * unknowns_], *change = &change_[i * unknowns_];
    for (std::size_t k = 0; k < unknowns_; ++k) {
      change[k] += lost * strain[k];
      strain[k] -= lost * strain[k];
    }
  }
}

void ArmTangent::leave(double length) {
  contact(length);
  const std::size_t arms = coefficients_.arms();
  for (std::size_t j = 0; j < coefficients_.modes(); ++j) {
    double* mode = &mode_[j * unknowns_];
    std::fill(mode, mode + unknowns_, 0);
    const double* ofCreep = &coefficients_.conversion.ofCreep[j * arms];
    mode[0] = coefficients_.settled[j];
    for (std::size_t i = 0; i < arms; ++i) {
      const double* strain = &strain_[i * unknowns_];
      for (std::size_t k = 0; k < unknowns_; ++k) mode[k] -= ofCreep[i] * strain[k];
    }
  }
}

void ArmTangent::arc(double length) {
  const std::size_t arms = coefficients_.arms();
  for (std::size_t j = 0; j < coefficients_.modes(); ++j) {
    const double z = coefficients_.rate[j] * length, back = std::expm1(-z);
    const double mean = z > 0 ? -back / z * length : length;
    double* mode = &mode_[j * unknowns_];
    for (std::size_t k = 0; k < unknowns_; ++k) {
      volume_[k] += mean * mode[k];
      row_[k] = back * mode[k];
      mode[k] += row_[k];
    }
    const double* toCreep = &coefficients_.conversion.toCreep[j * arms];
    for (std::size_t i = 0; i < arms; ++i) {
      double* change = &change_[i * unknowns_];
      for (std::size_t k = 0; k < unknowns_; ++k) change[k] += toCreep[i] * row_[k];
    }
  }
}

void ArmTangent::enter(double length) {
  arc(length);
  const std::size_t arms = coefficients_.arms();
  // These are the strains of the free surface, and those that the line adds by pressing it in.
  std::fill(row_.begin(), row_.end(), 0);
  row_[0] = 1;
  for (std::size_t j = 0; j < coefficients_.modes(); ++j)
    for (std::size_t k = 0; k < unknowns_; ++k) row_[k] -= mode_[j * unknowns_ + k];
  for (std::size_t i = 0; i < arms; ++i)
    std::copy(row_.begin(), row_.end(), &strain_[i * unknowns_]);
  for (std::size_t j = 0; j < coefficients_.modes(); ++j) {
    const double *mode = &mode_[j * unknowns_],
                 *toStrain = &coefficients_.conversion.toStrain[j * arms];
    for (std::size_t i = 0; i < arms; ++i) {
      double* strain = &strain_[i * unknowns_];
      for (std::size_t k = 0; k < unknowns_; ++k) strain[k] += toStrain[i] * mode[k];
    }
  }
}

void ArmTangent::finish(double length, bool touching) {
  if (touching)
    contact(length);
  else
    arc(length);
}

namespace {

void copy(const std::vector<double>& from, double* to) {
  std::copy(from.begin(), from.end(), to);
}

}  // namespace

ArmVectors::ArmVectors(const ArmCoefficients& from)
    : arms(from.arms()),
      modes(from.modes()),
      slow(from.slow),
      dashpot(from.dashpot),
      glassy(from.glassy),
      own(from.own),
      arm(arms),
      mode(modes),
      decay(from.decay.size(), modes),
      lost(from.lost.size(), modes),
      toStrain(modes, arms),
      toCreep(modes, arms),
      ofCreep(arms, modes) {
  for (std::size_t i = 0; i < arms; ++i) {
    const double g = from.modulus[i];
    arm.value(Inverse, i) = from.inverse[i];
    arm.value(Modulus, i) = g;
    arm.value(LossRate, i) = from.lossRate[i];
    arm.value(Kept, i) = from.kept[i];
    const LossForm& loss = from.loss[i];
    arm.value(LossOfStrain, i) = g * loss.ee;
    for (std::size_t k = 0; k < 3; ++k) {
      arm.value(Driven0 + k, i) = from.driven[k][i];
      arm.value(Moment0 + k, i) = from.moment[k][i];
      arm.value(LossWith0 + k, i) = g * loss.ed[k];
    }
    for (std::size_t k = 0; k < 6; ++k) lossOfSlopes[k] += g * loss.dd[k];
  }
  for (std::size_t i = 0; i < slow; ++i) {
    arm.value(CreepKept, i) = from.creepKept[i];
    for (std::size_t k = 0; k < 3; ++k) arm.value(CreepDriven0 + k, i) = from.creepDriven[k][i];
  }
  for (std::size_t j = 0; j < modes; ++j) {
    mode.value(Rate, j) = from.rate[j];
    mode.value(Stiffness, j) = from.stiffness[j];
    mode.value(Settled, j) = from.settled[j];
  }
  for (std::size_t level = 0; level < from.decay.size(); ++level) {
    copy(from.decay[level], decay.row(level));
    copy(from.lost[level], lost.row(level));
  }
  const RetardationModes& conversion = from.conversion;
  for (std::size_t j = 0; j < modes; ++j)
    for (std::size_t i = 0; i < arms; ++i) {
      toStrain.row(j)[i] = conversion.toStrain[j * arms + i];
      toCreep.row(j)[i] = conversion.toCreep[j * arms + i];
      ofCreep.row(i)[j] = conversion.ofCreep[j * arms + i];
    }
}

ArmWorkspace::ArmWorkspace(const ArmVectors& vectors)
    : creepChange(vectors.arms), rows(Rows, std::max(vectors.arms, vectors.modes)) {}

// Not inline, so that what is compiled for one instruction set has no part in it.
void ArmWorkspace::addLength(double length) {
  lengths.push_back(length);
}

}  // namespace asperity
