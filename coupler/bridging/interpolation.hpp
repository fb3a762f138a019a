// The interpolation by which the motion of one side enters the velocity constraint.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "protocol/participant/interface/sparse_rows.hpp"

namespace adit::coupler {

enum class MassesOf { kTime, kStatics, kScaledStatics };

// The matrix N that takes the velocities of one side's own points to the coupling points, and the inverse
// lumped masses of these points [1/kg], 0 where a motion is prescribed. Rows sum to 1; entries may be
// negative, where a side's points lie a little inside its edge. Vectors of velocities and impulses are
// interleaved, x then y.
class Interpolation : public protocol::SparseRows {
 public:
  // A side of several participants has the points of all of them, numbered through.
  Interpolation(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
                std::vector<double> values, std::vector<double> inverse_masses,
                std::vector<double> scaled_inverse_masses = {});  // empty: those of time

  std::size_t coupling_points() const { return rows(); }
  std::size_t own_points() const { return inverse_masses_.size() / 2; }
  std::span<const double> inverse_masses() const { return inverse_masses_; }
  // What the masses are from now on. Statics have those of time, or scaled ones; what they hold does not
  // yield.
  void take_masses_of(MassesOf masses);

  void divide_by_mass(std::span<double> own) const;  // own *= 1/M

 private:
  std::vector<double> inverse_masses_, of_time_, of_scaled_statics_;
};

}  // namespace adit::coupler
