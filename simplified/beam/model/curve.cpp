#include "simplified/beam/model/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "protocol/errors.hpp"

namespace adit::simplified::beam {
Piece Curve::piece(double e) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::size_t k = 0;  // number of the point at the end of the piece
  while (k < points.size() && points[k].elongation <= e) ++k;
  if (k == 0) return {-kInfinity, points[0].elongation, points[0].elongation, points[0].force, slope_before};
  const CurvePoint& a = points[k - 1];
  if (k == points.size()) return {a.elongation, kInfinity, a.elongation, a.force, slope_after};
  const CurvePoint& b = points[k];
  return {a.elongation, b.elongation, a.elongation, a.force,
          (b.force - a.force) / (b.elongation - a.elongation)};
}

double Curve::work(double e0, double e1) const {
  return mean(e0, e1).force * (e1 - e0);
}

SpringAnswer Curve::mean(double e0, double e1) const {
  // The mean does not depend on the direction, so the pieces are always passed upwards.
  const auto [low, high] = std::minmax(e0, e1);
  Piece here = piece(low);
  if (here.holds(high)) return here.mean(e0, e1);
  double area = 0, begin = low;  // sum of the trapezoids, piece by piece
  for (;; here = piece(here.high)) {
    const double end = std::min(here.high, high);
    area += here.at(0.5 * (begin + end)) * (end - begin);
    if (here.holds(high)) break;
    begin = end;
  }
  // The mean is W/(e1 - e0), so its derivative by e1 is (f(e1) - mean)/(e1 - e0).
  const double mean_force = area / (high - low);
  return {mean_force, (force(e1) - mean_force) / (e1 - e0)};
}

Curve linear(double stiffness) {
  return {{{0, 0}}, stiffness, stiffness};
}

Curve cable(double stiffness, double slack) {
  return {{{slack, 0}}, 0, stiffness};
}

Curve key(double stiffness, double clearance) {
  if (clearance == 0) return linear(stiffness);
  return {{{-clearance, 0}, {clearance, 0}}, stiffness, stiffness};
}

Curve gasket(const std::vector<CurvePoint>& compression, double pre_compression) {
  const double installed = compression_under(compression, pre_compression);
  Curve curve;
  // Compression counts the other way from elongation, so the points are taken from the last to the first.
  for (auto point = compression.rbegin(); point != compression.rend(); ++point)
    curve.points.push_back({installed - point->elongation, pre_compression - point->force});
  const CurvePoint &a = compression[compression.size() - 2], &b = compression.back();
  curve.slope_before = (b.force - a.force) / (b.elongation - a.elongation);
  return curve;
}

double compression_under(const std::vector<CurvePoint>& compression, double force) {
  std::size_t k = 1;
  while (k + 1 < compression.size() && compression[k].force < force) ++k;
  const CurvePoint &a = compression[k - 1], &b = compression[k];
  return a.elongation + (force - a.force) * (b.elongation - a.elongation) / (b.force - a.force);
}

void check(const Curve& curve, const std::string& path) {
  if (curve.points.empty())
    throw protocol::UserError(path, "the force curve has no point: give at least one (elongation, force)");
  for (const double end_slope : {curve.slope_before, curve.slope_after})
    if (!(end_slope >= 0) || !std::isfinite(end_slope))
      throw protocol::UserError(
          path, fmt::format("a curve's stiffness must not be negative, got {:g} N/m", end_slope));
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const CurvePoint& point = curve.points[i];
    const std::string here = fmt::format("{}[{}]", path, i);
    if (!std::isfinite(point.elongation) || !std::isfinite(point.force))
      throw protocol::UserError(here, "a curve's point must be finite");
    if (i == 0) continue;
    const CurvePoint& previous = curve.points[i - 1];
    if (point.elongation <= previous.elongation || point.force < previous.force)
      throw protocol::UserError(
          here, fmt::format("the joint curve is not monotone: ({:g} m, {:g}) follows ({:g} m, {:g}); "
                            "displacements must increase and forces must not decrease",
                            point.elongation, point.force, previous.elongation, previous.force));
  }
}

void check_load_curve(const std::vector<CurvePoint>& compression, const std::string& path) {
  check(Curve{compression, 0, 0}, path);
  if (compression.size() < 2 || compression[0].elongation != 0 || compression[0].force != 0)
    throw protocol::UserError(
        path + "[0]", "a gasket's load curve must start at (0 m, 0 N/m) and have at least two points");
  for (std::size_t i = 1; i < compression.size(); ++i)
    // Where the force is constant, no single compression belongs to it, and compression_under() has no
    // answer.
    if (compression[i].force == compression[i - 1].force)
      throw protocol::UserError(
          fmt::format("{}[{}]", path, i),
          fmt::format(
              "the joint curve is not monotone: the gasket's force stays at {:g} N/m from {:g} m to {:g} m; "
              "it must rise with compression",
              compression[i].force, compression[i - 1].elongation, compression[i].elongation));
}

}  // namespace adit::simplified::beam
