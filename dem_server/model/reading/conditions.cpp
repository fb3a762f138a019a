#include "dem_server/model/reading/conditions.hpp"

#include <fmt/format.h>

#include <array>

#include "protocol/errors.hpp"
#include "protocol/foundation/read.hpp"
#include "protocol/ground/stages.hpp"
#include "protocol/participant/time_function.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

// Which components of which particles earlier motions prescribe.
class Prescribed {
 public:
  explicit Prescribed(std::size_t particles) {
    for (auto& flags : flags_) flags.assign(particles, false);
  }
  void add(const PrescribedMotion& motion) {
    static constexpr const char* kNames[] = {"velocity.x", "velocity.y", "spin"};
    const auto component = static_cast<std::size_t>(motion.component);
    for (const std::uint32_t i : motion.discs) {
      if (flags_[component][i])
        throw UserError(
            motion.path + ".where",
            fmt::format("selects particles whose {} an earlier motion prescribes; separate the boxes",
                        kNames[component]));
      flags_[component][i] = true;
    }
  }

 private:
  std::array<std::vector<bool>, 3> flags_;
};

}  // namespace

TimeFactor factor_of(const scene::TimeFunction& function) {
  return [function](double time) { return protocol::evaluate(function, time); };
}

std::vector<Load> read_loads(const scene::Particles& particles, const Placement& placement) {
  std::vector<Load> loads;
  for (int i = 0; i < particles.loads_size(); ++i) {
    const auto& load = particles.loads(i);
    const std::string path = fmt::format("particles.loads[{}]", i);
    const TimeFactor time = factor_of(load.time());
    loads.push_back({Load::Kind::kForce, select(load.where(), placement, path + ".where"), load.force().x(),
                     load.force().y(), time, path, protocol::is_steady(load.time())});
  }
  for (int i = 0; i < particles.body_loads_size(); ++i) {
    const auto& load = particles.body_loads(i);
    const std::string path = fmt::format("particles.body_loads[{}]", i);
    const TimeFactor time = factor_of(load.time());
    loads.push_back({Load::Kind::kAcceleration, select(load.where(), placement, path + ".where"),
                     load.acceleration().x(), load.acceleration().y(), time, path,
                     protocol::is_steady(load.time())});
  }
  return loads;
}

std::vector<PrescribedMotion> read_motions(const scene::Particles& particles, const Placement& placement) {
  std::vector<PrescribedMotion> motions;
  Prescribed prescribed(placement.discs.size());
  for (int i = 0; i < particles.motions_size(); ++i) {
    const auto& motion = particles.motions(i);
    const auto& velocity = motion.velocity();
    const std::string path = fmt::format("particles.motions[{}]", i);
    const TimeFactor time = factor_of(motion.time());
    if (!velocity.has_x() && !velocity.has_y() && !motion.has_spin())
      throw UserError(path, "prescribes nothing; give velocity.x, velocity.y or spin, or remove it");
    const auto chosen = select(motion.where(), placement, path + ".where");
    const auto add = [&](Component component, double amplitude) {
      prescribed.add(motions.emplace_back(PrescribedMotion{component, chosen, amplitude, time, path}));
    };
    if (velocity.has_x()) add(Component::kX, velocity.x());
    if (velocity.has_y()) add(Component::kY, velocity.y());
    if (motion.has_spin()) add(Component::kSpin, motion.spin());
  }
  return motions;
}

std::vector<Foundation> read_foundations(const scene::Particles& particles, const Placement& placement) {
  if (particles.foundations_size() > 0 && protocol::stages_of(particles).size() > 1)
    throw protocol::UserError(
        "particles.foundations",
        "are given beside later stages, but foundations hold what is there from the beginning; "
        "leave one of them out");
  std::vector<Foundation> foundations;
  for (int k = 0; k < particles.foundations_size(); ++k) {
    const scene::Foundation& given = particles.foundations(k);
    const std::string path = "particles.foundations[" + std::to_string(k) + "]";
    const auto ground = foundation::read_ground(given, path);
    const auto discs = select(given.where(), placement, path + ".where");
    for (const auto& [direction, law] : foundation::read_laws(given, path))
      foundations.push_back({direction, law, ground, discs, path});
  }
  return foundations;
}

}  // namespace adit::dem
