// What a section resists in thrust and moment: EN 1992-1-1:2004, 6.1, by the strain limits of its figure 6.1.
//
// Concrete follows the parabola-rectangle diagram and has no tension but that of its fibres; steel yields
// without hardening (3.2.7 (2) b). The strains of a section at its limit pass through one of three pivots:
//   A  the bars farthest from the compressed face have the limit strain eps_ud;
//   B  the compressed face has eps_cu2;
//   C  at the depth (1 - eps_c2/eps_cu2) h from it the strain is eps_c2, all of the section being compressed.
// GB 50010-2010, 6.2.1 and 6.2.17, has the same pivots with its own strains.
// Without bars, pivot A is the tensioned face at the end strain of the fibres.
#pragma once

#include <array>
#include <vector>

#include "protocol/sections/concrete_law.hpp"
#include "protocol/sections/parabola_rectangle.hpp"
#include "protocol/sections/section_shape.hpp"

namespace adit::sections {

struct CapacityMaterials {
  ParabolaRectangle concrete;
  double steel_modulus, steel_yield, steel_limit;  // E_s, f_y [Pa], eps_ud
  ResidualTension residual{};                      // of fibres
};

enum class Bending { kOuterStretched, kInnerStretched };  // moment positive, negative

class Capacity {
 public:
  Capacity(const SectionShape& shape, const CapacityMaterials& materials);

  // Of the strains eps(z) = strain + curvature z.
  SectionForces forces(double strain, double curvature) const;
  // The limit states from pure tension (0) by pivots A (to 1), B (to 2) and C to pure compression (3).
  SectionForces limit(Bending bending, double pivot) const;

  double largest_thrust() const { return limit(Bending::kOuterStretched, 0).thrust; }
  double least_thrust() const { return limit(Bending::kOuterStretched, 3).thrust; }
  // The ultimate moment, with its sign, at this thrust; that of the nearest thrust where it lies beyond.
  double moment(Bending bending, double thrust) const;
  // At a thrust and a curvature below those of the limit.
  double moment_at_curvature(double thrust, double curvature) const;

  // The limit states in order around the origin: moment over thrust.
  const std::vector<SectionForces>& diagram() const { return diagram_; }
  // By how much thrust and moment together exceed the capacity: their distance from the origin over that of
  // the diagram in their direction; 1: they lie on it.
  double utilisation(const SectionForces& forces) const;

 private:
  double direction(const SectionForces& forces) const;

  SectionShape shape_;
  CapacityMaterials materials_;
  std::vector<ConcreteLayer> layers_;
  // Limit states from pure tension to pure compression, by Bending: so many that the moment between two of
  // them is linear in the thrust to 1e-5 of the largest.
  std::array<std::vector<SectionForces>, 2> limits_;
  std::vector<SectionForces> diagram_;
  std::vector<double> directions_;  // of the diagram's points, ascending [rad]
  double thrust_scale_ = 1, moment_scale_ = 1;
};

}  // namespace adit::sections
