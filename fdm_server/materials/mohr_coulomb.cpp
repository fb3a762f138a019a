#include "fdm_server/materials/mohr_coulomb.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "fdm_server/materials/cone_return.hpp"

namespace adit::fdm {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Numbers of the planes.
enum Plane : std::size_t { kShear13, kTension1, kShear23, kShear12, kTension2, kTension3, kPlanes };
constexpr unsigned kShearPlanes = 1u << kShear13 | 1u << kShear23 | 1u << kShear12;

// Sets of one to three planes: single planes first, then edges, then corners.
constexpr auto kSets = [] {
  std::array<unsigned, 6 + 15 + 20> sets{};
  std::size_t next = 0;
  for (int size = 1; size <= 3; ++size)
    for (unsigned set = 1; set < 1u << kPlanes; ++set)
      if (std::popcount(set) == size) sets[next++] = set;
  return sets;
}();

struct Planes {
  std::array<Vector, kPlanes> normal, flow;  // flow: C m, the stress that a unit of flow takes away
  std::array<double, kPlanes> limit;         // normal . s <= limit
};

// Solves the symmetric or unsymmetric system of up to three equations; false where it is singular.
bool solve(std::size_t n, std::array<Vector, 3>& a, Vector& b) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    // The planes of a set may be dependent, as the three shear planes are without friction; such a set is
    // left out.
    if (std::abs(a[pivot][k]) <= 1e-13 * std::abs(a[0][0])) return false;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return true;
}

YieldCone cone_of(const Strength& s) {
  // between two rows the straight line of tensions may leave the cone
  return {std::sin(s.friction_angle), std::sin(s.dilation_angle), 2 * s.cohesion * std::cos(s.friction_angle),
          std::min(s.tension, apex(s.cohesion, s.friction_angle))};
}

Planes planes_of(const Elasticity& elasticity, const YieldCone& cone) {
  const double up = 1 + cone.sin_friction, down = 1 - cone.sin_friction;
  const double flow_up = 1 + cone.sin_dilation, flow_down = 1 - cone.sin_dilation;
  const double lame = elasticity.lame(), twice_shear = 2 * elasticity.shear;
  Planes planes{};
  const auto plane = [&](Plane k, double limit, const Vector& normal, const Vector& flow) {
    const double mean = lame * (flow[0] + flow[1] + flow[2]);
    planes.normal[k] = normal;
    planes.limit[k] = limit;
    for (std::size_t i = 0; i < 3; ++i) planes.flow[k][i] = mean + twice_shear * flow[i];
  };
  plane(kShear13, cone.twice_c_cos, {up, 0, -down}, {flow_up, 0, -flow_down});
  plane(kShear23, cone.twice_c_cos, {0, up, -down}, {0, flow_up, -flow_down});
  plane(kShear12, cone.twice_c_cos, {up, -down, 0}, {flow_up, -flow_down, 0});
  plane(kTension1, cone.tension, {1, 0, 0}, {1, 0, 0});
  plane(kTension2, cone.tension, {0, 1, 0}, {0, 1, 0});
  plane(kTension3, cone.tension, {0, 0, 1}, {0, 0, 1});
  return planes;
}

// Takes the predicted stress to the planes of a set; false where it does not flow so, or leaves another
// plane.
bool to_set(unsigned set, const Planes& planes, double twice_shear, double rounding, const Vector& predicted,
            Vector& stress) {
  std::array<std::size_t, 3> active{};
  std::size_t n = 0;
  bool possible = true;  // a plane that no stress ever reaches cannot be active
  for (std::size_t k = 0; k < kPlanes; ++k)
    if (set >> k & 1u) {
      active[n++] = k;
      possible = possible && std::isfinite(planes.limit[k]);
    }
  if (!possible) return false;
  std::array<Vector, 3> matrix{};
  Vector flow{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) matrix[i][j] = dot(planes.normal[active[i]], planes.flow[active[j]]);
    flow[i] = dot(planes.normal[active[i]], predicted) - planes.limit[active[i]];
  }
  if (!solve(n, matrix, flow)) return false;
  stress = predicted;
  bool admissible = true;
  for (std::size_t j = 0; j < n; ++j) {
    // A flow is a strain; twice the shear modulus makes it a stress, to which the rounding errors compare.
    admissible = admissible && flow[j] * twice_shear >= -rounding;
    for (std::size_t i = 0; i < 3; ++i) stress[i] -= flow[j] * planes.flow[active[j]][i];
  }
  for (std::size_t k = 0; k < kPlanes && admissible; ++k)
    admissible = dot(planes.normal[k], stress) - planes.limit[k] <= rounding;
  return admissible;
}

// Tries the sets of planes one after another and says what yields. Out of line: most stresses stop before.
[[gnu::noinline]] std::int64_t search_planes(const Elasticity& elasticity, const YieldCone& cone,
                                             Principal& stress) {
  const Planes planes = planes_of(elasticity, cone);
  const Vector predicted{stress.s1, stress.s2, stress.s3};
  const double scale =
      std::abs(predicted[0]) + std::abs(predicted[1]) + std::abs(predicted[2]) + cone.twice_c_cos;
  for (const unsigned set : kSets)
    if (Vector found; to_set(set, planes, 2 * elasticity.shear, 1e-12 * scale, predicted, found)) {
      stress = {found[0], found[1], found[2]};
      return (set & kShearPlanes ? kShearNow : 0u) | (set & ~kShearPlanes ? kTensionNow : 0u);
    }
  return kElastic;  // only where the stress is not finite, which the run notices
}

}  // namespace

double apex(double cohesion, double friction_angle) {
  return friction_angle > 0 ? cohesion / std::tan(friction_angle) : std::numeric_limits<double>::infinity();
}

MohrCoulomb::MohrCoulomb(std::vector<SofteningRow> rows)
    : rows_(std::move(rows)), first_(cone_of(rows_.front().strength)) {}

Strength MohrCoulomb::strength(double strain) const {
  const auto after = std::ranges::upper_bound(rows_, strain, {}, &SofteningRow::strain);
  if (after == rows_.end()) return rows_.back().strength;
  const auto& [from, a] = *(after - 1);
  const auto& [to, b] = *after;
  const double share = (strain - from) / (to - from);
  const auto between = [share](double first, double last) {
    // Equal values are returned as they are, because infinite tensions have no difference.
    return first == last ? first : first + share * (last - first);
  };
  return {between(a.cohesion, b.cohesion), between(a.friction_angle, b.friction_angle),
          between(a.dilation_angle, b.dilation_angle), between(a.tension, b.tension)};
}

YieldCone MohrCoulomb::cone(double strain) const {
  // Before any plastic strain, as in most zones, the first cone is ready and no sine is computed.
  return strain > 0 && softens() ? cone_of(strength(strain)) : first_;
}

MohrCoulomb::Return MohrCoulomb::admissible(const Elasticity& elasticity, double plastic_shear_strain,
                                            const SolidStress& predicted) const {
  const YieldCone cone = this->cone(plastic_shear_strain);
  const PointStress from = point_stress(predicted);
  const double radius = std::sqrt(from.difference * from.difference + from.shear * from.shear);
  const Principal principal = sorted(from.mean, radius, from.across);
  auto [to, yields] = to_shear_plane(cone_flow(elasticity, cone), principal);
  if (yields == kElastic) return {predicted, kElastic};
  if (yields == kOpen) yields = search_planes(elasticity, cone, to);
  return {solid_stress(turned_back(from, radius, to)), static_cast<unsigned>(yields)};
}

}  // namespace adit::fdm
