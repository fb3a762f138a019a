// Thrust, moment and shear force of cuts through a lining of particles.
//
// A cut parts particles by their places at rest, as a line drawn on the material would: a pair crosses it if
// the line between its two centres at rest meets it. The cut lies between a part A on its left (for a lining:
// what lies counter-clockwise) and a part B. Newton's law for all particles of A, whose inner forces cancel,
// is
//   sum m a = loads on A + F,      d/dt (angular momentum about O) = moment of the loads + M_O,
// where F = sum f and M_O = sum [(c - O) x f + m] run over the pairs that cross the cut: f is the force on
// the particle in A, c the place where the two meet, and m the moment of a bond. On a particle at x_A with
// the lever arm c - x_A the pair has the moment (c - x_A) x f + m (laws/pair_kinematics.hpp), which together
// with (x_A - O) x f gives that term. So F and M_O are the resultants of a beam theory exactly, whatever is
// cut: intact and broken bonds, contacts, smooth joints, springs, bars. A particle on the cut belongs to A by
// one half, so that a lattice whose row lies on the cut has the forces of its mirror image.
//
// With e the unit vector of the cut from the inner to the outer side at rest, t its left normal, and O the
// middle of the cut as it has moved with the particles beside it (median of the displacements of the
// particles whose bonds it cuts, so that a loose grain counts nothing):
//   thrust  N = -F.t       positive in tension,
//   shear   Q =  F.e       positive where it pushes A outwards,
//   moment  M = -M_O       positive where it stretches the outer side.
// A grain that came off beside the cut and strikes another one metres away pushes no part of the lining on
// the other: forces that act farther from O than the cut is long do not count. Forces are those without
// energy weight: within an overlap they are what the whole lining bears, of which the particles carry a
// share.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dem_server/packing/discs.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/geometry/shape.hpp"
#include "protocol/sections/strength.hpp"

namespace adit::dem {

// The force between two particles, wherever it comes from.
// What a pair does to its first particle; to the second it does the opposite at the same place. No energy
// weight, no dashpots.
struct PairForce {
  std::uint32_t first, second;
  double x, y, fx, fy, moment;  // place [m], force [N], moment of the bond beside it [N m]
};

struct SectionForces {
  double thrust, moment, shear;  // [N], [N m], [N]
};

struct Cut {
  std::string name;
  geometry::Point from, to;  // inner and outer side, at rest [m]
  std::shared_ptr<const sections::Strength> strength = nullptr;
};

class Sections {
 public:
  Sections() = default;
  // `bonds`: all pairs that are or were bonded, by the numbers that `cut_bonds` returns.
  Sections(std::vector<Cut> cuts, const Particles& particles, std::span<const Pair> bonds);

  std::span<const Cut> cuts() const { return cuts_; }
  // Bonds that cross a cut, ascending: no other one matters.
  std::span<const std::uint32_t> cut_bonds() const { return cut_bonds_; }

  // Particles of the bonds that a cut crosses, ascending.
  std::span<const std::uint32_t> beside(std::size_t cut) const { return beside_[cut]; }
  geometry::Point middle(std::size_t cut) const;  // at rest
  geometry::Point middle_now(std::size_t cut, const Particles& particles) const;
  geometry::Point displacement(std::size_t cut, const Particles& particles) const;  // since time began

  // Of each cut, by the forces of the cut bonds and of all else that acts between particles.
  std::vector<SectionForces> forces(const Particles& particles, std::span<const PairForce> pairs) const;

 private:
  SectionForces resultant(std::size_t cut, const Particles& particles,
                          std::span<const PairForce> pairs) const;
  std::vector<Cut> cuts_;
  std::vector<std::vector<std::uint32_t>> beside_;
  std::vector<std::uint32_t> cut_bonds_;
};

}  // namespace adit::dem
