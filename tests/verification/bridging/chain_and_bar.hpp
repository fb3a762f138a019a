// An independent program of the method in one dimension: a chain of springs whose last part shares its energy
// with a bar of linear elements. It is written from the equations alone, with full matrices, and shares no
// code with the solvers or the coupler.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

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

// Points in a row, joined by springs, at rest.
struct SpringRow {
  using Vector = Eigen::VectorXd;
  Vector mass, stiffness;
  Vector u, v, f, before;  // before: the velocity half a step ago

  SpringRow(Vector masses, Vector springs)
      : mass(std::move(masses)), stiffness(std::move(springs)), u(Vector::Zero(mass.size())) {
    v = f = before = u;
  }
  void move(double dt) { u += dt * v; }
  void find_forces() {
    const Eigen::Index count = stiffness.size();
    const Vector tension = stiffness.cwiseProduct(stretch());
    f.setZero();
    f.head(count) += tension;
    f.tail(count) -= tension;
  }
  void kick(double duration) {
    before = v;
    v += duration * f.cwiseQuotient(mass);
  }
  double energy() const {
    return 0.5 * before.dot(mass.cwiseProduct(v)) + 0.5 * stretch().dot(stiffness.cwiseProduct(stretch()));
  }
  Vector stretch() const { return u.tail(stiffness.size()) - u.head(stiffness.size()); }
};

inline double bar_weight(const ChainAndBar& set, double x) {
  return std::clamp((x - set.begin) / (set.end - set.begin), 0.0, 1.0);
}

// Spring i joins particles i and i + 1, at x = i + 1/2 and i + 3/2; masses take the mean weight of their
// springs.
inline SpringRow weighted_chain(const ChainAndBar& set) {
  const auto particles = static_cast<Eigen::Index>(std::lround(set.end));
  Eigen::VectorXd spring(particles - 1), mass(particles);
  for (Eigen::Index i = 0; i + 1 < particles; ++i)
    spring[i] = 1 - bar_weight(set, static_cast<double>(i) + 1);
  for (Eigen::Index i = 0; i < particles; ++i) {
    const bool first = i == 0, last = i + 1 == particles;
    mass[i] = first ? spring[0] : last ? spring[i - 1] : (spring[i - 1] + spring[i]) / 2;
  }
  return {set.section * mass, set.section * spring};
}

inline SpringRow weighted_bar(const ChainAndBar& set) {
  const auto zones = static_cast<Eigen::Index>(std::lround((set.length - set.begin) / set.zone));
  Eigen::VectorXd element(zones), mass = Eigen::VectorXd::Zero(zones + 1);
  for (Eigen::Index e = 0; e < zones; ++e) {
    element[e] = bar_weight(set, set.begin + (static_cast<double>(e) + 0.5) * set.zone);
    mass[e] += element[e] * set.zone / 2;
    mass[e + 1] += element[e] * set.zone / 2;
  }
  return {set.section * mass, set.section / set.zone * element};
}

// The particles in the overlap, the last ones, interpolated on the bar's first points.
inline Eigen::MatrixXd interpolation(const ChainAndBar& set, Eigen::Index particles) {
  const auto coupled = static_cast<Eigen::Index>(std::lround(set.end - set.begin));
  const auto seen = static_cast<Eigen::Index>(std::lround((set.end - set.begin) / set.zone)) + 1;
  Eigen::MatrixXd n = Eigen::MatrixXd::Zero(coupled, seen);
  for (Eigen::Index k = 0; k < coupled; ++k) {
    const double place = (static_cast<double>(particles - coupled + k) + 0.5 - set.begin) / set.zone;
    const auto e = static_cast<Eigen::Index>(place);
    n(k, e) = 1 - (place - static_cast<double>(e));
    n(k, e + 1) = place - static_cast<double>(e);
  }
  return n;
}

inline ChainEnergies simulate(const ChainAndBar& set, std::size_t steps) {
  SpringRow chain = weighted_chain(set), bar = weighted_bar(set);
  const Eigen::MatrixXd n = interpolation(set, chain.mass.size());
  const Eigen::Index coupled = n.rows(), seen = n.cols();
  const Eigen::MatrixXd map = correction(set, n, chain.mass.tail(coupled), bar.mass.head(seen));
  Eigen::VectorXd overlap(coupled + seen);
  double work = 0, reaction = 0;
  for (std::size_t step = 0; step <= steps; ++step) {
    const double kick = step == 0 ? set.dt / 2 : set.dt;
    for (SpringRow* row : {&chain, &bar}) {
      if (step > 0) row->move(set.dt);
      row->find_forces();
      row->kick(kick);
    }
    const double next = set.source((static_cast<double>(step) + 0.5) * set.dt);
    const double last_reaction = reaction;
    reaction = chain.mass[0] * (next - chain.before[0]) / kick - chain.f[0];
    if (step > 0) work += set.dt * chain.before[0] * (last_reaction + reaction) / 2;
    chain.v[0] = next;
    overlap << chain.v.tail(coupled), bar.v.head(seen);
    overlap = map * overlap;
    chain.v.tail(coupled) = overlap.head(coupled);
    bar.v.head(seen) = overlap.tail(seen);
  }
  return {work, chain.energy(), bar.energy()};
}

}  // namespace adit::test
