#include "dem_server/observe/circles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace adit::dem {
namespace {

double square(double x) {
  return x * x;
}

// w of a point at this distance squared.
double weight_at(const Circle& circle, double squared) {
  const double area = std::numbers::pi * square(circle.radius);
  return 3 / area * square(std::max(0.0, 1 - squared / square(circle.radius)));
}

double weight_at(const Circle& circle, double x, double y) {
  return weight_at(circle, square(x - circle.x) + square(y - circle.y));
}

// Mean of w along a branch: of fourth degree between its entry and its exit, so that three points of Gauss
// are exact.
double weight_along(const Circle& circle, const Branch& b) {
  const double x = b.x_1 - circle.x, y = b.y_1 - circle.y, lx = b.x_2 - b.x_1, ly = b.y_2 - b.y_1;
  const double ll = lx * lx + ly * ly, xl = x * lx + y * ly, xx = x * x + y * y;
  // |x + s l|^2 = R^2
  const double inside = square(xl) - ll * (xx - square(circle.radius));
  if (!(inside > 0)) return 0;
  const double begin = std::clamp((-xl - std::sqrt(inside)) / ll, 0.0, 1.0),
               end = std::clamp((-xl + std::sqrt(inside)) / ll, 0.0, 1.0);
  const double middle = (begin + end) / 2, half = (end - begin) / 2, away = std::sqrt(0.6) * half;
  const auto at = [&](double s) { return weight_at(circle, xx + 2 * s * xl + s * s * ll); };
  return half / 9 * (5 * at(middle - away) + 8 * at(middle) + 5 * at(middle + away));
}

// Area that two circles share, their middles being so far apart.
double shared_area(double a, double b, double distance) {
  if (distance >= a + b) return 0;
  if (distance <= std::abs(a - b)) return std::numbers::pi * square(std::min(a, b));
  const auto segment = [](double radius, double to_chord) {
    const double half_angle = std::acos(std::clamp(to_chord / radius, -1.0, 1.0));
    return square(radius) * half_angle - to_chord * radius * std::sin(half_angle);
  };
  const double to_chord = (square(distance) + square(a) - square(b)) / (2 * distance);
  return segment(a, to_chord) + segment(b, distance - to_chord);
}

}  // namespace

Tensor mean_stress(const Circle& circle, std::span<const Branch> branches) {
  Tensor sum{};
  for (const Branch& b : branches) {
    const double w = weight_along(circle, b), lx = b.x_2 - b.x_1, ly = b.y_2 - b.y_1;
    sum.xx += w * b.fx * lx;
    sum.yy += w * b.fy * ly;
    sum.xy += w * (b.fx * ly + b.fy * lx) / 2;
  }
  return sum;
}

std::optional<Tensor> mean_strain_rate(const Circle& circle, std::span<const double> x,
                                       std::span<const double> y, std::span<const double> vx,
                                       std::span<const double> vy) {
  const double r = circle.radius;
  // Moments of places over the radius, and of velocities with them, about the weighed mean.
  double total = 0;
  std::array<double, 4> mean{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double w = weight_at(circle, x[i], y[i]);
    const std::array values{(x[i] - circle.x) / r, (y[i] - circle.y) / r, vx[i], vy[i]};
    total += w;
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += w * values[k];
  }
  if (!(total > 0)) return std::nullopt;
  for (double& m : mean) m /= total;
  double xx = 0, xy = 0, yy = 0, xu = 0, yu = 0, xv = 0, yv = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double w = weight_at(circle, x[i], y[i]) / total;
    const double dx = (x[i] - circle.x) / r - mean[0], dy = (y[i] - circle.y) / r - mean[1];
    const double du = vx[i] - mean[2], dv = vy[i] - mean[3];
    xx += w * dx * dx, xy += w * dx * dy, yy += w * dy * dy;
    xu += w * dx * du, yu += w * dy * du, xv += w * dx * dv, yv += w * dy * dv;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * square(xx + yy))) return std::nullopt;
  const auto solve = [&](double a, double b) {
    return std::pair((yy * a - xy * b) / determinant / r, (xx * b - xy * a) / determinant / r);
  };
  const auto [u_x, u_y] = solve(xu, yu);
  const auto [v_x, v_y] = solve(xv, yv);
  return Tensor{u_x, v_y, (u_y + v_x) / 2};
}

double porosity(const Circle& circle, std::span<const double> x, std::span<const double> y,
                std::span<const double> radius) {
  double covered = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    covered += shared_area(circle.radius, radius[i], std::hypot(x[i] - circle.x, y[i] - circle.y));
  return 1 - covered / (std::numbers::pi * square(circle.radius));
}

double mean_coordination(const Circle& circle, std::span<const double> x, std::span<const double> y,
                         std::span<const std::uint32_t> coordination) {
  double total = 0, sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double w = weight_at(circle, x[i], y[i]);
    total += w;
    sum += w * coordination[i];
  }
  return total > 0 ? sum / total : 0;
}

}  // namespace adit::dem
