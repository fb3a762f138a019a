#include "simplified/beam/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"

namespace adit::simplified::beam {
namespace {

// Piece k lies between points k−1 and k; piece 0 before the first point, piece size() after the last.
std::size_t piece_of(const std::vector<CurvePoint>& points, double e) {
  std::size_t k = 0;
  while (k < points.size() && points[k].elongation <= e) ++k;
  return k;
}

double slope(const Curve& curve, std::size_t piece) {
  if (piece == 0) return curve.slope_before;
  if (piece == curve.points.size()) return curve.slope_after;
  const CurvePoint &a = curve.points[piece - 1], &b = curve.points[piece];
  return (b.force - a.force) / (b.elongation - a.elongation);
}

double on_piece(const Curve& curve, std::size_t piece, double e) {
  const CurvePoint& anchor = curve.points[piece == 0 ? 0 : piece - 1];
  return anchor.force + slope(curve, piece) * (e - anchor.elongation);
}

}  // namespace

double Curve::force(double e) const {
  return on_piece(*this, piece_of(points, e), e);
}

double Curve::tangent(double e) const {
  return slope(*this, piece_of(points, e));
}

double Curve::work(double e0, double e1) const {
  return mean(e0, e1).force * (e1 - e0);
}

SpringAnswer Curve::mean(double e0, double e1) const {
  const auto [low, high] = std::minmax(e0, e1);
  const std::size_t first = piece_of(points, low), last = piece_of(points, high);
  if (first == last) return {on_piece(*this, first, 0.5 * (e0 + e1)), 0.5 * slope(*this, first)};
  double area = 0;  // trapezoids, piece by piece
  for (std::size_t k = first; k <= last; ++k) {
    const double a = k == first ? low : points[k - 1].elongation;
    const double b = k == last ? high : points[k].elongation;
    area += on_piece(*this, k, 0.5 * (a + b)) * (b - a);
  }
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
    if (compression[i].force == compression[i - 1].force)
      throw protocol::UserError(
          fmt::format("{}[{}]", path, i),
          fmt::format(
              "the joint curve is not monotone: the gasket's force stays at {:g} N/m from {:g} m to {:g} m; "
              "it must rise with compression",
              compression[i].force, compression[i - 1].elongation, compression[i].elongation));
}

}  // namespace adit::simplified::beam
