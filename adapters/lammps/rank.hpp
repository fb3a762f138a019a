// One rank of a run: obeys the orders of rank 0 (orders.hpp, which lists them; rank.cpp, what they hold).
#pragma once

#include <mpi.h>

#include <memory>
#include <span>
#include <vector>

#include "adapters/lammps/decomposition/decomposition.hpp"
#include "adapters/lammps/particles/conditions.hpp"
#include "adapters/lammps/particles/part.hpp"
#include "adapters/lammps/ranks/orders.hpp"
#include "protocol/participant/step.hpp"

namespace adit::lammps {

class Rank {
 public:
  explicit Rank(MPI_Comm ranks) : ranks_(ranks) {}

  Values obey(Order order, std::span<const double> values);

 private:
  void begin(std::span<const double> values);
  void renew();
  void find_tied();
  void correct(std::span<const double> velocities);
  Values step(std::span<const double> values);
  Values reached() const;
  Values energies() const;
  Values tell_motion() const;

  MPI_Comm ranks_;
  std::unique_ptr<Part> part_;
  std::unique_ptr<Decomposition> decomposition_;  // refers to the part
  Conditions conditions_;
  std::vector<double> tied_;  // numbers of particles
  struct Tied {
    std::uint32_t place, tie;
  };
  std::vector<Tied> tied_here_;
  bool from_rest_ = true;  // the last step
};

// A record of every law travels as so many values.
Values told(const std::vector<dem::PairLaw>& laws);

}  // namespace adit::lammps
