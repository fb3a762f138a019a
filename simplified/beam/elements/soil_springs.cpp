#include "simplified/beam/elements/soil_springs.hpp"

#include <algorithm>
#include <cmath>

namespace adit::simplified::beam {
namespace {

double between(double a, double b, double fraction) {
  // An infinite slip force, of a linear spring, has no mean with another value, so the nearer station
  // decides.
  return std::isinf(a) || std::isinf(b) ? (fraction < 0.5 ? a : b) : std::lerp(a, b, fraction);
}

SoilStation soil_at(const std::vector<SoilStation>& soil, double x) {
  const auto above =
      std::upper_bound(soil.begin(), soil.end(), x,
                       [](double value, const SoilStation& station) { return value < station.chainage; });
  if (above == soil.begin()) return soil.front();
  if (above == soil.end()) return soil.back();
  const SoilStation &before = *(above - 1), &after = *above;
  const double fraction = (x - before.chainage) / (after.chainage - before.chainage);
  SoilStation here{x,
                   {},
                   between(before.liquefied, after.liquefied, fraction),
                   between(before.uplift, after.uplift, fraction)};
  for (int d = 0; d < 3; ++d) {
    const SoilSpring &a = before.springs[d], &b = after.springs[d];
    here.springs[d] = {between(a.stiffness, b.stiffness, fraction),
                       between(a.slip_force, b.slip_force, fraction),
                       between(a.hardening, b.hardening, fraction), between(a.dashpot, b.dashpot, fraction)};
  }
  return here;
}

// The value of a step by its values at start and end.
double blend(const Scheme& scheme, const double (&values)[2]) {
  return (1 - scheme.alpha_f) * values[1] + scheme.alpha_f * values[0];
}

double mean(const double (&values)[2]) {
  return 0.5 * (values[0] + values[1]);
}

template <std::size_t N>
double interpolate(const std::array<double, N>& shape, const std::array<int, N>& dofs, const double* nodal) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += shape[i] * nodal[dofs[i]];
  return sum;
}

template <std::size_t N>
void scatter(const std::array<double, N>& shape, const std::array<int, N>& dofs, double force,
             double* nodal) {
  for (std::size_t i = 0; i < N; ++i) nodal[dofs[i]] += shape[i] * force;
}

// Adds factor · Nᵀ N to the three blocks of a link.
template <std::size_t N>
void add_product(BlockTridiagonal& matrix, std::size_t link, const std::array<double, N>& shape,
                 const std::array<int, N>& dofs, double factor) {
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) {
      const int row = dofs[i], column = dofs[j];
      const double value = factor * shape[i] * shape[j];
      if (row < kDofs && column < kDofs) matrix.diagonal[link](row, column) += value;
      if (row >= kDofs && column >= kDofs) matrix.diagonal[link + 1](row - kDofs, column - kDofs) += value;
      if (row >= kDofs && column < kDofs) matrix.lower[link](row - kDofs, column) += value;
    }
}

}  // namespace

SoilSprings::SoilSprings(const Tunnel& tunnel, const Mesh& mesh, std::span<const Element> elements)
    : links_(mesh.elements), link_count_(mesh.links.size()) {
  for (std::size_t e = 0; e < links_.size(); ++e)
    for (const auto& quadrature : kThreePoints) {
      const Element& element = elements[e];
      const double x = mesh.nodes[links_[e]] + quadrature.xi * element.length();
      const SoilStation ground = soil_at(tunnel.soil, x);
      const double length = quadrature.weight * element.length();
      chainages_.push_back(x);
      points_.push_back({{1 - quadrature.xi, quadrature.xi},
                         shape(element.plane(kLateral), element.length(), quadrature.xi).deflection,
                         shape(element.plane(kVertical), element.length(), quadrature.xi).deflection,
                         ground.liquefied,
                         length * ground.uplift});
      for (const SoilSpring& soil : ground.springs) {
        // A spring that never slips needs no slider: all of its stiffness is elastic.
        const double slider = std::isinf(soil.slip_force) ? 0 : 1 - soil.hardening;
        Spring spring{};
        spring.elastic = length * (1 - slider) * soil.stiffness;
        spring.slider = length * slider * soil.stiffness;
        spring.slider_limit = slider > 0 ? length * slider * soil.slip_force : 0;
        spring.dashpot = length * soil.dashpot;
        springs_.push_back(spring);
      }
    }
}

