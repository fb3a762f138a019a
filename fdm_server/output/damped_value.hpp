// What Maxwell's elements add to a quantity that is linear in the forces of zones, such as a stress or the
// resultant in a section (Rayleigh's stiffness part is one element).
//
// An element adds to the forces of the zones on their points (damping_law.hpp)
//   g(n) = a g(n-1) + (1 - a) s tau (f(n) - f(n-1))/dt,
// so that the same recursion with the quantity in place of f gives what it adds to the quantity. Equilibrium
// holds with both: the shear stress at a depth is the inertia of the ground above.
#pragma once

#include <numeric>
#include <utility>

#include "fdm_server/materials/damping_law.hpp"

namespace adit::fdm {

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

}  // namespace adit::fdm
