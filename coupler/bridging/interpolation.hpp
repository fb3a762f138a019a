// How the motion of one participant enters the velocity constraint.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "protocol/messages/wire.pb.h"

namespace adit::coupler {

// The sparse matrix N that takes the velocities of one side's own points to the coupling points, and the
// inverse lumped masses of these points [1/kg], 0 where a motion is prescribed. Rows sum to 1; entries may be
// negative, where a side's points lie a little inside its edge. Vectors of velocities and impulses are
// interleaved, x then y.
class Interpolation {
 public:
  // By rows (compressed): row k has the entries row_starts[k] to row_starts[k + 1]. A side of several
  // participants has the points of all of them, numbered through.
  Interpolation(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
                std::vector<double> values, std::vector<double> inverse_masses);

  // Checks everything that came over the wire; `peer` is named in the message of a PeerLost.
  Interpolation(const wire::Operator& op, std::size_t coupling_points, const std::string& peer);

  std::size_t coupling_points() const { return row_starts_.size() - 1; }
  std::size_t own_points() const { return inverse_masses_.size() / 2; }
  std::span<const std::uint32_t> columns(std::size_t row) const;
  std::span<const double> values(std::size_t row) const;
  std::span<const double> inverse_masses() const { return inverse_masses_; }

  // Each coupling point is a point of its own with the same velocity (eq. 5 of the paper: N = identity).
  bool is_selection() const;

  void gather(std::span<const double> impulses, std::span<double> own) const;         // own = N^T impulses
  void interpolate(std::span<const double> own, std::span<double> velocities) const;  // velocities = N own
  void divide_by_mass(std::span<double> own) const;                                   // own *= 1/M

 private:
  std::vector<std::uint32_t> row_starts_, columns_;
  std::vector<double> values_, inverse_masses_;
};

}  // namespace adit::coupler
