#include "dem_server/motions.hpp"

#include <string>

#include "dem_server/selection.hpp"
#include "protocol/errors.hpp"
#include "protocol/time_function.hpp"

namespace adit::dem {

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
  const auto& masses = component == kSpin ? particles.inertia : particles.mass;
  double inertia = 0;
  for (const std::uint32_t i : chosen) {
    if (prescribed_[component][i])
      throw protocol::UserError(path + ".where", "selects particles whose " + std::string(kNames[component]) +
                                                     " an earlier motion prescribes; separate the boxes");
    prescribed_[component][i] = true;
    inertia += masses[i];
  }
  motions_.push_back({component, chosen, amplitude, time, inertia});
}

void Motions::impose(double half_time, double dt, bool start, Particles& p) {
  std::vector<double>* const velocities[] = {&p.vx, &p.vy, &p.spin};
  const std::vector<double>* const resultants[] = {&p.fx, &p.fy, &p.moment};
  for (Motion& motion : motions_) {
    const double velocity = motion.amplitude * protocol::evaluate(motion.time, half_time);
    const double before = start ? -velocity : motion.velocity;
    double reaction = motion.inertia * (velocity - before) / dt;
    for (const std::uint32_t i : motion.particles) {
      reaction -= (*resultants[motion.component])[i];
      (*velocities[motion.component])[i] = velocity;
    }
    if (!start) work_ += dt * before * (motion.reaction + reaction) / 2;
    motion.velocity = velocity;
    motion.reaction = reaction;
  }
}

}  // namespace adit::dem
