#include "dem_server/model/solid/ring_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

constexpr std::size_t kNeighbours = 6;
constexpr double kTouching = 1e-6;  // gap of two that touch, at most; in radii, as all that follows
// No place of a ring is farther from its nearest particle: the lattice leaves none farther than 1.16 from a
// site, and where a face has cut that one off, the next lies behind it.
constexpr double kReach = 2.2;
constexpr double kSample = 1.0 / 12;
// Factors are multiples of this, so that few laws stand for all bonds.
constexpr double kStep = 1.0 / 32;

using Lists = std::vector<std::vector<std::uint32_t>>;

// Of each disc in the ring, those in it whose centres are within so many radii.
Lists near_discs(const Discs& discs, const std::vector<bool>& in_ring, double distance) {
  Lists near(discs.size());
  for (const auto& [i, j] : pairs_within(discs, (distance - 2) * discs.radius.front())) {
    if (!in_ring[i] || !in_ring[j]) continue;
    near[i].push_back(j);
    near[j].push_back(i);
  }
  return near;
}

// The part of the annulus that lies nearer to disc i than to the others, in cells, by sampling.
double cells_of(const scene::Annulus& ring, const Discs& discs, std::size_t i,
                const std::vector<std::uint32_t>& others) {
  const double radius = discs.radius[i];
  const auto squared = [&](double x, double y, std::size_t k) {
    return (discs.x[k] - x) * (discs.x[k] - x) + (discs.y[k] - y) * (discs.y[k] - y);
  };
  const auto belongs = [&](double x, double y) {
    const double distance = std::hypot(x - ring.centre().x(), y - ring.centre().y());
    if (distance < ring.inner_radius() || distance > ring.outer_radius()) return false;
    const double own = squared(x, y, i);
    return own <= kReach * kReach * radius * radius &&
           std::ranges::none_of(others, [&](std::uint32_t k) { return squared(x, y, k) < own; });
  };
  const auto samples = static_cast<int>(std::ceil(kReach / kSample));
  std::size_t count = 0;
  for (int a = -samples; a < samples; ++a)
    for (int b = -samples; b < samples; ++b)
      count += belongs(discs.x[i] + (a + 0.5) * kSample * radius, discs.y[i] + (b + 0.5) * kSample * radius);
  return static_cast<double>(count) * kSample * kSample / (2 * std::numbers::sqrt3);
}

// Numbers of the laws with factors, each once.
class Laws {
 public:
  explicit Laws(std::vector<ContactBond>& laws) : laws_(laws) {}
  std::uint32_t find(std::uint32_t law, double factor) {
    const double rounded = std::max(std::round(factor / kStep), 1.0) * kStep;
    if (rounded == 1) return law;
    const auto [found, is_new] =
        numbers_.try_emplace({law, rounded}, static_cast<std::uint32_t>(laws_.size()));
    if (is_new) {
      laws_.push_back(ContactBond{laws_[law]});
      laws_.back().factors = {rounded, rounded};
    }
    return found->second;
  }

 private:
  std::vector<ContactBond>& laws_;
  std::map<std::pair<std::uint32_t, double>, std::uint32_t> numbers_;
};

void require_possible(const scene::Particles& particles, const Group& group, std::uint32_t number) {
  const scene::ParticleGroup& wanted = particles.groups(static_cast<int>(number) - 1);
  scene::Area others = wanted.where();
  others.clear_annulus();
  const auto require = [&](bool possible, const char* why) {
    if (!possible)
      throw protocol::UserError(
          fmt::format("particles.groups[{}].bends_as_solid", number - 1),
          fmt::format(
              "is set, but {}; it is possible for an annulus of contact bonds in a hexagonal `packing`; "
              "change that, or leave it out",
              why));
  };
  require(particles.has_packing(), "the packing is not hexagonal");
  require(wanted.where().has_annulus() && others.ByteSizeLong() == 0,
          "`where` is more or other than an annulus");
  require(group.bonds != nullptr, "no bonds join the particles");
  require(!group.bonds->has_parallel(), "parallel bonds join the particles");
}

void stiffen(const scene::Annulus& ring, std::uint32_t group, const Discs& discs, ParticleStage& stage,
             Laws& laws) {
  std::vector<bool> in_ring(discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) in_ring[i] = stage.present[i] && stage.group[i] == group;
  if (std::ranges::find(in_ring, true) == in_ring.end()) return;
  const std::vector<double> factors = face_factors(ring, discs, in_ring);
  for (Bond& bond : stage.bonds)
    if (in_ring[bond.first] && in_ring[bond.second] && bond.law == Bond::Law::kContactBond)
      bond.number = laws.find(bond.number, (factors[bond.first] + factors[bond.second]) / 2);
}

}  // namespace

std::vector<double> face_factors(const scene::Annulus& ring, const Discs& discs,
                                 const std::vector<bool>& in_ring) {
  const Lists touching = near_discs(discs, in_ring, 2 + kTouching),
              near = near_discs(discs, in_ring, 2 * kReach);
  std::vector<double> factors(discs.size(), 1.0);
  for (std::size_t i = 0; i < discs.size(); ++i)
    if (const std::size_t count = touching[i].size(); in_ring[i] && count > 0 && count < kNeighbours)
      factors[i] = kNeighbours * cells_of(ring, discs, i, near[i]) / static_cast<double>(count);
  return factors;
}

void stiffen_ring_faces(const scene::Particles& particles, const std::vector<Group>& groups, Model& model) {
  Laws laws(model.contact_bonds);
  for (int k = 0; k < particles.groups_size(); ++k) {
    if (!particles.groups(k).bends_as_solid()) continue;
    const auto number = static_cast<std::uint32_t>(k) + 1;
    require_possible(particles, groups[number], number);
    for (ParticleStage& stage : model.stages)
      stiffen(particles.groups(k).where().annulus(), number, model.discs, stage, laws);
  }
}

}  // namespace adit::dem
