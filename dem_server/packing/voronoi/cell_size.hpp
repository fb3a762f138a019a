// How large the cells of a packing are from place to place.
#pragma once

#include <functional>
#include <vector>

#include "protocol/geometry/shape.hpp"

namespace adit::dem {

// A place whose cells are smaller than others.
struct FinerPlace {
  std::function<double(const geometry::Point&)> distance;  // from the place, at most 0 in it [m]
  double size;                                             // [m]
};

// The size is the spacing of the hexagonal lattice whose cells have the same mean area, 0.866 size^2 [m].
// From a finer place on it grows by a quarter of the distance, so that neighbours differ by a fifth.
class CellSize {
 public:
  CellSize(double size) : largest_(size) {}  // NOLINT(google-explicit-constructor): the same everywhere
  CellSize(double largest, std::vector<FinerPlace> finer);

  double at(const geometry::Point& point) const;
  // No cell within this distance of the point is smaller, as far as the size at the point tells.
  double least_around(const geometry::Point& point, double distance) const;
  double least() const { return least_; }
  double largest() const { return largest_; }
  const std::vector<FinerPlace>& finer() const { return finer_; }

 private:
  double largest_, least_ = largest_;
  std::vector<FinerPlace> finer_;
};

}  // namespace adit::dem
