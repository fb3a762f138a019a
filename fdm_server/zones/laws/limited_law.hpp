// A hysteretic law within a strength: Mohr-Coulomb, a weak plane or both.
//
// Both act in series. The elements follow the strain less the plastic strain, and the strength bounds their
// stress. A step strains the elements by all of its strain, returns the stress to the strength, and takes the
// plastic strain out of the elements again:
//   s* = s(n) + chain(de),   s(n+1) = strength(s*),   de_p = C^-1 (s* - s(n+1)),   chain(-de_p),
// C being the elastic constants at small strains. Elements that turn back are elastic, so that the chain ends
// with s(n+1), but for elements that older loops have left at their limit on the other side, which the next
// steps return. An element that flowed in s* and went back flows again in the next step by as much less:
// where the strength holds, all of the strain is plastic after a few steps, and unloading begins with C.
//
// Energy: the chain books what its elements take on both ways, of (s(n) + s*)/2 : de and -(s* + s(n+1))/2 :
// de_p. What is left of (s(n) + s(n+1))/2 : de, with the s(n+1) of the chain, is
//   (s(n+1) - s*)/2 : de + (s* + s(n+1))/2 : de_p.
#pragma once

#include <memory>

#include "fdm_server/zones/laws/plastic_law.hpp"
#include "fdm_server/zones/laws/zone_law.hpp"

namespace adit::fdm {

class LimitedLaw final : public ZoneLaw {
 public:
  // `chain`: a law whose stress turns back with the elastic constants.
  LimitedLaw(std::unique_ptr<ZoneLaw> chain, const Material& material, std::size_t zones, bool large_strain,
             std::span<const double> strengths = {})
      : ZoneLaw(material.elasticity()),
        chain_(std::move(chain)),
        strength_(material, zones, large_strain, strengths) {}

  void advance(const LawStep& step) override;
  void prefetch(std::size_t first) const override { chain_->prefetch(first); }
  void turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) override {
    chain_->turn(first, count, turns);
    strength_.turn(first, count, turns);
  }
  void set_stress(std::size_t zone, std::size_t point, const PointStress& stress) override {
    chain_->set_stress(zone, point, stress);
  }
  void exchange(state::Archive& archive) override {
    chain_->exchange(archive);
    strength_.exchange(archive);
  }
  void find_energies(std::size_t first, std::uint32_t count, const PointValues& areas,
                     const ConstStressView& stresses, BatchValues& energies) const override {
    chain_->find_energies(first, count, areas, stresses, energies);
  }
  double plastic_shear_strain(std::size_t zone, std::size_t point) const override {
    return strength_.plastic_shear_strain(zone, point);
  }
  unsigned yields(std::size_t zone, std::size_t point) const override {
    return strength_.yields(zone, point);
  }
  double demand(std::size_t zone, std::size_t point, const PointStress& stress) const override {
    return strength_.demand(zone, point, stress);
  }

 private:
  std::unique_ptr<ZoneLaw> chain_;
  PlasticLaw strength_;
};

}  // namespace adit::fdm
