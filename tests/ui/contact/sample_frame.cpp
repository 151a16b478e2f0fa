#include "tests/ui/contact/sample_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr double kShearModulus = 1e7, kRelaxationTime = 1e-3;

struct SampleLine {
  std::vector<double> height, slope;
};

/// A self-affine sum of cosines with fixed, well mixed phases; every point its own height and
/// slope.
SampleLine line(const SampleOptions& o) {
  SampleLine line{std::vector<double>(o.points), std::vector<double>(o.points)};
  // One turn in as many steps as there are points: cosines of all modes are among its values.
  std::vector<double> cosine(o.points), sine(o.points);
  for (int i = 0; i < o.points; ++i) {
    cosine[i] = std::cos(2 * std::numbers::pi * i / o.points);
    sine[i] = std::sin(2 * std::numbers::pi * i / o.points);
  }
  const int modes = std::max(1, o.points / 2 - 1);
  double square = 0;
  for (int k = 1; k <= modes; ++k) square += 0.5 * std::pow(k, -2 * o.hurst - 1);
  for (int k = 1; k <= modes; ++k) {
    const double amplitude = o.rmsHeight * std::sqrt(std::pow(k, -2 * o.hurst - 1) / square);
    const double wave = 2 * std::numbers::pi * k / o.length;
    const double phase =
        2 * std::numbers::pi * std::fmod(0.618034 * k * k + 0.31 * k, 1.0) - wave * o.distance;
    const double c = amplitude * std::cos(phase), s = amplitude * std::sin(phase);
    for (int i = 0, step = 0; i < o.points; ++i, step = (step + k) % o.points) {
      line.height[i] += c * cosine[step] - s * sine[step];
      line.slope[i] -= wave * (c * sine[step] + s * cosine[step]);
    }
  }
  return line;
}

/// The steady surface: each element relaxes towards 0 or is held down by the line.
void press(Frame& frame, const SampleLine& line, double velocity) {
  const auto n = static_cast<std::int64_t>(line.height.size());
  const double relaxation = std::abs(velocity) * kRelaxationTime;
  const double keep = relaxation > 0 ? std::exp(-frame.spacing / relaxation) : 0;
  const std::int64_t way = velocity >= 0 ? -1 : 1;  // material arrives from ahead of the line
  const auto lowest = std::min_element(line.height.begin(), line.height.end());
  std::int64_t i = lowest - line.height.begin();
  double u = 0;
  for (std::int64_t step = 0; step < 2 * n; ++step, i = (i + way + n) % n) {
    const double z = frame.lineHeight[i];
    const double released = u * keep;
    u = std::min({0.0, z, released});
    frame.surfaceHeight[i] = u;
    const double p = 4 * kShearModulus * (-z + velocity * kRelaxationTime * line.slope[i]);
    frame.pressure[i] = u == z && z <= released && z < 0 ? std::max(p, 0.0) : 0.0;
  }
}

void sumUp(Frame& frame, const SampleLine& line) {
  double square = 0, slopeSquare = 0;
  const auto n = static_cast<double>(line.height.size());
  for (std::size_t i = 0; i < line.height.size(); ++i) {
    frame.state.normalForce += frame.pressure[i] * frame.spacing;
    frame.state.tangentialForce += frame.pressure[i] * line.slope[i] * frame.spacing;
    frame.state.contactFraction += frame.pressure[i] > 0 ? 1 / n : 0;
    square += line.height[i] * line.height[i] / n;
    slopeSquare += line.slope[i] * line.slope[i] / n;
  }
  frame.state.tangentialForce = std::abs(frame.state.tangentialForce);
  frame.rmsHeight = std::sqrt(square);
  frame.rmsSlope = std::sqrt(slopeSquare);
  frame.state.mu = frame.state.normalForce > 0
                       ? frame.state.tangentialForce / frame.state.normalForce
                       : kNotApplicable;
}

}  // namespace

std::shared_ptr<const Frame> sampleFrame(const SampleOptions& o) {
  auto scene = std::make_shared<Scene>();
  scene->title = o.title;
  scene->surface.length = o.length;
  scene->surface.elements = o.points;
  scene->sliding.velocity = o.velocity;
  auto frame = std::make_shared<Frame>();
  frame->scene = scene;
  frame->length = o.length;
  frame->spacing = o.length / o.points;
  frame->timeScale = o.timeScale;
  frame->distance = o.distance;
  frame->time = o.velocity != 0 ? std::abs(o.distance / o.velocity) : 0;
  frame->state.indentation = o.depth;
  const SampleLine z = line(o);
  const double lowest = *std::min_element(z.height.begin(), z.height.end());
  for (const double height : z.height) frame->lineHeight.push_back(height - lowest - o.depth);
  frame->surfaceHeight.resize(z.height.size());
  frame->pressure.resize(z.height.size());
  press(*frame, z, o.velocity);
  sumUp(*frame, z);
  return frame;
}

}  // namespace asperity
