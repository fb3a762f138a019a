// Writes what the hysteretic laws make of a modulus-reduction curve, as CSV: the curve, the amplitude of the
// shear strain, G/Gmax of the curve and of the law's loops, damping ratio by Masing's rules from the curve,
// or the given one where that is less, and of the loops.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "fdm_server/hysteresis/reversals.hpp"
#include "tests/support/hysteretic_zone.hpp"

namespace {

using namespace adit::fdm;

// Secant modulus over the initial one and damping ratio of the second loop between -strain and +strain.
std::pair<double, double> loop(const IwanElements& elements, double strain) {
  constexpr int kSteps = 4000;  // of half a loop
  test::HystereticZone zone({3, 1}, elements);
  double at = 0, lost = 0, peak = 0;
  const auto go = [&](double goal) {
    const double step = (goal - at) / kSteps;
    for (int i = 0; i < kSteps; ++i) lost += zone.add({0, 0, 0, step});
    at = goal;
  };
  for (const double goal : {strain, -strain}) go(goal);
  lost = 0;
  go(strain);
  peak = zone.stress().xy;
  go(-strain);
  return {peak / strain, lost / (2 * std::numbers::pi * peak * strain)};
}

// The same of a memory of reversals.
std::pair<double, double> loop(const Polyline& line, double strain) {
  constexpr int kSteps = 4000;
  constexpr ZoneStrain kWeights{0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.75};
  ZoneMemory memory;
  double at = 0, lost = 0, stress = 0;
  const auto go = [&](double goal) {
    const double s = (goal - at) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const auto grown = advance(line.view(), kWeights, {0, 0, 0, 0, s, s, s, s, 0}, memory);
      stress += grown.stress[4];
      lost += grown.dissipated;
    }
    at = goal;
  };
  for (const double goal : {strain, -strain}) go(goal);
  lost = 0;
  go(strain);
  const double peak = stress;
  go(-strain);
  return {peak / strain, lost / (2 * std::numbers::pi * peak * strain)};
}

// By Masing's rules, from the area under the curve itself (trapezoids over the logarithm of the strain).
double masing(const ModulusReduction& curve, double strain) {
  constexpr int kParts = 20000;
  double area = 0, last = 0, from = 0;
  for (int i = 0; i <= kParts; ++i) {
    const double x = strain * std::pow(1e-5, 1 - static_cast<double>(i) / kParts), tau = x * curve(x);
    area += (x - from) * (tau + last) / 2;
    from = x;
    last = tau;
  }
  return 2 / std::numbers::pi * (2 * area / (strain * last) - 1);
}

}  // namespace

int main() {
  struct Curve {
    const char* name;
    ModulusReduction reduction;
    double first, last;
  };
  const std::vector<double> strain{1e-6, 3.16e-6, 1e-5, 3.16e-5, 1e-4, 3.16e-4, 1e-3, 3.16e-3, 1e-2};
  const std::vector<double> sand{1, 0.99, 0.96, 0.88, 0.72, 0.49, 0.27, 0.13, 0.061};
  const Curve curves[] = {
      {"hyperbola 5e-4", hyperbola(5e-4, 1), 1e-6, 5e-3},
      {"Darendeli 1e-3 ^0.919", hyperbola(1e-3, 0.919), 1e-3 * std::pow(2e-3, 1 / 0.919), 1e-2},
      {"table", smooth_table(strain, sand), strain.front(), strain.back()}};
  std::puts("curve,strain,ratio,law_ratio,damping,law_damping");
  for (const auto& [name, reduction, first, last] : curves) {
    const IwanElements elements = iwan_elements(backbone(reduction, first, last, 60));
    for (double x = 3e-6; x <= last; x *= 1.05) {
      const auto [ratio, damping] = loop(elements, x);
      std::printf("%s,%.6g,%.6g,%.6g,%.6g,%.6g\n", name, x, reduction(x), ratio, masing(reduction, x),
                  damping);
    }
  }
  // Loops that are narrower at large strains.
  const std::vector<double> damping{0.006, 0.008, 0.012, 0.018, 0.032, 0.062, 0.115, 0.18, 0.235};
  const auto& sand_curve = curves[2];
  const auto given = smooth_table(strain, damping);
  Polyline narrow(backbone(sand_curve.reduction, sand_curve.first, sand_curve.last, 60));
  const Polyline wide = narrow;
  narrow.narrow([&](double x) { return std::min(1.0, given(x) / wide.masing_damping(x)); }, "");
  for (double x = 3e-6; x <= sand_curve.last; x *= 1.05) {
    const auto [ratio, of_loop] = loop(narrow, x);
    std::printf("table with damping,%.6g,%.6g,%.6g,%.6g,%.6g\n", x, sand_curve.reduction(x), ratio,
                std::min(given(x), masing(sand_curve.reduction, x)), of_loop);
  }
}
