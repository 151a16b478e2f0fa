// Frames made without the simulation, for the tests of the pictures: a sum of cosines slides over
// Kelvin elements, material arriving from larger x. Pure; any thread.
#pragma once

#include <memory>

#include "core/run/frame.h"

namespace asperity {

struct SampleOptions {
  int points = 5000;
  double length = 0.02;     // m
  double rmsHeight = 5e-7;  // m; 0: flat
  double hurst = 0.7;
  double depth = 1e-6;  // m, below the lowest point
  double velocity = 1;  // m/s
  double distance = 0;  // m slid; moves the line along x
  double timeScale = 2e-3;
  const char* title = "Figure 1";
};

std::shared_ptr<const Frame> sampleFrame(const SampleOptions& options);

}  // namespace asperity
