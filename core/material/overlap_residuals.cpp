#include "core/material/overlap_residuals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/statistics.h"

namespace asperity {
namespace {

constexpr double kRarity = 0.0027;  // of three standard errors of a normal distribution

double part(double numerator, double denominator) {
  return denominator > 0 ? numerator / denominator : 0;
}

/// Returns the probability that noise alone has a mean square of `count` deviations above this, by
/// Paulson's approximation of the F distribution (Abramowitz and Stegun, 26.6.15).
double rarityOfMeanSquare(double meanSquare, double count, double degreesOfFreedom) {
  const double root = std::cbrt(meanSquare), ofCount = 2 / (9 * count),
               ofFreedom = 2 / (9 * degreesOfFreedom);
  const double normal =
      ((1 - ofFreedom) * root - (1 - ofCount)) / std::sqrt(ofFreedom * root * root + ofCount);
  return 0.5 * std::erfc(normal / std::numbers::sqrt2);
}

}  // namespace

OverlapNoise::OverlapNoise(std::span<const OverlapResiduals> overlaps, Of of)
    : overlaps_(overlaps), of_(of) {
  OverlapResiduals::Modulus storage, loss;
  const auto add = [](OverlapResiduals::Modulus& sum, const OverlapResiduals::Modulus& one) {
    sum.squares += one.squares;
    sum.degreesOfFreedom += one.degreesOfFreedom;
    sum.products += one.products;
    sum.whiteProducts += one.whiteProducts;
    sum.neighbours += one.neighbours;
    sum.noiseSquares += one.noiseSquares;
    sum.noiseFreedom += one.noiseFreedom;
  };
  for (const OverlapResiduals& overlap : overlaps) {
    add(storage, overlap.storage);
    add(loss, overlap.loss);
  }
  // Sparse sweeps leave no residuals about their own curves.
  constexpr double kMinFreedom = 40;
  if (of_ == Of::Noise && storage.noiseFreedom + loss.noiseFreedom >= kMinFreedom) {
    storage_ = part(storage.noiseSquares, storage.noiseFreedom);
    loss_ = part(loss.noiseSquares, loss.noiseFreedom);
    freedom_ = storage.noiseFreedom + loss.noiseFreedom;
    return;
  }
  of_ = Of::Misfit;
  storage_ = part(storage.squares, storage.degreesOfFreedom);
  loss_ = part(loss.squares, loss.degreesOfFreedom);
  freedom_ = storage.degreesOfFreedom + loss.degreesOfFreedom;
  // White noise has products of both signs; only more than that is a correlation.
  constexpr double kSure = 2.5, kMax = 0.9;
  const double products = part(storage.products, storage_) - storage.whiteProducts +
                          part(loss.products, loss_) - loss.whiteProducts;
  const double neighbours = storage.neighbours + loss.neighbours;
  if (!(products > kSure * std::sqrt(neighbours))) return;
  const double correlation = std::min(kMax, products / neighbours);
  correlation_ = (1 + correlation) / (1 - correlation);
  freedom_ /= correlation_;
}

double OverlapNoise::ownScale(const OverlapResiduals& overlap) const {
  const OverlapResiduals::Modulus &storage = overlap.storage, &loss = overlap.loss;
  if (of_ == Of::Noise)
    return part(part(storage.noiseSquares, storage_) + part(loss.noiseSquares, loss_),
                storage.noiseFreedom + loss.noiseFreedom);
  return part(part(storage.squares, storage_) + part(loss.squares, loss_),
              storage.degreesOfFreedom + loss.degreesOfFreedom);
}

std::vector<double> OverlapNoise::deviations(Contrast OverlapResiduals::*contrast) const {
  std::vector<double> all;
  for (const OverlapResiduals& overlap : overlaps_) {
    const Contrast& one = overlap.*contrast;
    const double square = (one.storageGain * storage_ + one.lossGain * loss_) *
                          std::max(1.0, ownScale(overlap)) * correlation_;
    all.push_back(std::isfinite(one.value) && square > 0 ? one.value / std::sqrt(square) : 0);
  }
  return all;
}

double OverlapNoise::misfitOfShape() const {
  if (of_ != Of::Noise) return 0;
  double squares = 0, scaled = 0, noise = 0, degreesOfFreedom = 0, values = 0;
  for (const OverlapResiduals& overlap : overlaps_) {
    const double storage = overlap.storage.squares - overlap.storage.noiseSquares;
    const double loss = overlap.loss.squares - overlap.loss.noiseSquares;
    squares += storage + loss;
    scaled += (part(storage, storage_) + part(loss, loss_)) / std::max(1.0, ownScale(overlap));
    const double ofStorage = overlap.storage.degreesOfFreedom - overlap.storage.noiseFreedom;
    const double ofLoss = overlap.loss.degreesOfFreedom - overlap.loss.noiseFreedom;
    noise += ofStorage * storage_ + ofLoss * loss_;
    degreesOfFreedom += ofStorage + ofLoss;
    values += overlap.values;
  }
  if (!(degreesOfFreedom >= 1 && scaled > 0)) return 0;
  if (!(rarityOfMeanSquare(scaled / degreesOfFreedom, degreesOfFreedom, freedom_) < kRarity))
    return 0;
  return std::sqrt(std::max(0.0, squares - noise) / values);
}

bool OverlapNoise::areSignificant(const std::vector<double>& deviations) const {
  if (!(freedom_ >= 1)) return false;
  const double degreesOfFreedom = std::floor(freedom_);
  double largest = 0, squares = 0, count = 0;
  for (const double deviation : deviations) {
    if (deviation == 0) continue;
    largest = std::max(largest, std::abs(deviation));
    squares += deviation * deviation;
    ++count;
  }
  if (count == 0) return false;
  // Two tests share the allowed rarity.
  return count * (1 - studentProbability(largest, degreesOfFreedom)) < kRarity / 2 ||
         rarityOfMeanSquare(squares / count, count, degreesOfFreedom) < kRarity / 2;
}

}  // namespace asperity
