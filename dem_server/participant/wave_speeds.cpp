#include "dem_server/participant/wave_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem_server/model/bond_springs.hpp"

namespace adit::dem {
namespace {

constexpr int kDirections = 12;  // over half a turn

struct ElasticBond {
  std::uint32_t first, second;
  double kn, ks;  // [N/m]
};

std::vector<ElasticBond> elastic_bonds(const Model& model) {
  std::vector<ElasticBond> bonds;
  bonds.reserve(model.bonds.size() + model.springs.size());
  for (const Bond& bond : model.bonds) {
    BondSprings springs = whole_springs(model, bond);
    // The factors of a thin strip make up for the bonds that its outer rows lack: its waves run as in the
    // solid.
    if (bond.law == Bond::Law::kContactBond) springs.kn /= model.contact_bonds[bond.number].factors.stiffness;
    bonds.push_back({bond.first, bond.second, springs.kn, springs.ks});
  }
  for (const Spring& spring : model.springs)
    bonds.push_back({spring.first, spring.second, spring.stiffness, 0});
  return bonds;
}

// Squares of the speeds by the bonds of one particle, in one direction [m^2/s^2].
struct Squares {
  double p = 0, s = 0;
};

// The squares of each particle, for waves in the direction (ex, ey).
std::vector<Squares> squares(const Model& model, const std::vector<ElasticBond>& bonds, double ex,
                             double ey) {
  std::vector<Squares> sums(model.discs.size());
  if (!model.cell_elasticity.empty())
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i].p = model.elasticity_of(i).lambda / model.density[model.group[i]];
  for (const ElasticBond& bond : bonds) {
    const double x = model.discs.x[bond.second] - model.discs.x[bond.first],
                 y = model.discs.y[bond.second] - model.discs.y[bond.first];
    const double length = std::hypot(x, y);
    const double cosine = (x * ex + y * ey) / length, sine = (y * ex - x * ey) / length;  // from e to n
    const double along = cosine * cosine, both = cosine * sine, across = (along - sine * sine) / 2;
    for (const std::uint32_t i : {bond.first, bond.second}) {
      const double factor = length * length / (2 * model.mass[i]);
      sums[i].p += factor * (bond.kn * along * along + bond.ks * both * both);
      sums[i].s += factor * (bond.kn * both * both + bond.ks * across * across);
    }
  }
  return sums;
}

// Bonded particles of each group.
std::vector<std::vector<std::uint32_t>> bonded_groups(const Model& model,
                                                      const std::vector<ElasticBond>& bonds) {
  std::vector<bool> bonded(model.discs.size(), false);
  for (const ElasticBond& bond : bonds) bonded[bond.first] = bonded[bond.second] = true;
  std::vector<std::vector<std::uint32_t>> groups(model.groups());
  for (std::uint32_t i = 0; i < bonded.size(); ++i)
    if (bonded[i]) groups[model.group[i]].push_back(i);
  return groups;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Of each group, in its fastest direction; 0 for a group without bonds.
std::vector<Squares> group_squares(const Model& model) {
  const auto bonds = elastic_bonds(model);
  const auto groups = bonded_groups(model, bonds);
  std::vector<Squares> fastest(groups.size());
  std::vector<double> p, s;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = k * std::numbers::pi / kDirections;
    const auto of_particle = squares(model, bonds, std::cos(angle), std::sin(angle));
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (groups[g].empty()) continue;
      p.clear();
      s.clear();
      for (const std::uint32_t i : groups[g]) {
        p.push_back(of_particle[i].p);
        s.push_back(of_particle[i].s);
      }
      fastest[g].p = std::max(fastest[g].p, median(p));
      fastest[g].s = std::max(fastest[g].s, median(s));
    }
  }
  return fastest;
}

}  // namespace

WaveSpeeds wave_speeds(const Model& model) {
  Squares fastest;
  for (const Squares& group : group_squares(model)) {
    fastest.p = std::max(fastest.p, group.p);
    fastest.s = std::max(fastest.s, group.s);
  }
  return {std::sqrt(fastest.p), std::sqrt(fastest.s)};
}

double highest_frequency(const Model& model) {
  constexpr double kParticlesAWavelength = 10;
  const auto groups = group_squares(model);
  std::vector<double> radius(groups.size(), 0);
  for (std::size_t i = 0; i < model.discs.size(); ++i)
    radius[model.group[i]] = std::max(radius[model.group[i]], model.discs.radius[i]);
  double lowest = HUGE_VAL;
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (groups[g].s > 0)
      lowest = std::min(lowest, std::sqrt(groups[g].s) / (kParticlesAWavelength * 2 * radius[g]));
  return std::isfinite(lowest) ? lowest : 0;
}

}  // namespace adit::dem
