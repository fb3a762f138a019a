#include "fdm_server/materials/mohr_coulomb.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace adit::fdm {
namespace {

using Principal = std::array<double, 3>;

double dot(const Principal& a, const Principal& b) {
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
  std::array<Principal, kPlanes> normal, flow;  // flow: C m, the stress that a unit of flow takes away
  std::array<double, kPlanes> limit;            // normal . s <= limit
};

// Solves the symmetric or unsymmetric system of up to three equations; false where it is singular.
bool solve(std::size_t n, std::array<Principal, 3>& a, Principal& b) {
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

// Mostly F_13 alone, which keeps the other shear planes while the stresses keep their order.
bool to_shear_plane(const Elasticity& elasticity, const YieldCone& cone, Principal& stress) {
  const double up = 1 + cone.sin_friction, down = 1 - cone.sin_friction;
  const double flow_up = 1 + cone.sin_dilation, flow_down = 1 - cone.sin_dilation;
  const double volume = elasticity.lame() * (flow_up - flow_down), twice_shear = 2 * elasticity.shear;
  const Principal away{volume + twice_shear * flow_up, volume, volume - twice_shear * flow_down};
  const double flows =
      (up * stress[0] - down * stress[2] - cone.twice_c_cos) / (up * away[0] - down * away[2]);
  const Principal on_plane{stress[0] - flows * away[0], stress[1] - flows * away[1],
                           stress[2] - flows * away[2]};
  const bool admissible =
      flows >= 0 && on_plane[0] >= on_plane[1] && on_plane[1] >= on_plane[2] && on_plane[0] <= cone.tension;
  if (admissible) stress = on_plane;
  return admissible;
}

Planes planes_of(const Elasticity& elasticity, const YieldCone& cone) {
  const double up = 1 + cone.sin_friction, down = 1 - cone.sin_friction;
  const double flow_up = 1 + cone.sin_dilation, flow_down = 1 - cone.sin_dilation;
  const double lame = elasticity.lame(), twice_shear = 2 * elasticity.shear;
  Planes planes{};
  const auto plane = [&](Plane k, double limit, const Principal& normal, const Principal& flow) {
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
bool to_set(unsigned set, const Planes& planes, double twice_shear, double rounding,
            const Principal& predicted, Principal& stress) {
  std::array<std::size_t, 3> active{};
  std::size_t n = 0;
  bool possible = true;  // a plane that no stress ever reaches cannot be active
  for (std::size_t k = 0; k < kPlanes; ++k)
    if (set >> k & 1u) {
      active[n++] = k;
      possible = possible && std::isfinite(planes.limit[k]);
    }
  if (!possible) return false;
  std::array<Principal, 3> matrix{};
  Principal flow{};
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
[[gnu::noinline]] unsigned search_planes(const Elasticity& elasticity, const YieldCone& cone,
                                         Principal& stress) {
  const Planes planes = planes_of(elasticity, cone);
  const Principal predicted = stress;
  const double scale =
      std::abs(predicted[0]) + std::abs(predicted[1]) + std::abs(predicted[2]) + cone.twice_c_cos;
  for (const unsigned set : kSets)
    if (Principal found; to_set(set, planes, 2 * elasticity.shear, 1e-12 * scale, predicted, found)) {
      stress = found;
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

MohrCoulomb::Return MohrCoulomb::admissible(const Elasticity& elasticity, double plastic_shear_strain,
                                            const SolidStress& predicted) const {
  // Before any plastic strain, as in most zones, the first cone is ready and no sine is computed.
  const YieldCone cone =
      plastic_shear_strain > 0 && rows_.size() > 1 ? cone_of(strength(plastic_shear_strain)) : first_;
  const double p = (predicted.xx + predicted.yy) / 2, t = (predicted.xx - predicted.yy) / 2;
  const double radius = std::sqrt(t * t + predicted.xy * predicted.xy);
  const double largest = std::max(p + radius, predicted.zz), smallest = std::min(p - radius, predicted.zz);
  const bool within = largest - smallest + (largest + smallest) * cone.sin_friction <= cone.twice_c_cos &&
                      largest <= cone.tension;
  if (within) return {predicted, kElastic};

  // the principal stresses: in the plane p + radius and p - radius, across it zz; sorted, largest first
  Principal sorted{p + radius, p - radius, predicted.zz};
  std::size_t in_plane[2] = {0, 1}, across = 2;
  if (predicted.zz > p - radius) {
    std::swap(sorted[1], sorted[2]);
    std::swap(in_plane[1], across);
    if (predicted.zz > p + radius) {
      std::swap(sorted[0], sorted[1]);
      std::swap(in_plane[0], across);
    }
  }
  const unsigned yields =
      to_shear_plane(elasticity, cone, sorted) ? kShearNow : search_planes(elasticity, cone, sorted);
  const double a = sorted[in_plane[0]], b = sorted[in_plane[1]];
  // The principal directions stay, so t and xy shrink in the same ratio as the circle's radius.
  const double new_p = (a + b) / 2, ratio = radius > 0 ? (a - b) / 2 / radius : 0;
  return {{new_p + ratio * t, new_p - ratio * t, sorted[across], ratio * predicted.xy}, yields};
}

}  // namespace adit::fdm
