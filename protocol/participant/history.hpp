// What participants and the coupler share of histories: their names, and the velocity that a record needs.
#pragma once

#include <string>

#include "protocol/messages/scene.pb.h"
#include "protocol/participant/step.hpp"

namespace adit::protocol {

// The history's column in histories.csv: its name and the column of its quantity, `crown_ux_m`.
std::string column_of(const scene::History& history);

// The quantity as a scene writes it: "displacement_x".
std::string name_of(scene::Quantity quantity);

// Whether it is a displacement, velocity or acceleration.
bool is_motion(scene::Quantity quantity);

// UserError at `path`, the history's, for a `relative_to` beside anything but a motion.
void require_relative_motion(const scene::History& history, const std::string& path);

// UserError below `path`, the history's, where it asks for the use of a section whose strength is not stated.
// `section`: its path in the scene.
void require_strength(const scene::History& history, bool stated, const std::string& section,
                      const std::string& path);

// One velocity component at half steps, as histories need it at step n: v(n-1/2), which is final, and
//   a(n) = (v(n+1/2) - v(n-1/2)) / dt,
// or a(n-1) where v(n+1/2) still awaits the correction by another model. From rest, v(1/2) came of half a
// kick.
class HalfStepVelocity {
 public:
  // Before every step, after the correction of the step before.
  void remember(double v) {
    older_ = before_;
    before_ = v;
  }
  // After the step, which predicted the velocity `after`.
  double acceleration(double after, const Step& step, bool awaits_correction) const {
    if (step.from_rest()) return after / step.kick();
    if (!awaits_correction) return (after - before_) / step.dt;
    return (before_ - older_) / (step.number == 1 ? step.dt / 2 : step.dt);
  }
  double before() const { return before_; }

 private:
  double older_ = 0, before_ = 0;
};

}  // namespace adit::protocol
