#include "fdm_server/structures/joint_law.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::fdm {
namespace {

// Of what acts at z, on the opening of the axis and the rotation.
Eigen::Vector2d lever(double position) {
  return {1, position};
}

Eigen::Matrix2d at(double position, double stiffness) {
  return stiffness * lever(position) * lever(position).transpose();
}

}  // namespace

Eigen::Matrix2d JointFaces::stiffness(const JointOpening& opening) const {
  const double delta = opening[0], phi = opening[1], edge = height / 2;
  // The part of the height in contact.
  double from = -edge, to = edge;
  if (phi > 0) to = std::clamp(-delta / phi, -edge, edge);
  if (phi < 0) from = std::clamp(-delta / phi, -edge, edge);
  if (phi == 0 && delta > 0) to = from;
  const double area = to - from, first = (to * to - from * from) / 2,
               second = (to * to * to - from * from * from) / 3;
  return young / height * Eigen::Matrix2d{{area, first}, {first, second}};
}

Eigen::Matrix2d JointFaces::closed() const {
  return Eigen::Matrix2d{{young, 0}, {0, young * height * height / 12}};
}

double JointBolts::force(double opening, double slack) const {
  return std::clamp(stiffness * (opening - slack), 0.0, yield);
}

double JointBolts::stiffness_at(double opening, double slack) const {
  const double elastic = stiffness * (opening - slack);
  return elastic >= 0 && elastic <= yield ? stiffness : 0;
}

JointForces JointLaw::forces(const JointOpening& opening, std::span<const double> slack) const {
  JointForces sum = faces.forces(opening);
  for (std::size_t k = 0; k < bolts.size(); ++k)
    sum += bolts[k].force(opening_at(opening, bolts[k].position), slack[k]) * lever(bolts[k].position);
  if (gasket) sum += gasket->force.force(opening_at(opening, gasket->position)) * lever(gasket->position);
  return sum;
}

Eigen::Matrix2d JointLaw::stiffness(const JointOpening& opening, std::span<const double> slack) const {
  Eigen::Matrix2d sum = faces.stiffness(opening);
  for (std::size_t k = 0; k < bolts.size(); ++k)
    sum += at(bolts[k].position, bolts[k].stiffness_at(opening_at(opening, bolts[k].position), slack[k]));
  if (gasket) sum += at(gasket->position, gasket->force.slope(opening_at(opening, gasket->position)));
  return sum;
}

double JointLaw::stored(const JointOpening& opening, std::span<const double> slack) const {
  double sum = opening.dot(faces.forces(opening)) / 2;
  for (std::size_t k = 0; k < bolts.size(); ++k) {
    const double force = bolts[k].force(opening_at(opening, bolts[k].position), slack[k]);
    sum += force * force / bolts[k].stiffness / 2;
  }
  if (gasket) sum += gasket->force.energy(opening_at(opening, gasket->position));
  return sum;
}

// Newton's method. Steps are halved until the energy of the mismatch in the springs k falls; it does at first
// along Newton's direction, whatever the tangent. At rounding it does no longer.
JointOpening JointLaw::solve(const JointOpening& opening, std::span<const double> slack,
                             const Eigen::Matrix2d& k, const JointForces& load) const {
  constexpr int kMostSteps = 100;
  constexpr double kSmallest = 1e-3;                  // part of a step
  constexpr double kSame = 1e-26, kRounding = 1e-20;  // of the energy that the forces have in the springs
  const Eigen::Matrix2d flexibility = k.inverse();
  const auto mismatch = [&](const JointOpening& moved) -> JointForces {
    return load - forces(opening + moved, slack) - k * moved;
  };
  const auto energy = [&](const JointForces& missed) { return missed.dot(flexibility * missed); };
  const JointForces before = forces(opening, slack);
  const double whole = energy(load) + energy(before);
  JointOpening moved = JointOpening::Zero();
  JointForces missed = load - before;
  for (int step = 0; step < kMostSteps && energy(missed) > kSame * whole; ++step) {
    const Eigen::Matrix2d tangent = stiffness(opening + moved, slack) + k;
    const JointOpening way = tangent.inverse() * missed;
    const double smallest = energy(missed) > kRounding * whole ? kSmallest : 1;
    double part = 1;
    JointForces left = mismatch(moved + way);
    while (energy(left) >= energy(missed) && part > smallest) {
      part /= 2;
      left = mismatch(moved + part * way);
    }
    if (energy(left) >= energy(missed)) break;
    moved += part * way;
    missed = left;
  }
  return moved;
}

// The pretension is a load here, so that it is what the bolts have afterwards. Springs that are soft beside
// the faces hold the joint; where they are left without force, it balances itself.
std::optional<JointOpening> JointLaw::installed() const {
  constexpr int kMost = 100;
  constexpr double kSoft = 1e-6, kSame = 1e-12;
  JointLaw without_bolts = *this;
  without_bolts.bolts.clear();
  JointForces pretension = JointForces::Zero();
  for (const JointBolts& row : bolts) pretension += row.pretension * lever(row.position);
  const double size = pretension[0] + (gasket ? std::abs(gasket->force.force(0)) : 0);
  JointOpening opening = JointOpening::Zero();
  for (int trial = 0; trial < kMost; ++trial) {
    const JointForces left = without_bolts.forces(opening, {}) + pretension;
    if (std::abs(left[0]) <= kSame * size && std::abs(left[1]) <= kSame * size * faces.height) return opening;
    opening += without_bolts.solve(opening, {}, kSoft * faces.closed(), -pretension);
  }
  return std::nullopt;
}

}  // namespace adit::fdm
