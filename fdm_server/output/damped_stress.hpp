// The stress that acts in zones whose ground is damped by Maxwell's elements (damped_value.hpp). Only zones
// that are asked for are followed, from step to step.
#pragma once

#include <cstdint>
#include <vector>

#include "fdm_server/materials/damping_law.hpp"
#include "fdm_server/output/damped_value.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class DampedStress {
 public:
  // `zones`: numbers of zones of the grid, ascending.
  DampedStress(const DampingLaw& law, std::vector<std::uint32_t> zones);

  // After every step, once the zones have their stress of it.
  void follow(const ZoneSet& zones, const protocol::Step& step);
  // In the plane, of one of these zones [Pa].
  Stress of(const ZoneSet& zones, std::uint32_t zone) const;

  void exchange(state::Archive& archive);

 private:
  struct Followed {
    DampedValue xx{}, yy{}, xy{};
  };

  DampingLaw law_;
  std::vector<std::uint32_t> zones_;
  std::vector<Followed> followed_;  // one a zone; none without elements
};

}  // namespace adit::fdm
