// The converged reference, as rows.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity {

struct ConvergedRow {
  double normalForce, velocity, mu, contactFraction, rmsSlopeContact, indentation;
};

inline std::vector<ConvergedRow> convergedRows() {
  std::ifstream stream(std::string(ASPERITY_TESTS_DIR) + "/reference/converged_public.csv");
  if (!stream) throw std::runtime_error("converged_public.csv is missing");
  std::vector<ConvergedRow> rows;
  double force = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("# normal_force=")) force = std::stod(line.substr(15));
    if (line.empty() || line.find_first_not_of("0123456789") == 0) continue;
    for (char& letter : line)
      if (letter == ',') letter = ' ';
    ConvergedRow row{force, 0, 0, 0, 0, 0};
    std::istringstream(line) >> row.velocity >> row.mu >> row.contactFraction >>
        row.rmsSlopeContact >> row.indentation;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace asperity
