// Springs between two discs, such as bolts, gaskets and keys. One whose force exceeds its strength is gone.
//
// A spring along its own line acts on the centres; its opening is e = L - L0. One of a fixed direction d acts
// where the discs meet, like a smooth joint (joints.hpp): its opening is the sum over the steps of dt r.d,
// with
//   r = (v2 - v1) - (arm_1 w1 + arm_2 w2) t,    t the left normal of the line of centres,
// and its force turns the discs by its lever arms, so that angular momentum is kept.
//
// Force by opening: N = N0 + k e, where wanted at least 0; or a curve (protocol/springs/force_curve.hpp). The
// clearance is taken off e first, on either side.
#pragma once

#include <span>
#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class SpringForces {
 public:
  SpringForces() = default;
  explicit SpringForces(std::vector<Spring> springs);

  // Installs those of the stages after `before` up to `stage`, with their pretension, at their present
  // length; those whose discs were taken away are gone.
  void begin_stage(std::uint32_t before, std::uint32_t stage, const Particles& particles);

  // Adds their forces to the resultants; `dt` is 0 where the step starts from rest.
  void add_forces(double dt, Particles& particles);

  double strain_energy() const;
  double released() const { return released_; }  // stored in those that broke, since the start [J]
  void start_over() { released_ = 0; }
  std::span<const Spring> springs() const { return springs_; }
  std::span<const double> forces() const { return forces_; }      // [N]
  std::span<const double> openings() const { return openings_; }  // without clearance [m]
  // The straight piece of its law on which the spring is: another number for each.
  std::size_t piece(std::size_t spring) const;
  std::span<const std::uint32_t> broken() const { return broken_; }  // in the order in which they broke

  void exchange(state::Archive& archive) {
    archive("spring_forces", std::span(forces_));
    archive("spring_openings", std::span(openings_));
    archive("spring_installed_at", std::span(installed_at_));
    archive("springs_whole", whole_);
    archive("springs_broken", broken_);
    archive("springs_released", released_);
  }

 private:
  void pull_along_line(std::size_t spring, double dt, Particles& particles);
  void pull_in_direction(std::size_t spring, double dt, Particles& particles);
  // Takes the opening and finds the force; `stretch` is the opening's growth in this step [m]. Whether the
  // spring still is.
  bool holds(std::size_t spring, double opening, double stretch);

  std::vector<Spring> springs_;
  std::vector<double> forces_, openings_;
  std::vector<bool> whole_;           // installed, and not broken
  std::vector<double> installed_at_;  // elongation at which a spring along its line was installed [m]
  std::vector<std::uint32_t> broken_;
  double released_ = 0;
};

}  // namespace adit::dem
