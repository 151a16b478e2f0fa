// What one pass over a period gathers. Everything is per 4G, so that numbers are lengths only:
// multiply forces by 4G (Pa). Plain values.
#pragma once

#include <cstddef>
#include <vector>

namespace asperity {

/// Enough for the force balance.
struct ForceSums {
  double depth = 0;      // m^2, integral of y over all elements: F_N / 4G
  double stiffness = 0;  // m, its derivative with respect to the indentation
};

/// Everything a result states; the two ways to each force are summed apart, to be compared.
struct StateSums {
  double depth = 0;          // m^2, as above
  double stiffness = 0;      // m
  double pressure = 0;       // m^2, integral of p over contact: F_N / 4G again
  double work = 0;           // m^2, integral of p w' over contact: F_x / 4G
  double dissipation = 0;    // m^2, c integral of y'^2 over all elements: F_x / 4G again
  double contactLength = 0;  // m
  double slopeSquared = 0;   // m, integral of z'^2 over contact
  double absoluteSlope = 0;  // m, integral of |z'| over contact, of Eq. (10)
};

/// Shape of the elastomer at the nodes of a PreparedProfile, in travel order; filled on request.
struct NodeShape {
  std::vector<double> depth;     // m, y = -u
  std::vector<double> pressure;  // m, p / 4G, 0 where not in contact
};

}  // namespace asperity
