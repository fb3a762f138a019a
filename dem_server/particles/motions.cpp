#include "dem_server/particles/motions.hpp"

#include <algorithm>
#include <string>

#include "dem_server/particles/selection.hpp"
#include "protocol/errors.hpp"
#include "protocol/participant/time_function.hpp"

namespace adit::dem {
namespace {

// What a motion of this component moves: the sum of the particles' masses or moments of inertia.
double inertia_of(const std::vector<std::uint32_t>& chosen, Motions::Component component,
                  const Particles& particles) {
  const auto& each = component == Motions::kSpin ? particles.inertia : particles.mass;
  double sum = 0;
  for (const std::uint32_t i : chosen) sum += each[i];
  return sum;
}

}  // namespace

Motions::Motions(const scene::Particles& scene, const Particles& particles, double tolerance) {
  for (auto& flags : prescribed_) flags.assign(particles.size(), false);
  for (int i = 0; i < scene.motions_size(); ++i) {
    const auto& motion = scene.motions(i);
    const std::string path = "particles.motions[" + std::to_string(i) + "]";
    protocol::check(motion.time(), path + ".time");
    const auto& velocity = motion.velocity();
    if (!velocity.has_x() && !velocity.has_y() && !motion.has_spin())
      throw protocol::UserError(path,
                                "prescribes nothing; give velocity.x, velocity.y or spin, or remove it");
    const auto chosen = select(motion.where(), particles, tolerance, path + ".where");
    if (velocity.has_x()) add(kX, chosen, velocity.x(), motion.time(), path, particles);
    if (velocity.has_y()) add(kY, chosen, velocity.y(), motion.time(), path, particles);
    if (motion.has_spin()) add(kSpin, chosen, motion.spin(), motion.time(), path, particles);
  }
}

void Motions::add(Component component, const std::vector<std::uint32_t>& chosen, double amplitude,
                  const scene::TimeFunction& time, const std::string& path, const Particles& particles) {
  static constexpr const char* kNames[] = {"velocity.x", "velocity.y", "spin"};
  for (const std::uint32_t i : chosen) {
    if (prescribed_[component][i])
      throw protocol::UserError(path + ".where", "selects particles whose " + std::string(kNames[component]) +
                                                     " an earlier motion prescribes; separate the boxes");
    prescribed_[component][i] = true;
  }
  motions_.push_back({component, chosen, amplitude, time, inertia_of(chosen, component, particles)});
}

Motions Motions::take(const std::vector<bool>& chosen, const Particles& particles) {
  Motions taken;
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

void Motions::mark(std::vector<bool>& flags) const {
  for (const Motion& motion : motions_)
    for (const std::uint32_t i : motion.particles) flags[i] = true;
}

void Motions::impose(const protocol::Step& step, Particles& p) {
  std::vector<double>* const velocities[] = {&p.vx, &p.vy, &p.spin};
  const std::vector<double>* const resultants[] = {&p.fx, &p.fy, &p.moment};
  for (Motion& motion : motions_) {
    const double velocity =
        step.relax ? 0 : motion.amplitude * protocol::evaluate(motion.time, step.half_time());
    motion.before = step.from_rest() ? -velocity : motion.after;
    motion.after = velocity;
    double reaction = motion.inertia * (velocity - motion.before) / step.dt;
    for (const std::uint32_t i : motion.particles) {
      reaction -= (*resultants[motion.component])[i];
      (*velocities[motion.component])[i] = velocity;
    }
    if (!step.from_rest()) work_ += step.dt * motion.before * (motion.reaction + reaction) / 2;
    motion.reaction = reaction;
  }
  last_dt_ = step.dt;
  last_kick_ = step.kick();
}

void Motions::hold(Component component, std::uint32_t particle, double impulse) {
  for (Motion& motion : motions_) {
    if (motion.component != component || !std::ranges::binary_search(motion.particles, particle)) continue;
    const double force = impulse / last_kick_;
    motion.reaction -= force;
    work_ -= last_dt_ * motion.before * force / 2;
  }
}

}  // namespace adit::dem
