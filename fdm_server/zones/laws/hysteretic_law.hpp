// The hysteretic law for zones: each point has a chain of elements of its own (hysteresis/iwan_elements.hpp),
// eight zones at a time (element_kernels.hpp). Of the stress the zones hold the deviator's sum; its part
// across the plane differs from point to point, so that the in-plane mean and szz of a zone are means over
// its area. In large strain the elements live in axes that turn with the ground: strain is turned into them,
// stress out of them.
#pragma once

#include <vector>

#include "fdm_server/zones/laws/element_kernels.hpp"
#include "fdm_server/zones/laws/hysteretic_axes.hpp"
#include "fdm_server/zones/laws/zone_law.hpp"

namespace adit::fdm {

class HystereticLaw final : public ZoneLaw {
 public:
  HystereticLaw(const Elasticity& elasticity, const IwanElements& chain, std::size_t zones,
                bool large_strain);

  void advance(const LawStep& step) override;
  void turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) override {
    axes_.turn(first, count, turns);
  }
  void exchange(state::Archive& archive) override;
  void find_energies(std::size_t first, std::uint32_t count, const PointValues& areas,
                     const ConstStressView& stresses, BatchValues& energies) const override;
  unsigned yields(std::size_t /*zone*/, std::size_t /*point*/) const override { return kHysteretic; }

 private:
  void advance_group(const LawStep& step, std::size_t from, std::size_t to);
  std::size_t elements() const { return stiffness_.size(); }
  GroupState group(std::size_t number) {
    return {&strains_[9 * number], &paths_[number], &wakes_[elements() / kElementBlock * number],
            &flows_[kElementValues * elements() * number]};
  }

  std::vector<double> stiffness_, limit_;  // of elements in whole blocks, the last of which may have none
  std::vector<GroupValues> strains_, paths_, wakes_, flows_;
  HystereticAxes axes_;
};

}  // namespace adit::fdm
