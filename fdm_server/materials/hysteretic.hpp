// Strain-dependent shear modulus with hysteretic damping: Iwan's parallel elements (Iwan 1967, J. Appl. Mech.
// 34).
//
// The stress deviator is the sum of N elastic, perfectly plastic elements (von Mises) that all have the
// strain of the ground. Element i has the shear modulus G_i and yields at the shear strain x_i. In simple
// shear the sum is the polyline backbone of slopes H_k = sum over i > k of G_i; unloading and reloading from
// any reversal follow that backbone doubled, and meet earlier branches as Masing's extended rules say,
// because each element must be driven back twice its yield strain: the rules are a consequence, for every
// strain path in the plane and across it. Each element dissipates, hence so does the sum. The volume changes
// elastically.
//
// Elements are kept as what they flowed: q_i, so that element i has the stress G_i (e - q_i), e the deviator
// of strain since the start. Only elements that yield change. Their distance from yielding, x_i - |e - q_i|,
// shrinks by no more than the length of the strain path: a block of eight elements sleeps until the path
// could bring one of them to its limit, and a step without any awake adds G de to the stress.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fdm_server/hysteresis/modulus_reduction.hpp"
#include "fdm_server/materials/solid.hpp"

namespace adit::fdm {

class Hysteretic {
 public:
  explicit Hysteretic(std::vector<BackbonePoint> backbone);

  // Shear stress over the initial modulus in first loading.
  double stress(double shear_strain) const;
  // Damping ratio of Masing's closed loops between -strain and +strain: dissipated energy over 4 pi times the
  // elastic energy of the secant, with A the area under the backbone, 2/pi (2 A/(tau strain) - 1).
  double damping_ratio(double shear_strain) const;
  std::span<const BackbonePoint> backbone() const { return backbone_; }
  // Of each element: stiffness over the initial modulus, yield strain.
  struct Chain {
    std::span<const double> stiffness, limit;
  };
  Chain chain() const {
    return {std::span(stiffness_).first(backbone_.size()), std::span(limit_).first(backbone_.size())};
  }

  // State of one point: a head, which every step takes, and the elements, in blocks that sleep mostly.
  static constexpr std::size_t kHead = 8;
  std::size_t values() const { return kHead + elements(); }
  std::size_t elements() const { return 25 * blocks() + 3; }  // values of the elements
  struct State {
    std::span<double> head, elements;
  };
  State split(std::span<double> state) const { return {state.first(kHead), state.subspan(kHead)}; }
  void set_stress(const State& state, const SolidStress& stress) const;
  void set_stress(std::span<double> state, const SolidStress& stress) const {
    set_stress(split(state), stress);
  }
  struct Increment {
    double volume, difference, shear;  // of strain: xx + yy, xx - yy, xy
  };
  // The sum of the elements' deviators and of the initial one, which has no mean; the energy per volume that
  // the elements dissipated, >= 0.
  struct Chained {
    double difference, shear, across, dissipated;  // (xx - yy)/2, xy, zz
  };
  Chained add(const Elasticity& elasticity, const Increment& strain, const State& state) const;
  // The same for a whole stress; returns the energy.
  double add(const Elasticity& elasticity, const Strain& strain, std::span<double> state,
             SolidStress& stress) const;
  // Energy per volume; that of the initial stress over the strains since included.
  double energy(const Elasticity& elasticity, std::span<const double> head, std::span<const double> elements,
                const SolidStress& stress) const;
  double energy(const Elasticity& elasticity, std::span<const double> state,
                const SolidStress& stress) const {
    return energy(elasticity, state.first(kHead), state.subspan(kHead), stress);
  }

 private:
  std::size_t blocks() const { return stiffness_.size() / 8; }

  std::vector<BackbonePoint> backbone_;
  // Of each element: stiffness over the initial modulus, yield strain. Elements of no stiffness that never
  // yield fill the last block.
  std::vector<double> stiffness_, limit_;
};

}  // namespace adit::fdm
