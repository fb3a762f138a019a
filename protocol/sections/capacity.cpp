#include "protocol/sections/capacity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>

#include "protocol/sections/axial_strain.hpp"

namespace adit::sections {
namespace {

constexpr std::size_t kCapacityLayers = 200;
constexpr int kPointsOfPivot = 48;
constexpr int kFiner = 8;  // limit states in each step of the diagram

// From 0 to 3, closer towards the end of each pivot, where the strains are those at which steel yields.
std::vector<double> spread(int points_of_pivot) {
  std::vector<double> pivots;
  for (int pivot = 0; pivot < 3; ++pivot)
    for (int i = 0; i < points_of_pivot; ++i) {
      const double left = 1 - static_cast<double>(i) / points_of_pivot;
      pivots.push_back(pivot + 1 - left * left * left);
    }
  pivots.push_back(3);
  return pivots;
}

}  // namespace

Capacity::Capacity(const SectionShape& shape, const CapacityMaterials& materials)
    : shape_(shape), materials_(materials), layers_(concrete_layers(shape, kCapacityLayers)) {
  const std::vector<double> pivots = spread(kFiner * kPointsOfPivot);
  for (const Bending bending : {Bending::kOuterStretched, Bending::kInnerStretched}) {
    std::vector<SectionForces>& limits = limits_[bending == Bending::kInnerStretched];
    for (const double pivot : pivots) limits.push_back(limit(bending, pivot));
    for (std::size_t i = 0; i < limits.size(); i += kFiner) diagram_.push_back(limits[i]);
  }
  for (const SectionForces& point : diagram_) {
    thrust_scale_ = std::max(thrust_scale_, std::abs(point.thrust));
    moment_scale_ = std::max(moment_scale_, std::abs(point.moment));
  }
  std::ranges::sort(diagram_, {}, [this](const SectionForces& point) { return direction(point); });
  for (const SectionForces& point : diagram_) directions_.push_back(direction(point));
}

SectionForces Capacity::forces(double strain, double curvature) const {
  SectionForces sum{};
  const auto add = [&sum](double force, double position) {
    sum.thrust += force;
    sum.moment += force * position;
  };
  for (const auto& [z, area] : layers_) {
    const double local = strain + curvature * z;
    add(area * (local > 0 ? materials_.residual.stress(local) : materials_.concrete.stress(local)), z);
  }
  for (const auto& [z, area, diameter] : shape_.bars) {
    const double elastic = materials_.steel_modulus * (strain + curvature * z);
    add(area * std::clamp(elastic, -materials_.steel_yield, materials_.steel_yield), z);
  }
  return sum;
}

SectionForces Capacity::limit(Bending bending, double pivot) const {
  const double outwards = bending == Bending::kOuterStretched ? 1 : -1, h = shape_.thickness;
  double depth = h, limit = materials_.residual.end_strain;  // of the pivot A
  if (!shape_.bars.empty()) {
    depth = 0;
    limit = materials_.steel_limit;
    for (const BarLayer& bars : shape_.bars) depth = std::max(depth, h / 2 + outwards * bars.position);
  }
  const double crushing = materials_.concrete.ultimate_strain, peak = materials_.concrete.peak_strain;
  double face = -crushing, gradient = 0;  // the strain at the compressed face, and over the depth
  if (pivot < 1) {
    face = limit - pivot * (limit + crushing);
    gradient = (limit - face) / depth;
  } else if (pivot < 2) {
    const double last = -crushing * (1 - depth / h);  // the far face has no strain
    gradient = (limit + (pivot - 1) * (last - limit) - face) / depth;
  } else {
    const double fixed = (1 - peak / crushing) * h, far = -(pivot - 2) * peak;
    gradient = (far + peak) / (h - fixed);
    face = -peak - gradient * fixed;
  }
  return forces(face + gradient * h / 2, outwards * gradient);
}

double Capacity::moment(Bending bending, double thrust) const {
  const std::vector<SectionForces>& limits = limits_[bending == Bending::kInnerStretched];
  const auto next = std::ranges::lower_bound(limits, thrust, std::greater(), &SectionForces::thrust);
  if (next == limits.begin()) return limits.front().moment;
  if (next == limits.end()) return limits.back().moment;
  const SectionForces &before = *std::prev(next), &after = *next;
  const double way = (thrust - before.thrust) / (after.thrust - before.thrust);
  return before.moment + way * (after.moment - before.moment);
}

double Capacity::moment_at_curvature(double thrust, double curvature) const {
  const double strain =
      axial_strain([&](double trial) { return forces(trial, curvature).thrust; }, thrust, 0);
  return forces(strain, curvature).moment;
}

double Capacity::direction(const SectionForces& forces) const {
  return std::atan2(forces.moment / moment_scale_, forces.thrust / thrust_scale_);
}

double Capacity::utilisation(const SectionForces& of) const {
  if (of.thrust == 0 && of.moment == 0) return 0;
  const auto next =
      static_cast<std::size_t>(std::ranges::upper_bound(directions_, direction(of)) - directions_.begin()) %
      diagram_.size();
  const SectionForces& a = diagram_[(next + diagram_.size() - 1) % diagram_.size()];
  const SectionForces& b = diagram_[next];
  const double thrust = b.thrust - a.thrust, moment = b.moment - a.moment;
  return (of.thrust * moment - of.moment * thrust) / (a.thrust * moment - a.moment * thrust);
}

}  // namespace adit::sections
