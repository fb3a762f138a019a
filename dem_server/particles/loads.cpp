#include "dem_server/particles/loads.hpp"

namespace adit::dem {

Loads::Loads(const Model& model, const Particles& particles) {
  for (const Load& load : model.loads) {
    std::vector<std::uint32_t> discs = load.discs;
    std::erase_if(discs, [&](std::uint32_t i) { return !particles.is_there(i); });
    std::vector<double> share(discs.size(), 1.0 / static_cast<double>(discs.size()));
    if (load.kind == Load::Kind::kAcceleration)
      // The masses carry the energy weights, so an overlap that is shared with the continuum is not loaded
      // twice.
      for (std::size_t k = 0; k < share.size(); ++k) share[k] = particles.mass[discs[k]];
    loads_.push_back({load.kind, std::move(discs), std::move(share), load.x, load.y, load.time, load.steady});
  }
}

Acceleration Loads::take_gravity(const Particles& particles) {
  Acceleration sum;
  std::erase_if(loads_, [&](const Shared& load) {
    const bool of_all =
        load.kind == Load::Kind::kAcceleration && load.steady && load.particles.size() == particles.size();
    if (!of_all) return false;
    sum.x += load.x * load.time(0);
    sum.y += load.y * load.time(0);
    return true;
  });
  return sum;
}

Loads Loads::take(const std::vector<bool>& chosen) {
  Loads taken;
  for (Shared& load : loads_) {
    Shared out{load.kind, {}, {}, load.x, load.y, load.time, load.steady}, left = out;
    for (std::size_t k = 0; k < load.particles.size(); ++k) {
      Shared& to = chosen[load.particles[k]] ? out : left;
      to.particles.push_back(load.particles[k]);
      to.share.push_back(load.share[k]);
    }
    if (!out.particles.empty()) taken.loads_.push_back(std::move(out));
    load = std::move(left);
  }
  std::erase_if(loads_, [](const Shared& load) { return load.particles.empty(); });
  return taken;
}

void Loads::mark(std::vector<bool>& flags) const {
  for (const Shared& load : loads_)
    for (const std::uint32_t i : load.particles) flags[i] = true;
}

void Loads::apply(const protocol::Step& step, Particles& p) {
  for (Shared& load : loads_) {
    const double factor = load.time(step.time());
    const double fx = load.x * factor, fy = load.y * factor;
    double unit_power = 0;
    for (std::size_t k = 0; k < load.particles.size(); ++k) {
      const std::uint32_t i = load.particles[k];
      unit_power += load.share[k] * (load.x * p.vx[i] + load.y * p.vy[i]);
      p.fx[i] += load.share[k] * fx;
      p.fy[i] += load.share[k] * fy;
    }
    (load.kind == Load::Kind::kForce ? work_.forces : work_.accelerations) +=
        step.dt * unit_power * (load.factor + factor) / 2;
    load.factor = factor;
  }
}

}  // namespace adit::dem
