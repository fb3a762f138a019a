// The stress that acts in zones whose ground is damped by Maxwell's elements. Only zones
// that are asked for are followed, from step to step.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "fdm_server/materials/damping_law.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

// What Maxwell's elements add to a quantity that is linear in the forces of zones, such as a stress or the
// resultant in a section (Rayleigh's stiffness part is one element).
//
// An element adds to the forces of the zones on their points (damping_law.hpp)
//   g(n) = a g(n-1) + (1 - a) s tau (f(n) - f(n-1))/dt,
// so that the same recursion with the quantity in place of f gives what it adds to the quantity. Equilibrium
// holds with both: the shear stress at a depth is the inertia of the ground above.
struct DampedValue {
  double before = 0;    // of the zones, a step before
  Elements elements{};  // that they add

  // After every step of time.
  void follow(const MaxwellStep& step, double now) {
    const double growth = now - std::exchange(before, now);
    for (std::size_t e = 0; e < kMostElements; ++e) elements[e] = step(e, elements[e], growth);
  }
  double added() const { return std::accumulate(elements.begin(), elements.end(), 0.0); }
};

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
