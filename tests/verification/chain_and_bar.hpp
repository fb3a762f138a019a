// An independent program of the method in one dimension: a chain of springs whose last part shares its energy
// with a bar of linear elements. It is written from the equations alone, with full matrices, and shares no
// code with the solvers or the coupler.
#pragma once

#include <Eigen/Dense>
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
  std::function<double(double)> source;  // velocity of the first particle
};

struct ChainEnergies {
  double incident, chain, bar;
};

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
  Eigen::MatrixXd n = Eigen::MatrixXd::Zero(coupled, zones + 1);
  for (Eigen::Index k = 0; k < coupled; ++k) {
    const double place = (static_cast<double>(first + k) + 0.5 - set.begin) / set.zone;
    const auto e = static_cast<Eigen::Index>(place);
    n(k, e) = 1 - (place - static_cast<double>(e));
    n(k, e + 1) = place - static_cast<double>(e);
  }
  Eigen::MatrixXd a = n * nodal.cwiseInverse().asDiagonal() * n.transpose();
  a.diagonal() += mass.tail(coupled).cwiseInverse();
  Eigen::MatrixXd of_chain, of_bar;  // the multipliers are of_bar V - of_chain v
  if (set.solve == ChainSolve::kSplit) {
    // The chain's motion is N c + w, with c the bar's motion of least distance; w decays, c and V are made
    // one.
    Vector decay(coupled);
    for (Eigen::Index k = 0; k < coupled; ++k) {
      const double across = bar_weight(static_cast<double>(first + k) + 0.5);
      decay[k] = 1 - std::exp(-25 / (set.end - set.begin) * std::pow(across, 3) * set.dt);
    }
    const Eigen::Index reached = (n.colwise().sum().array() > 0).count();  // grid points that see particles
    const Eigen::MatrixXd hats = n.leftCols(reached),
                          momentum = hats.transpose() * mass.tail(coupled).asDiagonal();
    const Eigen::MatrixXd seen = momentum * hats, to_bar = seen.inverse() * momentum;
    const Eigen::MatrixXd fine = Eigen::MatrixXd::Identity(coupled, coupled) - hats * to_bar;
    Eigen::MatrixXd join = nodal.head(reached).cwiseInverse().asDiagonal() * seen;
    join.diagonal().array() += 1;
    const Eigen::MatrixXd pull = mass.tail(coupled).asDiagonal() * hats * join.inverse();
    of_bar = Eigen::MatrixXd::Zero(coupled, zones + 1);
    of_bar.leftCols(reached) = pull;
    of_chain = pull * to_bar + mass.tail(coupled).asDiagonal() * fine * decay.asDiagonal() * fine;
  } else {
    of_chain = set.solve == ChainSolve::kConsistent
                   ? Eigen::MatrixXd(a.inverse())
                   : Eigen::MatrixXd(a.rowwise().sum().cwiseInverse().asDiagonal());
    of_bar = of_chain * n;
  }

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
    const Vector multipliers = of_bar * bar_v - of_chain * v.tail(coupled);
    bar_v -= (n.transpose() * multipliers).cwiseQuotient(nodal);
    v.tail(coupled) += multipliers.cwiseQuotient(mass.tail(coupled));
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
