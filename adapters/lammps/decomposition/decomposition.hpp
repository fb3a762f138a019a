// How the particles are spread over the ranks, and which ghosts each sees: all of it is LAMMPS's.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <span>

#include "adapters/lammps/particles/part.hpp"
#include "protocol/geometry/bounding_box.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace adit::lammps {

class Carrier;

class Decomposition {
 public:
  // Of particles inside the box. Two may touch, or be joined, whose distance is at most `reach` [m]; lists
  // hold until it has shrunk by `skin` [m].
  Decomposition(MPI_Comm ranks, const geometry::BoundingBox& box, double reach, double skin, Part& part);
  ~Decomposition();

  // All ranks name all particles, numbered from `first` on: the columns of each, one particle after another.
  void add(std::uint32_t first, std::span<const double> particles);
  // Divides the box so that all ranks have as many particles; then pairs may be given to their ranks.
  void balance();
  // Particles go to the ranks where they are now, and ghosts and lists follow.
  void renew();
  // Ghosts move as the particles do that they show.
  void show();

  // Of this number, own or ghost; beyond all places where there is none.
  std::uint32_t place_of(double number) const;

 private:
  void place();
  Part::Near near() const;

  std::unique_ptr<LAMMPS_NS::LAMMPS> lammps_;
  Carrier* carrier_;
  MPI_Comm ranks_;
  Part& part_;
};

}  // namespace adit::lammps
