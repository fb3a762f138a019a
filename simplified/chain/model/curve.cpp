#include "simplified/chain/model/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"

namespace adit::simplified::chain {
namespace {

using protocol::UserError;

void check_finite(const std::vector<double>& values, const std::string& path) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw UserError(fmt::format("{}[{}]", path, i), fmt::format("{} is not a finite number", values[i]));
}

}  // namespace

void check(const Curve& curve, const std::string& path) {
  const auto& d = curve.deformation;
  const auto& f = curve.force;
  if (d.size() < 2)
    throw UserError(path + ".deformation",
                    fmt::format("holds {} value(s): a curve needs 2 or more", d.size()));
  if (f.size() != d.size())
    throw UserError(path + ".force", fmt::format("holds {} value(s) for {} deformations: give one for each",
                                                 f.size(), d.size()));
  check_finite(d, path + ".deformation");
  check_finite(f, path + ".force");
  for (std::size_t i = 1; i < d.size(); ++i) {
    if (!(d[i] > d[i - 1]))
      throw UserError(
          fmt::format("{}.deformation[{}]", path, i),
          fmt::format("{} does not exceed the {} before it: deformations must increase", d[i], d[i - 1]));
    // A falling piece would be a negative stiffness, with which the matrices of the Riccati sweep are no
    // longer positive definite.
    if (f[i] < f[i - 1])
      throw UserError(
          fmt::format("{}.force[{}]", path, i),
          fmt::format("{} is less than the {} before it: forces must not decrease with deformation "
                      "(tension is positive)",
                      f[i], f[i - 1]));
  }
}

Line line_at(const Curve& curve, double deformation) {
  const auto& d = curve.deformation;
  // The line's end point; before the second and after the last point the first and last lines go on.
  const auto end = std::upper_bound(d.begin() + 1, d.end() - 1, deformation) - d.begin();
  const double slope = (curve.force[end] - curve.force[end - 1]) / (d[end] - d[end - 1]);
  return {slope, curve.force[end] - slope * d[end]};
}

}  // namespace adit::simplified::chain
