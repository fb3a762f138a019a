// How far the points of a model have moved since they were somewhere, as statics tell it (wire.proto,
// Relaxation).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "protocol/kernels/sums.hpp"
#include "protocol/state/archive.hpp"

namespace adit::protocol {

// Steps between two looks: who goes away is told in thousands of them, and a look, with the bodies of bonded
// particles, costs as much as some steps.
inline constexpr std::uint64_t kTravelInterval = 500;

class Travel {
 public:
  // From these displacements on, one of each point.
  Travel(std::span<const double> ux, std::span<const double> uy)
      : from_x_(ux.begin(), ux.end()), from_y_(uy.begin(), uy.end()) {}

  struct Farthest {
    double distance;  // [m]
    std::size_t at;   // the point
  };
  Farthest farthest(std::span<const double> ux, std::span<const double> uy) const {
    std::vector<double> x(ux.begin(), ux.end()), y(uy.begin(), uy.end());
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] -= from_x_[i];
      y[i] -= from_y_[i];
    }
    const VectorSizes sizes = sizes_of(x, y);
    return {sizes.largest, sizes.at};
  }

  void exchange(state::Archive& archive) {
    archive("travel_from_x", std::span(from_x_));
    archive("travel_from_y", std::span(from_y_));
  }

 private:
  std::vector<double> from_x_, from_y_;
};

}  // namespace adit::protocol
