// One function for each figure: adds diagram, table and claims to a Figure that has its scene.
// Used by figure.cpp; each stands in its own file.
#pragma once

#include "core/paper/figure.h"

namespace asperity {

void addContactFigure(Figure& figure, const FigureOptions& options);
void addVelocityFigure(Figure& figure, const FigureOptions& options);
void addHurstFigure(Figure& figure, const FigureOptions& options);
void addForcesFigure(Figure& figure, const FigureOptions& options);
void addExponentsFigure(Figure& figure, const FigureOptions& options);
void addPlateauFigure(Figure& figure, const FigureOptions& options);
void addMasterFigure(Figure& figure, const FigureOptions& options);
void addSpacingFigure(Figure& figure, const FigureOptions& options);

}  // namespace asperity
