#include "fdm_server/materials/damping_law.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::fdm {
namespace {

constexpr double kSpring = 6;          // behind the dashpot of Rayleigh's beta
constexpr double kNarrowestBand = 30;  // of Maxwell's elements

double angular(double frequency) {
  return 2 * std::numbers::pi * frequency;
}

}  // namespace

std::size_t DampingLaw::count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(elements, [](const Element& element) { return element.spring > 0; }));
}

DampingLaw rayleigh(double ratio, double low_frequency, double high_frequency) {
  const double low = angular(low_frequency), high = angular(high_frequency);
  return rayleigh(2 * ratio * low * high / (low + high), 2 * ratio / (low + high));
}

DampingLaw rayleigh(double alpha, double beta) {
  DampingLaw law{.alpha = alpha};
  if (beta > 0) law.elements[0] = {kSpring, beta / kSpring};
  return law;
}

DampingLaw maxwell(double ratio, double low_frequency, double high_frequency) {
  constexpr Eigen::Index kSamples = 60, kElements = kMostElements;
  const double band = std::max(high_frequency / low_frequency, kNarrowestBand),
               low = angular(std::sqrt(low_frequency * high_frequency / band));
  DampingLaw law;
  Eigen::MatrixXd rows(kSamples, kElements);
  for (Eigen::Index e = 0; e < kElements; ++e) {
    const double tau = 1 / (low * std::pow(band, static_cast<double>(e) / (kElements - 1)));
    law.elements[static_cast<std::size_t>(e)].relaxation = tau;
    for (Eigen::Index k = 0; k < kSamples; ++k) {
      const double x = low * std::pow(band, static_cast<double>(k) / (kSamples - 1)) * tau;
      rows(k, e) = (x - 2 * ratio * x * x) / (1 + x * x);
    }
  }
  const Eigen::VectorXd springs =
      rows.colPivHouseholderQr().solve(Eigen::VectorXd::Constant(kSamples, 2 * ratio));
  for (Eigen::Index e = 0; e < kElements; ++e) law.elements[static_cast<std::size_t>(e)].spring = springs[e];
  return law;
}

double stiffening(const DampingLaw& law, double frequency) {
  double sum = 1;
  for (const auto& [spring, relaxation] : law.elements) {
    const double x = angular(frequency) * relaxation;
    sum += spring * x * x / (1 + x * x);
  }
  return sum;
}

double damping_ratio(const DampingLaw& law, double frequency) {
  double loss = 0;
  for (const auto& [spring, relaxation] : law.elements) {
    const double x = angular(frequency) * relaxation;
    loss += spring * x / (1 + x * x);
  }
  return (law.alpha / angular(frequency) + loss / stiffening(law, frequency)) / 2;
}

double critical_step(const DampingLaw& law, double undamped) {
  double springs = 0, viscosity = 0;
  for (const DampingLaw::Element& element : law.elements) {
    springs += element.spring;
    viscosity += element.viscosity();
  }
  const double y = viscosity / undamped, of_dashpots = undamped * (std::sqrt(1 + y * y) - y);
  return std::max(of_dashpots, undamped / std::sqrt(1 + springs));
}

MaxwellStep::MaxwellStep(const DampingLaw& law, const protocol::Step& step) {
  if (step.relax || step.from_rest()) return;
  for (std::size_t e = 0; e < kMostElements; ++e) {
    const double twice = std::max(2 * law.elements[e].relaxation, step.dt);
    keep[e] = (twice - step.dt) / (twice + step.dt);
    take[e] = 2 * law.elements[e].viscosity() / (twice + step.dt);
  }
}

}  // namespace adit::fdm
