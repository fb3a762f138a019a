#include "dem_server/particles/prescribed_motions.hpp"

#include <algorithm>

namespace adit::dem {
namespace {

// What a motion of this component moves: the sum of the particles' masses or moments of inertia.
double inertia_of(const std::vector<std::uint32_t>& chosen, Component component, const Particles& particles) {
  const auto& each = component == Component::kSpin ? particles.inertia : particles.mass;
  double sum = 0;
  for (const std::uint32_t i : chosen) sum += each[i];
  return sum;
}

}  // namespace

PrescribedMotions::PrescribedMotions(const Model& model, const Particles& particles) {
  for (auto& flags : prescribed_) flags.assign(particles.size(), false);
  for (const PrescribedMotion& motion : model.motions) {
    std::vector<std::uint32_t> discs = motion.discs;
    std::erase_if(discs, [&](std::uint32_t i) { return !particles.is_there(i); });
    for (const std::uint32_t i : discs) prescribed_[static_cast<std::size_t>(motion.component)][i] = true;
    const double inertia = inertia_of(discs, motion.component, particles);
    motions_.push_back({motion.component, std::move(discs), motion.amplitude, motion.time, inertia});
  }
}

PrescribedMotions PrescribedMotions::take(const std::vector<bool>& chosen, const Particles& particles) {
  PrescribedMotions taken;
  taken.prescribed_ = prescribed_;
  for (Motion& motion : motions_) {
    std::vector<std::uint32_t> out, left;
    for (const std::uint32_t i : motion.particles) (chosen[i] ? out : left).push_back(i);
    if (!out.empty())
      taken.motions_.push_back({motion.component, out, motion.amplitude, motion.time,
                                inertia_of(out, motion.component, particles)});
    motion.inertia = inertia_of(left, motion.component, particles);
    motion.particles = std::move(left);
  }
  std::erase_if(motions_, [](const Motion& motion) { return motion.particles.empty(); });
  return taken;
}

void PrescribedMotions::mark(std::vector<bool>& flags) const {
  for (const Motion& motion : motions_)
    for (const std::uint32_t i : motion.particles) flags[i] = true;
}

void PrescribedMotions::impose(const protocol::Step& step, Particles& p) {
  std::vector<double>* const velocities[] = {&p.vx, &p.vy, &p.spin};
  const std::vector<double>* const resultants[] = {&p.fx, &p.fy, &p.moment};
  for (Motion& motion : motions_) {
    const auto component = static_cast<std::size_t>(motion.component);
    const double velocity = step.relax ? 0 : motion.amplitude * motion.time(step.half_time());
    motion.before = step.from_rest() ? -velocity : motion.after;
    motion.after = velocity;
    double reaction = motion.inertia * (velocity - (step.from_rest() ? 0 : motion.before)) / step.dt;
    for (const std::uint32_t i : motion.particles) {
      reaction -= (*resultants[component])[i];
      (*velocities[component])[i] = velocity;
    }
    if (!step.from_rest()) work_ += step.dt * motion.before * (motion.reaction + reaction) / 2;
    motion.reaction = reaction;
  }
  last_dt_ = step.dt;
  last_kick_ = step.kick();
}

double PrescribedMotions::kinetic_energy() const {
  double twice = 0;
  for (const Motion& motion : motions_) twice += motion.inertia * motion.after * motion.after;
  return twice / 2;
}

void PrescribedMotions::hold(Component component, std::uint32_t particle, double impulse) {
  for (Motion& motion : motions_) {
    if (motion.component != component || !std::ranges::binary_search(motion.particles, particle)) continue;
    const double force = impulse / last_kick_;
    motion.reaction -= force;
    work_ -= last_dt_ * motion.before * force / 2;
  }
}

}  // namespace adit::dem
