// Factors on a rectangular lattice of nodes, whose lines may have any distances: bilinear between the nodes,
// beyond the lattice those of its edge. A single line of nodes is constant across itself.
#pragma once

#include <string>
#include <vector>

namespace adit::protocol {

class FactorField {
 public:
  // A table with the columns `x_m,y_m,factor`, its rows in any order. Throws UserError without a path where
  // it is no such table, where factors are not above 0, or where a node is missing or stands twice.
  FactorField(const std::string& file, const std::string& content);

  double at(double x, double y) const;

 private:
  std::vector<double> x_, y_;    // of the lattice's lines, ascending [m]
  std::vector<double> factors_;  // of the nodes, row by row
};

}  // namespace adit::protocol
