// An independent program of the method in one dimension: a chain of springs whose last part shares its energy
// with a bar of linear elements. It is written from the equations alone, with full matrices, and shares no
// code with the solvers or the coupler.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>

namespace adit::test {

enum class ChainSolve { kConsistent, kLumped, kSplit };

struct ChainAndBar {
  double section;     // area of the cross-section; E = rho = a = 1, so the wave speed is 1
  double zone;        // h
  double begin, end;  // of the overlap: the bar begins at `begin`, the chain ends at `end`
  double length;      // of everything
  double dt;
  ChainSolve solve;
  double decay_rate;                     // of kSplit, at the chain's end
  std::function<double(double)> source;  // velocity of the first particle
};

struct ChainEnergies {
  double incident, chain, bar;
};

// What the interface makes of the predicted velocities of the coupled particles (v, first) and of the points
// of the bar in the overlap (V): a linear map of both together.
inline Eigen::MatrixXd correction(const ChainAndBar& set, const Eigen::MatrixXd& n, const Eigen::VectorXd& m,
                                  const Eigen::VectorXd& bar_m) {
  using Matrix = Eigen::MatrixXd;
  const Eigen::Index points = n.rows(), bar_points = n.cols();
  const Matrix mass = m.asDiagonal(), bar_mass = bar_m.asDiagonal();
  Matrix map = Matrix::Identity(points + bar_points, points + bar_points);
  if (set.solve == ChainSolve::kSplit) {
    // The grid's space moves as one body of both masses; what is outside of it decays.
    const Matrix seen = n.transpose() * mass * n;
    const Matrix carried = seen.inverse() * n.transpose() * mass;
    const Matrix fine = Matrix::Identity(points, points) - n * carried;
    Eigen::VectorXd share(points);
    for (Eigen::Index k = 0; k < points; ++k)
      share[k] = 1 - std::exp(-set.decay_rate * set.dt *
                              std::pow((static_cast<double>(k) + 0.5) / (set.end - set.begin), 3));
    const Matrix together = (seen + bar_mass).inverse();
    map.bottomRows(bar_points) << together * n.transpose() * mass, together * bar_mass;
    map.topRows(points) = n * map.bottomRows(bar_points);
    map.topLeftCorner(points, points) += fine - fine * share.asDiagonal() * fine;
    return map;
  }
  Matrix a = n * bar_mass.inverse() * n.transpose();
  a.diagonal() += m.cwiseInverse();
  const Matrix inverse = set.solve == ChainSolve::kConsistent
                             ? Matrix(a.inverse())
                             : Matrix(a.rowwise().sum().cwiseInverse().asDiagonal());
  Matrix gap(points, points + bar_points);
  gap << -Matrix::Identity(points, points), n;
  map.topRows(points) += mass.inverse() * inverse * gap;
  map.bottomRows(bar_points) -= bar_mass.inverse() * n.transpose() * inverse * gap;
  return map;
}

inline ChainEnergies simulate(const ChainAndBar& set, std::size_t steps) {
  using Vector = Eigen::VectorXd;
  const auto particles = static_cast<Eigen::Index>(std::lround(set.end));
  const auto zones = static_cast<Eigen::Index>(std::lround((set.length - set.begin) / set.zone));
  const auto bar_weight = [&](double x) {
    return std::clamp((x - set.begin) / (set.end - set.begin), 0.0, 1.0);
  };

  // Spring i joins particles i and i + 1, at x = i + 1/2 and i + 3/2; masses take the mean weight of their
  // springs.
  Vector spring(particles - 1), mass(particles);
  for (Eigen::Index i = 0; i + 1 < particles; ++i) spring[i] = 1 - bar_weight(static_cast<double>(i) + 1);
  for (Eigen::Index i = 0; i < particles; ++i) {
    const bool first = i == 0, last = i + 1 == particles;
    mass[i] = first ? spring[0] : last ? spring[i - 1] : (spring[i - 1] + spring[i]) / 2;
  }
  Vector element(zones), nodal = Vector::Zero(zones + 1);
  for (Eigen::Index e = 0; e < zones; ++e) {
    element[e] = bar_weight(set.begin + (static_cast<double>(e) + 0.5) * set.zone);
    nodal[e] += element[e] * set.zone / 2;
    nodal[e + 1] += element[e] * set.zone / 2;
  }
  mass *= set.section;
  nodal *= set.section;
  const Vector spring_stiffness = set.section * spring, element_stiffness = set.section / set.zone * element;

  // Particles in the overlap and their interpolation on the bar.
  const auto coupled = static_cast<Eigen::Index>(std::lround(set.end - set.begin));
  const Eigen::Index first = particles - coupled;
  const auto seen = static_cast<Eigen::Index>(std::lround((set.end - set.begin) / set.zone)) + 1;
  Eigen::MatrixXd n = Eigen::MatrixXd::Zero(coupled, seen);
  for (Eigen::Index k = 0; k < coupled; ++k) {
    const double place = (static_cast<double>(first + k) + 0.5 - set.begin) / set.zone;
    const auto e = static_cast<Eigen::Index>(place);
    n(k, e) = 1 - (place - static_cast<double>(e));
    n(k, e + 1) = place - static_cast<double>(e);
  }
  const Eigen::MatrixXd map = correction(set, n, mass.tail(coupled), nodal.head(seen));
  Vector overlap(coupled + seen);

  Vector u = Vector::Zero(particles), v = u, f = u, before = u;
  Vector bar_u = Vector::Zero(zones + 1), bar_v = bar_u, bar_f = bar_u, bar_before = bar_u;
  double work = 0, reaction = 0;
  const auto forces = [](const Vector& displacement, const Vector& stiffness, Vector& force) {
    const Eigen::Index count = stiffness.size();
    const Vector tension = stiffness.cwiseProduct(displacement.tail(count) - displacement.head(count));
    force.setZero();
    force.head(count) += tension;
    force.tail(count) -= tension;
  };
  for (std::size_t step = 0; step <= steps; ++step) {
    if (step > 0) {
      u += set.dt * v;
      bar_u += set.dt * bar_v;
    }
    forces(u, spring_stiffness, f);
    forces(bar_u, element_stiffness, bar_f);
    const double kick = step == 0 ? set.dt / 2 : set.dt;
    before = v;
    bar_before = bar_v;
    v += kick * f.cwiseQuotient(mass);
    bar_v += kick * bar_f.cwiseQuotient(nodal);
    const double next = set.source((static_cast<double>(step) + 0.5) * set.dt);
    const double last_reaction = reaction;
    reaction = mass[0] * (next - before[0]) / kick - f[0];
    if (step > 0) work += set.dt * before[0] * (last_reaction + reaction) / 2;
    v[0] = next;
    overlap << v.tail(coupled), bar_v.head(seen);
    overlap = map * overlap;
    v.tail(coupled) = overlap.head(coupled);
    bar_v.head(seen) = overlap.tail(seen);
  }
  const auto energy = [](const Vector& m, const Vector& v0, const Vector& v1, const Vector& k,
                         const Vector& displacement) {
    const Vector stretch = displacement.tail(k.size()) - displacement.head(k.size());
    return 0.5 * v0.dot(m.cwiseProduct(v1)) + 0.5 * stretch.dot(k.cwiseProduct(stretch));
  };
  return {work, energy(mass, before, v, spring_stiffness, u),
          energy(nodal, bar_before, bar_v, element_stiffness, bar_u)};
}

}  // namespace adit::test