void SoilSprings::respond(const Scheme& scheme, const Point& point, Spring& s) const {
  const double travel = s.elongation[1] - s.elongation[0];
  const double trial = s.slider_force[0] + s.slider * travel;
  s.slider_force[1] = std::clamp(trial, -s.slider_limit, s.slider_limit);
  const bool slips = s.slider_force[1] != trial;
  double slider_mean = 0.5 * (s.slider_force[0] + trial);
  s.slip = 0;
  if (slips) {
    // The elongation is linear over the step, so the slider first follows elastically up to its limit and
    // then slips under the constant limit force. The mean force is that of this path and its work is exact.
    const double elastic_travel = (s.slider_force[1] - s.slider_force[0]) / s.slider;
    const double slip = travel - elastic_travel;
    slider_mean =
        (0.5 * (s.slider_force[0] + s.slider_force[1]) * elastic_travel + s.slider_force[1] * slip) / travel;
    s.slip = mean(point.multiplier) * s.slider_force[1] * slip;
  }
  s.force[1] = point.multiplier[1] * (s.elastic * s.elongation[1] + s.slider_force[1]);
  s.mean_force =
      mean(point.multiplier) * (0.5 * s.elastic * (s.elongation[0] + s.elongation[1]) + slider_mean);
  if (scheme.mean_force)
    // The derivative of the mean force by the elongation at the end: half the stiffness of a linear part, and
    // while slipping (end force - mean force) / travel, as for every mean over an interval.
    s.tangent = mean(point.multiplier) *
                (0.5 * s.elastic + (slips ? (s.slider_force[1] - slider_mean) / travel : 0.5 * s.slider));
  else
    s.tangent = (1 - scheme.alpha_f) * point.multiplier[1] * (s.elastic + (slips ? 0 : s.slider));
  // The matrix has the dashpots of sound ground already.
  s.tangent += (blend(scheme, point.multiplier) - 1) * dashpot_tangent_ * s.dashpot;
}

double SoilSprings::stored(const Spring& s, int end) {
  const double slider = s.slider > 0 ? s.slider_force[end] * s.slider_force[end] / s.slider : 0;
  return 0.5 * (s.elastic * s.elongation[end] * s.elongation[end] + slider);
}

void SoilSprings::evaluate(const Scheme& scheme, std::span<const double> u, std::span<const double> v,
                           const GroundState& ground, std::span<double> forces) {
  for (std::size_t p = 0; p < points_.size(); ++p) {
    Point& point = points_[p];
    point.pressure_ratio[1] = ground.pressure_ratio[p + first_support];
    point.multiplier[1] = 1 - point.pressure_ratio[1] * (1 - point.liquefied);
    const std::size_t base = kDofs * links_[p / kThreePoints.size()];
    const double *up = u.data() + base, *vp = v.data() + base;
    const double position[3] = {interpolate(point.axial, kAxialDofs, up),
                                interpolate(point.lateral, kLateralDofs, up),
                                interpolate(point.vertical, kVerticalDofs, up)};
    const double speed[3] = {interpolate(point.axial, kAxialDofs, vp),
                             interpolate(point.lateral, kLateralDofs, vp),
                             interpolate(point.vertical, kVerticalDofs, vp)};
    double total[3];
    for (int d = 0; d < 3; ++d) {
      Spring& s = springs_[3 * p + d];
      s.ground[1] = ground.displacement[d][p + first_support];
      s.elongation[1] = position[d] - s.ground[1];
      s.rate[1] = speed[d] - ground.velocity[d][p + first_support];
      respond(scheme, point, s);
      const double spring = scheme.mean_force ? s.mean_force : blend(scheme, s.force);
      total[d] = spring + blend(scheme, point.multiplier) * s.dashpot * blend(scheme, s.rate);
    }
    total[kVertical] -= point.uplift * blend(scheme, point.pressure_ratio);
    double* f = forces.data() + base;
    scatter(point.axial, kAxialDofs, total[kAxial], f);
    scatter(point.lateral, kLateralDofs, total[kLateral], f);
    scatter(point.vertical, kVerticalDofs, total[kVertical], f);
  }
}

