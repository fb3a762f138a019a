// A section of fibres over time: layers of concrete and of bars, each with its law and what it remembers.
//
// The elastic section has the slopes of the laws at the origin (steel replaces concrete): its axial and
// bending stiffness about its own centroid. No tangent of the section exceeds them.
//
// Bars let cracked concrete carry tension where their bond reaches, in the effective area of EN
// 1992-1-1:2004, 7.3.2 (3): from the nearer face up to h_c,eff = min(2.5 (h - d), (h - x)/3, h/2), with x of
// the cracked section, b x^2/2 = n A_s (d - x), n = E_s/E_c. Elsewhere a crack opens by itself, in a length
// as large as the thickness, and bears nothing beyond 0.1 mm, about 2 G_F/f_t (fib Model Code 2010, 5.1.5.2):
// a thick wall with few bars would else bear its cracking moment until they yield.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "protocol/materials/steel_law.hpp"
#include "protocol/sections/concrete_law.hpp"
#include "protocol/sections/section_shape.hpp"
#include "protocol/state/archive.hpp"

namespace adit::sections {

using protocol::SteelLaw;
using protocol::SteelState;

// What stirrups confine: its law, its height in the middle of the section [m], its share of the width.
struct ConfinedCore {
  ConcreteLaw law;
  double height, share;
};

// What all sections of a lining share.
class FibreSection {
 public:
  // `layers`: of concrete; those through the core are two, where it is narrower than the section.
  FibreSection(const SectionShape& shape, const ConcreteLaw& concrete, const SteelLaw& steel,
               const std::optional<ConfinedCore>& core = {}, std::size_t layers = 40);

  const SectionShape& shape() const { return shape_; }
  const ConcreteLaw& concrete(std::size_t layer) const { return laws_[law_of_[layer]]; }
  // Whether the concrete that bears longest is crushed.
  bool crushed(double strain, double curvature) const;
  const SteelLaw& steel() const { return steel_; }
  const std::vector<ConcreteLayer>& layers() const { return layers_; }
  double centroid() const { return centroid_; }  // z [m]
  double axial() const { return axial_; }        // E A [N]
  double bending() const { return bending_; }    // E I about the centroid [N m^2]

 private:
  SectionShape shape_;
  SteelLaw steel_;
  std::optional<ConfinedCore> core_;
  std::array<ConcreteLaw, 4> laws_;  // away from bars and near them; both in the core
  std::vector<ConcreteLayer> layers_;
  std::vector<std::size_t> law_of_;  // each layer
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

}  // namespace adit::sections
