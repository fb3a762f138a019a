#include "dem_server/lining/sections.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "dem_server/lining/median.hpp"
#include "dem_server/model/placement/joint_lines.hpp"

namespace adit::dem {
namespace {

// Of what `of` tells of these particles.
geometry::Point median_of(std::span<const std::uint32_t> particles, const auto& of) {
  std::vector<double> x, y;
  for (const std::uint32_t i : particles) {
    const geometry::Point one = of(i);
    x.push_back(one.x);
    y.push_back(one.y);
  }
  return x.empty() ? geometry::Point{0, 0} : geometry::Point{median(std::move(x)), median(std::move(y))};
}

}  // namespace

Sections::Sections(std::vector<Cut> cuts, const Particles& p, std::span<const Pair> bonds)
    : cuts_(std::move(cuts)) {
  std::set<std::uint32_t> cut_bonds;
  for (const Cut& cut : cuts_) {
    const JointLine line(cut.from, cut.to);
    std::set<std::uint32_t> beside;
    for (std::uint32_t k = 0; k < bonds.size(); ++k) {
      const auto [i, j] = bonds[k];
      if (line.crossing({p.x[i], p.y[i]}, {p.x[j], p.y[j]}) == 0) continue;
      cut_bonds.insert(k);
      beside.insert({i, j});
    }
    beside_.emplace_back(beside.begin(), beside.end());
  }
  cut_bonds_.assign(cut_bonds.begin(), cut_bonds.end());
}

geometry::Point Sections::middle(std::size_t cut) const {
  const auto& [name, from, to, strength] = cuts_[cut];
  return {(from.x + to.x) / 2, (from.y + to.y) / 2};
}

geometry::Point Sections::middle_now(std::size_t cut, const Particles& p) const {
  const auto [x, y] = middle(cut);
  const auto moved = [&p](std::uint32_t i) { return geometry::Point{p.ux[i], p.uy[i]}; };
  const auto [ux, uy] = median_of(beside_[cut], moved);
  return {x + ux, y + uy};
}

geometry::Point Sections::displacement(std::size_t cut, const Particles& p) const {
  return median_of(beside_[cut], [&p](std::uint32_t i) {
    return geometry::Point{p.ux[i] - p.settled_x[i], p.uy[i] - p.settled_y[i]};
  });
}

std::vector<SectionForces> Sections::forces(const Particles& particles,
                                            std::span<const PairForce> pairs) const {
  std::vector<SectionForces> forces;
  for (std::size_t cut = 0; cut < cuts_.size(); ++cut) forces.push_back(resultant(cut, particles, pairs));
  return forces;
}

SectionForces Sections::resultant(std::size_t cut, const Particles& p,
                                  std::span<const PairForce> pairs) const {
  const JointLine line(cuts_[cut].from, cuts_[cut].to);
  const auto [x, y] = middle_now(cut, p);
  double fx = 0, fy = 0, moment = 0;
  for (const PairForce& pair : pairs) {
    const double share =
        line.crossing({p.x[pair.first], p.y[pair.first]}, {p.x[pair.second], p.y[pair.second]});
    if (share == 0 || std::hypot(pair.x - x, pair.y - y) > line.length()) continue;
    fx += share * pair.fx;
    fy += share * pair.fy;
    moment += share * ((pair.x - x) * pair.fy - (pair.y - y) * pair.fx + pair.moment);
  }
  const auto [ex, ey] = line.direction();
  return {fx * ey - fy * ex, -moment, fx * ex + fy * ey};
}

}  // namespace adit::dem
