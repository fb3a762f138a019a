// PM4Sand (materials/pm4sand.hpp) for zones, whose stress is the effective one.
//
// The law is followed once a zone, by the mean strain and stress over its area; each of the four points by
// itself would cost four times as much. What the strain of a point differs from the mean adds a stress by
// half of G at the beginning of time. This part of the stress, which keeps zones from hourglassing, is at
// most sin(phi_cv) p, so that it goes where the ground liquefies. Its stiffness is constant: one that
// followed that of the mean would give back more in one phase of a cycle than it took up in another, and so
// drive the pattern on. szz, of which the law knows nothing, keeps its ratio to the in-plane mean.
//
// Until time begins the ground is elastic within Mohr-Coulomb's strength with phi_cv and without cohesion. A
// zone takes up its state from the stress of its first step in time.
//
// In large strain what the law remembers turns with the ground, but the report's apparent alpha_in, which is
// told by components, belongs to horizontal and vertical axes.
//
// Energy: the zone stores 2/3 p^2/(K + G/3) + s.s/(2 G) of all points, with the present moduli. What else the
// work (s(n) + s(n+1))/2 : de holds is booked as dissipated. As the moduli follow the pressure and the
// fabric, elasticity by itself is not conservative, and the dissipated energy may fall for a while. The
// moduli that count are those without F_sed: nothing changes in the moment when the shaking is over, and the
// work of what sand is compressed more as it reconsolidates is dissipated.
#pragma once

#include <cstddef>
#include <optional>

#include "fdm_server/materials/pm4sand.hpp"
#include "fdm_server/zones/batch/zone_fields.hpp"
#include "fdm_server/zones/laws/plastic_law.hpp"
#include "fdm_server/zones/laws/zone_law.hpp"

namespace adit::fdm {

class Pm4SandLaw final : public ZoneLaw {
 public:
  // `statics`: elastic constants until time begins.
  Pm4SandLaw(const Elasticity& statics, const Pm4Sand& sand, std::size_t zones);

  void advance(const LawStep& step) override;
  void prefetch(std::size_t first) const override {
    if (!statics_) memory_.read_ahead(first);
  }
  void turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) override;
  void begin_time() override { statics_.reset(); }
  void set_time(double time) override { reconsolidates_ = time >= sand_.reconsolidation_from; }
  void exchange(state::Archive& archive) override;
  void find_energies(std::size_t first, std::uint32_t count, const PointValues& areas,
                     const ConstStressView& stresses, BatchValues& energies) const override;
  double plastic_shear_strain(std::size_t zone, std::size_t point) const override {
    return statics_ ? statics_->plastic_shear_strain(zone, point) : 0;
  }
  unsigned yields(std::size_t zone, std::size_t point) const override {
    return statics_ ? statics_->yields(zone, point) : unsigned{kHysteretic};
  }
  double demand(std::size_t zone, std::size_t point, const PointStress& stress) const override {
    return statics_ ? statics_->demand(zone, point, stress) : 0;
  }

 private:
  static constexpr std::size_t kModulus = offsetof(Pm4SandState, shear_modulus) / sizeof(double);
  bool has_begun(std::size_t zone) const { return memory_.at(kModulus, zone) > 0; }
  // From the mean stress, which goes to where the law holds.
  void take_up(std::size_t zone, Pm4SandStress& stress);

  Pm4Sand sand_;
  bool reconsolidates_ = false;                              // in the step that comes
  std::optional<PlasticLaw> statics_;                        // until time begins
  static constexpr std::size_t kStiffness = kPm4SandFields;  // of what points differ from the mean [Pa]
  ZoneFields<kPm4SandFields + 1> memory_;
};

}  // namespace adit::fdm