std::size_t SoilSprings::update_tangents(BlockTridiagonal& matrix) {
  std::size_t first = link_count_;
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    Spring& s = springs_[i];
    if (s.tangent == s.assembled_tangent) continue;
    const Point& point = points_[i / 3];
    const std::size_t link = links_[i / (3 * kThreePoints.size())];
    const double change = s.tangent - s.assembled_tangent;
    if (i % 3 == kAxial) add_product(matrix, link, point.axial, kAxialDofs, change);
    if (i % 3 == kLateral) add_product(matrix, link, point.lateral, kLateralDofs, change);
    if (i % 3 == kVertical) add_product(matrix, link, point.vertical, kVerticalDofs, change);
    s.assembled_tangent = s.tangent;
    first = std::min(first, link);
  }
  return first;
}

void SoilSprings::forget_tangents() {
  for (Spring& s : springs_) s.assembled_tangent = 0;
}

void SoilSprings::add_dashpots(BlockTridiagonal& matrix, double factor) {
  dashpot_tangent_ = factor;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const std::size_t link = links_[p / kThreePoints.size()];
    const Spring* s = &springs_[3 * p];
    add_product(matrix, link, points_[p].axial, kAxialDofs, factor * s[kAxial].dashpot);
    add_product(matrix, link, points_[p].lateral, kLateralDofs, factor * s[kLateral].dashpot);
    add_product(matrix, link, points_[p].vertical, kVerticalDofs, factor * s[kVertical].dashpot);
  }
}

// The spring's force F acts on the ground end of the spring, so moving that end by Δu_g does the work −F
// Δu_g.
SoilWork SoilSprings::commit(const Scheme& scheme) {
  SoilWork work;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const Spring& vertical = springs_[3 * p + kVertical];
    work.uplift +=
        points_[p].uplift * mean(points_[p].pressure_ratio) *
        (vertical.elongation[1] - vertical.elongation[0] + vertical.ground[1] - vertical.ground[0]);
  }
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    Spring& s = springs_[i];
    const auto& multiplier = points_[i / 3].multiplier;
    const double travel = s.elongation[1] - s.elongation[0];
    // At start and end, or of the mean motion.
    const double dashpot = scheme.mean_force
                               ? mean(multiplier) * s.dashpot * mean(s.rate)
                               : 0.5 * s.dashpot * (multiplier[0] * s.rate[0] + multiplier[1] * s.rate[1]);
    const double spring = scheme.mean_force ? s.mean_force : mean(s.force);
    const double loss = multiplier[0] - multiplier[1];
    const double weakening = loss == 0 ? 0 : 0.5 * (stored(s, 0) + stored(s, 1)) * loss;
    work.stored += s.mean_force * travel - s.slip - weakening;
    work.slip += s.slip;
    work.weakening += weakening;
    work.dashpots += dashpot * travel;
    work.input -= (spring + dashpot) * (s.ground[1] - s.ground[0]);
    s.elongation[0] = s.elongation[1];
    s.slider_force[0] = s.slider_force[1];
    s.rate[0] = s.rate[1];
    s.ground[0] = s.ground[1];
    s.force[0] = s.force[1];
  }
  for (Point& point : points_) {
    point.pressure_ratio[0] = point.pressure_ratio[1];
    point.multiplier[0] = point.multiplier[1];
  }
  return work;
}

}  // namespace adit::simplified::beam
