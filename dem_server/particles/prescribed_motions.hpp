// Prescribed velocities and spins of particles, and the work of the reactions that they need.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class PrescribedMotions {
 public:
  PrescribedMotions() = default;
  PrescribedMotions(const Model& model, const Particles& particles);

  // Takes the chosen particles out, before the first step.
  PrescribedMotions take(const std::vector<bool>& chosen, const Particles& particles);

  // Sets the flags of the particles with a prescribed component.
  void mark(std::vector<bool>& flags) const;

  // After the kick of step n: overwrites the prescribed velocities with those of n + 1/2 and adds
  // the reactions' work since n - 1 to work(). `particles` still holds the resultants at n. The reaction is
  // what the resultant lacks, R(n) = m (v(n+1/2) - v(n-1/2)) / dt - f(n), with v(-1/2) = 0 from rest, because
  // the particles come to their velocity at once; its work the trapezoid dt v(n-1/2) (R(n-1) + R(n)) / 2.
  void impose(const protocol::Step& step, Particles& particles);

  // An impulse [N s] on a prescribed component after step n: the reaction R(n), found without it, takes it
  // up.
  void hold(Component component, std::uint32_t particle, double impulse);

  double work() const { return work_; }  // [J]
  // Of the prescribed components, after the last step [J].
  double kinetic_energy() const;
  void start_over() { work_ = 0; }
  void exchange(state::Archive& archive) {
    for (Motion& motion : motions_) {
      archive("prescribed_before", motion.before);
      archive("prescribed_after", motion.after);
      archive("prescribed_reaction", motion.reaction);
    }
    archive("prescribed_motions_work", work_);
    archive("prescribed_motions_last_dt", last_dt_);
    archive("prescribed_motions_last_kick", last_kick_);
  }

  bool prescribes(Component component, std::uint32_t particle) const {
    return prescribed_[static_cast<std::size_t>(component)][particle];
  }

 private:
  // All its particles share the velocity.
  struct Motion {
    Component component;
    std::vector<std::uint32_t> particles;  // ascending
    double amplitude;
    TimeFactor time;
    double inertia;     // sum of the particles' masses or moments of inertia
    double before = 0;  // velocity half a step before the last step; from rest that of the mirrored half step
    double after = 0;   // and half a step after it
    double reaction = 0;  // sum at the last step
  };
  std::vector<Motion> motions_;
  std::array<std::vector<bool>, 3> prescribed_;
  double work_ = 0;
  double last_dt_ = 0, last_kick_ = 0;  // [s]
};

}  // namespace adit::dem
