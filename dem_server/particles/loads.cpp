#include "dem_server/particles/loads.hpp"

#include <string>

#include "dem_server/particles/selection.hpp"
#include "protocol/participant/time_function.hpp"

namespace adit::dem {

Loads::Loads(const scene::Particles& scene, const Particles& particles, double tolerance) {
  for (int i = 0; i < scene.loads_size(); ++i) {
    const auto& load = scene.loads(i);
    const std::string path = "particles.loads[" + std::to_string(i) + "]";
    protocol::check(load.time(), path + ".time");
    auto chosen = select(load.where(), particles, tolerance, path + ".where");
    std::vector<double> share(chosen.size(), 1.0 / static_cast<double>(chosen.size()));
    loads_.push_back({std::move(chosen), std::move(share), load.force().x(), load.force().y(), load.time()});
  }
  for (int i = 0; i < scene.body_loads_size(); ++i) {
    const auto& load = scene.body_loads(i);
    const std::string path = "particles.body_loads[" + std::to_string(i) + "]";
    protocol::check(load.time(), path + ".time");
    auto chosen = select(load.where(), particles, tolerance, path + ".where");
    std::vector<double> share;
    for (const std::uint32_t k : chosen) share.push_back(particles.mass[k]);
    loads_.push_back(
        {std::move(chosen), std::move(share), load.acceleration().x(), load.acceleration().y(), load.time()});
  }
}

Loads Loads::take(const std::vector<bool>& chosen) {
  Loads taken;
  for (Load& load : loads_) {
    Load out{{}, {}, load.x, load.y, load.time}, left = out;
    for (std::size_t k = 0; k < load.particles.size(); ++k) {
      Load& to = chosen[load.particles[k]] ? out : left;
      to.particles.push_back(load.particles[k]);
      to.share.push_back(load.share[k]);
    }
    if (!out.particles.empty()) taken.loads_.push_back(std::move(out));
    load = std::move(left);
  }
  std::erase_if(loads_, [](const Load& load) { return load.particles.empty(); });
  return taken;
}

void Loads::mark(std::vector<bool>& flags) const {
  for (const Load& load : loads_)
    for (const std::uint32_t i : load.particles) flags[i] = true;
}

void Loads::apply(const protocol::Step& step, Particles& p) {
  for (Load& load : loads_) {
    const double factor = protocol::evaluate(load.time, step.time());
    const double fx = load.x * factor, fy = load.y * factor;
    double unit_power = 0;
    for (std::size_t k = 0; k < load.particles.size(); ++k) {
      const std::uint32_t i = load.particles[k];
      unit_power += load.share[k] * (load.x * p.vx[i] + load.y * p.vy[i]);
      p.fx[i] += load.share[k] * fx;
      p.fy[i] += load.share[k] * fy;
    }
    work_ += step.dt * unit_power * (load.factor + factor) / 2;
    load.factor = factor;
  }
}

}  // namespace adit::dem
