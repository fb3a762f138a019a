#include "dem_server/model/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace adit::dem {
namespace {

constexpr double kTolerance = 1e-6;  // of a radius

std::array<double, 2> between_centres(const Model& model, const Bond& bond) {
  const auto& [x, y, radius] = model.discs;
  return {x[bond.second] - x[bond.first], y[bond.second] - y[bond.first]};
}

Direction nearest_direction(const Model& model, const Bond& bond) {
  const auto [dx, dy] = between_centres(model, bond);
  if (std::abs(dy) < model.discs.radius[bond.first] / 2) return Direction::kAlongRow;
  return dx > 0 ? Direction::kUpRight : Direction::kUpLeft;
}

std::optional<std::string> why_laws_differ(const Model& model) {
  for (const Bond& bond : model.bonds) {
    if (bond.law == Bond::Law::kParallelBond) return "parallel bonds join particles";
    if (bond.law == Bond::Law::kSmoothJoint) return "smooth joints join particles";
    ContactBond law = model.contact_bonds[bond.number],
                first = model.contact_bonds[model.bonds.front().number];
    law.factors = first.factors;  // rows may differ by factors
    if (law != first) return "bonds have different stiffnesses or strengths";
  }
  return std::nullopt;
}

}  // namespace

std::array<double, 2> rest_vector(Direction direction, double radius) {
  switch (direction) {
    case Direction::kAlongRow:
      return {2 * radius, 0};
    case Direction::kUpRight:
      return {radius, std::numbers::sqrt3 * radius};
    case Direction::kUpLeft:
      return {-radius, std::numbers::sqrt3 * radius};
  }
  return {0, 0};
}

std::optional<Direction> direction_of(const Model& model, const Bond& bond) {
  const double radius = model.discs.radius[bond.first];
  const Direction nearest = nearest_direction(model, bond);
  const auto [dx, dy] = between_centres(model, bond);
  const auto [x, y] = rest_vector(nearest, radius);
  if (!(std::hypot(dx - x, dy - y) <= kTolerance * radius)) return std::nullopt;
  return nearest;
}

void sort_by_rows(Model& model) {
  std::ranges::sort(model.bonds, {}, [&](const Bond& bond) {
    return std::tuple(model.discs.y[bond.first], nearest_direction(model, bond), bond.first);
  });
}

std::optional<std::string> why_no_lattice(const Model& model) {
  const auto& radius = model.discs.radius;
  if (model.bonds.empty()) return "no bond joins particles";
  if (!model.facets.empty()) return "facets join cells";
  if (std::ranges::any_of(radius, [&](double r) { return r != radius.front(); }))
    return "the particles differ in size";
  if (const auto differ = why_laws_differ(model)) return differ;
  if (!model.overlaps_free) return "particles may start under the force of their overlaps";
  if (std::ranges::any_of(model.bonds, [&](const Bond& bond) { return !direction_of(model, bond); }))
    return "the particles are not packed hexagonally";
  if (pairs_within(model.discs, kTolerance * radius.front()).size() > model.bonds.size())
    return "particles touch that no bond joins";
  return std::nullopt;
}

std::optional<std::string> why_more_than_lattice(const Model& model) {
  if (!model.stages.empty() || !model.present.empty()) return "its particles change by stages";
  if (const auto reason = why_no_lattice(model)) return reason;
  const double stiffness = model.contact_bonds[model.bonds.front().number].stiffness.normal;
  for (const LinearContact& contact : model.contacts) {
    if (contact.friction > 0) return "friction is asked for";
    if (contact.normal_damping > 0 || contact.shear_damping > 0) return "contacts have dashpots";
    if (contact.normal_stiffness != stiffness) return "contacts have another stiffness than bonds";
  }
  if (!model.walls.empty()) return "there are walls";
  if (!model.springs.empty()) return "there are springs or bolts";
  if (!model.bars.empty()) return "there are bars";
  if (!model.edges.empty()) return "there are quiet edges";
  if (!model.foundations.empty()) return "there is a foundation";
  if (model.local_damping > 0 || model.viscous_damping > 0) return "damping is asked for";
  return std::nullopt;
}

}  // namespace adit::dem
