// Sums of Fourier modes at equally spaced nodes and back, by FFTW with estimated plans, so that
// the same input gives the same bits in every run.
// Threading: a FourierTransform may be used by several threads at once; making one is serialised
// inside (FFTW's planner is not reentrant).
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
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
  /// absent. Returns false where `stop` was requested, which is looked at before and after the
  /// transform itself; heights are then missing.
  bool evaluate(const FourierLine& line, std::vector<double>& height,
                const std::stop_token& stop = {}) const;

  /// Its slope there, from the spectrum; likewise.
  bool evaluateSlope(const FourierLine& line, std::vector<double>& slope,
                     const std::stop_token& stop = {}) const;

  /// The band-limited line through the nodes: mean removed, Nyquist mode dropped.
  FourierLine analyse(std::span<const double> height, double length) const;

 private:
  template <class Factor>
  bool transform(const FourierLine& line, std::vector<double>& target, const Factor& factor,
                 const std::stop_token& stop) const;

  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace asperity
