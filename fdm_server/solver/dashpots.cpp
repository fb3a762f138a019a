#include "fdm_server/solver/dashpots.hpp"

#include <utility>

namespace adit::fdm {

Vector operator*(const Symmetric& c, const Vector& v) {
  return {c.xx * v.x + c.xy * v.y, c.xy * v.x + c.yy * v.y};
}

Symmetric of_ground(const Dashpot& dashpot) {
  const Symmetric& all = dashpot.damping;
  if (!dashpot.field) return all;
  const Symmetric& link = dashpot.field->damping;
  return {all.xx - link.xx, all.xy - link.xy, all.yy - link.yy};
}

namespace {

Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y};
}

Vector operator*(double factor, const Vector& v) {
  return {factor * v.x, factor * v.y};
}

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}

Vector velocity(const PointArrays& points, std::uint32_t i) {
  return {points.vx[i], points.vy[i]};
}

Vector displacement(const PointArrays& points, std::uint32_t i) {
  return {points.ux[i], points.uy[i]};
}

void add(const PointArrays& points, std::uint32_t i, const Vector& force) {
  points.fx[i] += force.x;
  points.fy[i] += force.y;
}

// Of the multipliers, as they were last.
Vector tie(const PointArrays& points, std::uint32_t i) {
  return points.tie_x ? Vector{points.tie_x[i], points.tie_y[i]} : Vector{};
}

// (v(n-1/2) + v(n+1/2))/2 under the forces that the point has so far.
Vector mean_velocity(const PointArrays& points, std::uint32_t i, double kick) {
  const Vector force = Vector{points.fx[i], points.fy[i]} + tie(points, i);
  return {points.vx[i] + kick / 2 * points.inverse_mass_x[i] * force.x,
          points.vy[i] + kick / 2 * points.inverse_mass_y[i] * force.y};
}

// The dashpots' force F of the header's equation.
Vector drag(const Dashpot& dashpot, const PointArrays& points, double kick) {
  const Symmetric& c = dashpot.damping;
  const Vector pull = c * mean_velocity(points, dashpot.point, kick);
  const double wx = kick / 2 * points.inverse_mass_x[dashpot.point];
  const double wy = kick / 2 * points.inverse_mass_y[dashpot.point];
  const double xx = 1 + c.xx * wx, xy = c.xy * wy, yx = c.xy * wx, yy = 1 + c.yy * wy;
  const double determinant = xx * yy - xy * yx;
  return {-(yy * pull.x - xy * pull.y) / determinant, -(xx * pull.y - yx * pull.x) / determinant};
}

Vector stress_force(const FreeFieldLink& link, const ZoneSet& zones) {
  Vector force;
  for (std::size_t k = 0; k < link.zones.size(); ++k) {
    if (link.lengths[k] == 0) continue;
    const Stress stress = zones.stress(link.zones[k]);
    force = force + Vector{stress.xx * link.lengths[k], stress.xy * link.lengths[k]};
  }
  return force;
}

// Takes the elements to this step, and returns the sum of their forces.
double advance(Elements& elements, const MaxwellStep& maxwell, double growth) {
  double sum = 0;
  for (std::size_t e = 0; e < kMostElements; ++e) sum += elements[e] = maxwell(e, elements[e], growth);
  return sum;
}

Vector free_field_force(Dashpot& dashpot, const MaxwellStep& maxwell, const protocol::Step& step,
                        const ZoneSet& zones, const PointArrays& points) {
  const FreeFieldLink& link = *dashpot.field;
  const Vector before = std::exchange(dashpot.stress, stress_force(link, zones));
  const Vector viscous{advance(dashpot.viscous_x, maxwell, dashpot.stress.x - before.x),
                       advance(dashpot.viscous_y, maxwell, dashpot.stress.y - before.y)};
  if (step.from_rest()) return dashpot.stress;
  return dashpot.stress + viscous + link.damping * mean_velocity(points, link.column_point, step.kick());
}

// In statics: the components that are held take no part.
void hold(const Dashpot& dashpot, const PointArrays& points) {
  if (dashpot.hold_x) points.fx[dashpot.point] = 0;
  if (dashpot.hold_y) points.fy[dashpot.point] = 0;
}

}  // namespace

Symmetric& Symmetric::operator+=(const Symmetric& other) {
  xx += other.xx;
  xy += other.xy;
  yy += other.yy;
  return *this;
}

void add(Dashpot& dashpot, const DashpotShare& share) {
  dashpot.shares.push_back(share);
  dashpot.damping += share.damping;
  dashpot.spring += share.spring;
  dashpot.hold_x = dashpot.hold_x || share.hold_x;
  dashpot.hold_y = dashpot.hold_y || share.hold_y;
}

void leave_out(const std::vector<bool>& gone, std::span<Dashpot> dashpots) {
  for (Dashpot& dashpot : dashpots) {
    const auto shares = std::exchange(dashpot.shares, {});
    dashpot.damping = dashpot.spring = {};
    dashpot.hold_x = dashpot.hold_y = false;
    for (const DashpotShare& share : shares)
      if (!gone[share.zone]) add(dashpot, share);
  }
}

void add_boundary_forces(std::span<Dashpot> dashpots, bool supports, const DampingLaw& damping,
                         const protocol::Step& step, const ZoneSet& zones, const PointArrays& points,
                         BoundaryWork& work) {
  const MaxwellStep maxwell(damping, step);
  for (Dashpot& dashpot : dashpots) {
    const Vector given_before = dashpot.given, drag_before = dashpot.drag;
    const Vector field = dashpot.field ? free_field_force(dashpot, maxwell, step, zones, points) : Vector{};
    const std::uint32_t i = dashpot.point;
    if (step.number == 0 && !step.relax) dashpot.origin = displacement(points, i);
    if (step.number == 0 && supports && !step.relax) {
      const Vector multipliers = tie(points, i);
      dashpot.support = {dashpot.settling.x - points.fx[i] - field.x - multipliers.x,
                         dashpot.settling.y - points.fy[i] - field.y - multipliers.y};
    }
    const Vector away = step.relax ? Vector{} : displacement(points, i) + -1.0 * dashpot.origin;
    dashpot.given = dashpot.support + field + -1.0 * (dashpot.spring * away);
    add(points, i, dashpot.given);
    dashpot.drag = step.from_rest() ? Vector{} : drag(dashpot, points, step.kick());
    add(points, i, dashpot.drag);
    if (step.relax) hold(dashpot, points);
    if (step.from_rest()) continue;
    const Vector v = velocity(points, i);
    work.external += step.dt / 2 * dot(v, given_before + dashpot.given);
    work.dissipated -= step.dt / 2 * dot(v, drag_before + dashpot.drag);
  }
}

}  // namespace adit::fdm
