// A dowel from point to point at one place, such as from one ring of segments to the next: it resists that
// they move apart, alike in every direction of the plane, and yields.
//
// With d the motion of a step and F' = F(n) + k d,
//   F(n+1) = F' min(1, F_y/|F'|),
// what it takes up is d . (F(n) + F(n+1))/2, of which (|F(n+1)|^2 - |F(n)|^2)/2k is stored. The rest,
// (F' - F(n+1)) . (F(n) + F(n+1))/2k, is dissipated; it is not negative, since F' - F(n+1) is along F(n+1)
// and |F(n)| <= |F(n+1)| = F_y there.
//
// It has no mass: in time it moves by mean acceleration (mean_acceleration.hpp), as contacts do.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "fdm_server/structures/strain_form.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class Dowel {
 public:
  // Stiffness k > 0 [N/m], largest force F_y > 0 [N].
  Dowel(std::array<std::uint32_t, 2> points, double stiffness, double yield)
      : points_(points), stiffness_(stiffness), yield_(yield) {}

  const std::array<std::uint32_t, 2>& points() const { return points_; }
  // At either point, that for which a step [s] is the critical one: omega^2 = 2k/m = 4/dt^2.
  double end_mass(double step) const { return stiffness_ * step * step / 2; }
  std::array<StrainForm, 2> strains() const;  // along x and y

  // As a beam's; returns what it dissipates [J].
  double add_forces(double dt, const PointView& points);

  double force() const { return std::hypot(force_[0], force_[1]); }     // [N]
  double offset() const { return std::hypot(offset_[0], offset_[1]); }  // of the points, since installed [m]
  double strain_energy() const { return force() * force() / stiffness_ / 2; }

  void exchange(state::Archive& archive) {
    archive("dowel_force", std::span(force_));
    archive("dowel_offset", std::span(offset_));
  }

 private:
  std::array<std::uint32_t, 2> points_;
  double stiffness_, yield_;
  std::array<double, 2> force_{}, offset_{};  // of the second point against the first
};

}  // namespace adit::fdm
