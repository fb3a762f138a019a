// The stress that acts in zones whose ground is damped by Maxwell's elements (Rayleigh's stiffness part is
// one).
//
// An element adds to the forces of the zones on their points (damping_law.hpp)
//   g(n) = a g(n-1) + (1 - a) s tau (f(n) - f(n-1))/dt.
// Forces are linear in the stress of zones, so that the same recursion with the stress sigma in place of f
// gives the stress that the element adds. Equilibrium holds with both: the shear stress at a depth is the
// inertia of the ground above. Only zones that are asked for are followed, from step to step.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fdm_server/materials/damping_law.hpp"
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
    Stress before{};                               // of the zone, a step before
    std::array<Stress, kMostElements> elements{};  // that they add
  };

  DampingLaw law_;
  std::vector<std::uint32_t> zones_;
  std::vector<Followed> followed_;  // one a zone; none without elements
};

}  // namespace adit::fdm
