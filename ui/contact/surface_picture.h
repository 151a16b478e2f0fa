// The rigid line of a scene as a picture: its height over one period, and its power spectral
// density on logarithmic axes where it has one. Pure; any thread.
#pragma once

#include "core/scene/scene.h"
#include "core/surface/line.h"
#include "core/surface/spectrum.h"
#include "ui/draw/theme.h"
#include "ui/draw/draw_list.h"

namespace asperity {

struct SurfacePictureOptions {
  int width = 1280, height = 800;  // pixels
  float scale = 1;
  Theme theme = lightTheme();
};

/// modes: the line's spectrum; no coefficients: the line is given by a formula and fills the
/// picture.
DrawList composeSurface(const Scene& scene, const Line& line, const FourierLine& modes,
                        const SurfacePictureOptions& options);

}  // namespace asperity
