// A section of fibres over time: layers of concrete and of bars, each with its law and what it remembers.
//
// The elastic section has the slopes of the laws at the origin (steel replaces concrete): its axial and
// bending stiffness about its own centroid. No tangent of the section exceeds them.
//
// Bars let cracked concrete carry tension where their bond reaches: up to 2.5 times their distance from the
// nearer face, the effective area of EN 1992-1-1:2004, 7.3.2 (3). Elsewhere a crack opens by itself, in a
// length as large as the thickness, and bears nothing beyond 0.1 mm, about 2 G_F/f_t (fib Model Code
// 2010, 5.1.5.2): a thick wall with few bars would else bear its cracking moment until they yield.
#pragma once

#include <cstddef>
#include <vector>

#include "fdm_server/sections/concrete_law.hpp"
#include "fdm_server/sections/section_shape.hpp"
#include "protocol/materials/steel_law.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

using protocol::SteelLaw;
using protocol::SteelState;

// What all sections of a lining share.
class FibreSection {
 public:
  FibreSection(const SectionShape& shape, const ConcreteLaw& concrete, const SteelLaw& steel,
               std::size_t layers = 40);

  const SectionShape& shape() const { return shape_; }
  const ConcreteLaw& concrete(std::size_t layer) const { return near_bars_[layer] ? concrete_ : plain_; }
  const SteelLaw& steel() const { return steel_; }
  const std::vector<ConcreteLayer>& layers() const { return layers_; }
  double centroid() const { return centroid_; }  // z [m]
  double axial() const { return axial_; }        // E A [N]
  double bending() const { return bending_; }    // E I about the centroid [N m^2]

 private:
  SectionShape shape_;
  ConcreteLaw concrete_, plain_;
  std::vector<bool> near_bars_;  // each layer
  SteelLaw steel_;
  std::vector<ConcreteLayer> layers_;
  double centroid_, axial_, bending_;
};

// The fibres of one section.
class FibreStates {
 public:
  explicit FibreStates(const FibreSection& section);

  // Takes the fibres to eps(z) = strain + curvature z.
  SectionForces strain_to(const FibreSection& section, double strain, double curvature);
  double stored(const FibreSection& section) const;  // [J/m]
  // Of the bars: the largest by size, with its sign.
  double steel_strain(const FibreSection& section) const;
  double strain() const { return strain_; }
  double curvature() const { return curvature_; }

  void exchange(state::Archive& archive);

 private:
  double strain_ = 0, curvature_ = 0;
  std::vector<ConcreteState> concrete_;
  std::vector<SteelState> steel_;
};

}  // namespace adit::fdm
