// Sums of Fourier modes at equally spaced nodes and back, by FFTW with estimated plans, so that
// the same input gives the same bits in every run.
// Threading: a FourierTransform may be used by several threads at once; making one is serialised
// inside (FFTW's planner is not reentrant).
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/surface/spectrum.h"

namespace asperity {

class FourierTransform {
 public:
  explicit FourierTransform(std::size_t nodes);
  ~FourierTransform();
  FourierTransform(FourierTransform&&) noexcept;

  std::size_t nodes() const;

  /// Height (m) of the line at x_i = i length / nodes. Modes above the nodes' Nyquist limit must be
  /// absent.
  void evaluate(const FourierLine& line, std::vector<double>& height) const;

  /// Its slope there, from the spectrum.
  void evaluateSlope(const FourierLine& line, std::vector<double>& slope) const;

  /// The band-limited line through the nodes: mean removed, Nyquist mode dropped.
  FourierLine analyse(std::span<const double> height, double length) const;

 private:
  template <class Factor>
  void transform(const FourierLine& line, std::vector<double>& target, const Factor& factor) const;

  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace asperity
