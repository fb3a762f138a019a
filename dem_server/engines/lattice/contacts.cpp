#include "dem_server/engines/lattice/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/laws/linear_contact.hpp"

namespace adit::dem {
namespace {

constexpr double kSkin = 0.5;  // of a radius

struct Gap {
  double x, y, squared;  // from the first to the second centre
};

Gap gap_of(const Pair& pair, const Particles& p) {
  // Places at rest and displacements are subtracted apart, so that the small differences keep their digits
  // far from the origin.
  const double x = (p.x[pair.second] - p.x[pair.first]) + (p.ux[pair.second] - p.ux[pair.first]);
  const double y = (p.y[pair.second] - p.y[pair.first]) + (p.uy[pair.second] - p.uy[pair.first]);
  return {x, y, x * x + y * y};
}

double weight_of(const Pair& pair, const Particles& p) {
  return 0.5 * (p.weight[pair.first] + p.weight[pair.second]);
}

}  // namespace

Contacts::Contacts(const Assembly& assembly)
    : bonded_(ends_of(assembly.bonds), assembly.particles.size()),
      skin_(kSkin * assembly.bonds.rest_length / 2) {
  list(assembly);
}

bool Contacts::update(double dt, const Assembly& assembly) {
  // The next step will hardly be twice as fast as the last one.
  const double allowed = skin_ / 2 - 2 * dt * speed_;
  if (moved_.most() <= allowed) return false;
  moved_.measure(assembly.particles);
  if (moved_.most() <= allowed) return false;
  list(assembly);
  return true;
}

void Contacts::list(const Assembly& assembly) {
  const Particles& p = assembly.particles;
  pairs_ = pairs_within(moved_.start(p, std::vector(p.size(), assembly.bonds.rest_length / 2)), skin_);
  std::erase_if(pairs_, [&](const Pair& pair) { return bonded_.bonded(pair.first, pair.second); });
  ++lists_;
}

void add_contacts(double normal_stiffness, double diameter, std::span<const Pair> pairs,
                  const Particles& particles, const Resultants& resultants) {
  for (const Pair& pair : pairs) {
    const Gap gap = gap_of(pair, particles);
    if (!(gap.squared < diameter * diameter)) continue;
    const double length = std::sqrt(gap.squared);
    const double force =
        contact_normal_force(weight_of(pair, particles) * normal_stiffness, length - diameter) / length;
    resultants.fx[pair.first] += force * gap.x;
    resultants.fy[pair.first] += force * gap.y;
    resultants.fx[pair.second] -= force * gap.x;
    resultants.fy[pair.second] -= force * gap.y;
  }
}

double contact_energy(double normal_stiffness, double diameter, std::span<const Pair> pairs,
                      const Particles& particles) {
  double twice = 0;
  for (const Pair& pair : pairs) {
    const Gap gap = gap_of(pair, particles);
    if (!(gap.squared < diameter * diameter)) continue;
    const double overlap = diameter - std::sqrt(gap.squared);
    twice += weight_of(pair, particles) * normal_stiffness * overlap * overlap;
  }
  return twice / 2;
}

}  // namespace adit::dem
