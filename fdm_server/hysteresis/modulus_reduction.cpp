#include "fdm_server/hysteresis/modulus_reduction.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {
namespace {

// Slopes at the points of a monotone cubic: the harmonic means of its neighbours' chords, 0 at a turn. The
// nearer chord has the larger weight (Fritsch and Butland 1984).
std::vector<double> monotone_slopes(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  std::vector<double> chord(n - 1), slope(n);
  for (std::size_t k = 0; k + 1 < n; ++k) chord[k] = (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
  slope.front() = chord.front();
  slope.back() = chord.back();
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double before = x[k] - x[k - 1], after = x[k + 1] - x[k];
    const double w1 = before + 2 * after, w2 = 2 * before + after;
    slope[k] = chord[k - 1] * chord[k] > 0 ? (w1 + w2) / (w1 / chord[k - 1] + w2 / chord[k]) : 0;
  }
  return slope;
}

// Removes the vertices that lie below the line between their neighbours.
std::vector<BackbonePoint> concave_hull(const std::vector<BackbonePoint>& points) {
  std::vector<BackbonePoint> hull{{0, 0}};
  for (const auto& point : points) {
    const auto below = [&] {
      const auto& a = hull[hull.size() - 2];
      const auto& b = hull.back();
      return (b.stress - a.stress) * (point.strain - a.strain) <=
             (point.stress - a.stress) * (b.strain - a.strain);
    };
    if (point.stress <= hull.back().stress) continue;  // a backbone rises
    while (hull.size() > 1 && below()) hull.pop_back();
    hull.push_back(point);
  }
  hull.erase(hull.begin());
  return hull;
}

}  // namespace

ModulusReduction hyperbola(double reference_strain, double exponent) {
  return [=](double strain) { return 1 / (1 + std::pow(strain / reference_strain, exponent)); };
}

std::function<double(double)> smooth_table(std::span<const double> strains, std::span<const double> values) {
  std::vector<double> x, y(values.begin(), values.end());
  // Measured curves are given and drawn over the logarithm of the strain, which spans several decades.
  for (const double strain : strains) x.push_back(std::log(strain));
  const auto slope = monotone_slopes(x, y);
  return [x, y, slope](double strain) {
    const double at = std::log(strain);
    if (at <= x.front()) return y.front();
    if (at >= x.back()) return y.back();
    const auto k = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin()) - 1;
    const double h = x[k + 1] - x[k], s = (at - x[k]) / h, r = 1 - s;
    return (1 + 2 * s) * r * r * y[k] + s * s * (3 - 2 * s) * y[k + 1] +
           h * s * r * (r * slope[k] - s * slope[k + 1]);
  };
}

std::function<double(double)> darendeli_share(const ModulusReduction& reduction, double cycles) {
  const double most = 0.6329 - 0.0057 * std::log(cycles);
  return [=](double strain) { return most * std::pow(reduction(strain), 0.1); };
}

std::vector<BackbonePoint> backbone(const ModulusReduction& reduction, double first_strain,
                                    double last_strain, std::size_t elements) {
  const double ratio = std::log(last_strain / first_strain) / static_cast<double>(elements - 1);
  std::vector<BackbonePoint> points;
  for (std::size_t k = 0; k < elements; ++k) {
    const double strain = first_strain * std::exp(ratio * static_cast<double>(k));
    points.push_back({strain, strain * (k == 0 ? 1 : reduction(strain))});
  }
  return concave_hull(points);
}

}  // namespace adit::fdm
