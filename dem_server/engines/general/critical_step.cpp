#include "dem_server/engines/general/critical_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "dem_server/model/bond_springs.hpp"

namespace adit::dem {
namespace {

struct Element {
  const char* kind;
  std::uint32_t first, second;
  double kn, ks, km, arm_1, arm_2;
  double k() const { return std::max(kn, ks); }
  double turning_1() const { return ks * arm_1 * arm_1 + km; }
  double turning_2() const { return ks * arm_2 * arm_2 + km; }
};

// Sums of k and r over a disc's elements, over its mass and inertia once all are known.
struct Share {
  std::vector<double> stretch, turn;
};

Element element_of(const Model& model, const Bond& bond) {
  const std::uint32_t i = bond.first, j = bond.second;
  const double length = std::hypot(model.discs.x[j] - model.discs.x[i], model.discs.y[j] - model.discs.y[i]);
  const double arm_1 = (length + model.discs.radius[i] - model.discs.radius[j]) / 2;
  const BondSprings springs = stiffest_springs(model, bond);
  const char* kind = bond.law == Bond::Law::kSmoothJoint ? "joint" : "bond";
  return {kind, i, j, springs.kn, springs.ks, springs.km, arm_1, length - arm_1};
}

// One of a fixed direction also turns the discs.
Element element_of(const Model& model, const Spring& spring) {
  const std::uint32_t i = spring.first, j = spring.second;
  if (!spring.direction) return {"spring", i, j, spring.stiffness, 0, 0, 0, 0};
  const double length = std::hypot(model.discs.x[j] - model.discs.x[i], model.discs.y[j] - model.discs.y[i]);
  const double arm_1 = (length + model.discs.radius[i] - model.discs.radius[j]) / 2;
  return {"spring", i, j, spring.stiffness, spring.stiffness, 0, arm_1, length - arm_1};
}

std::uint32_t most_neighbours(double radius, double smallest) {
  return static_cast<std::uint32_t>(std::numbers::pi / std::asin(smallest / (radius + smallest)) + 1e-9);
}

double over(double a, double b) {
  return b > 0 ? a / b : 0;
}

// omega^2 of an element with its shares.
double highest(const Element& e, const Share& share) {
  const double by_mass = over(share.stretch[e.first] + share.stretch[e.second], e.k());
  const double turn_1 = over(share.turn[e.first], e.turning_1()),
               turn_2 = over(share.turn[e.second], e.turning_2());
  const double slip = e.ks * (by_mass + e.arm_1 * e.arm_1 * turn_1 + e.arm_2 * e.arm_2 * turn_2);
  const double turn = e.km * (turn_1 + turn_2);
  const double cross = std::sqrt(e.ks * e.km) * (e.arm_1 * turn_1 - e.arm_2 * turn_2);
  return std::max(e.kn * by_mass, (slip + turn) / 2 + std::hypot((slip - turn) / 2, cross));
}

// The largest omega^2 so far, and of which element between which discs.
struct Stiffest {
  double squared = 0;
  const char* kind = "";
  std::uint32_t first = 0, second = 0;

  void see(double other, const char* its_kind, std::uint32_t one, std::uint32_t another) {
    if (other > squared) *this = {other, its_kind, one, another};
  }
};

}  // namespace

CriticalElement critical_element(const Model& model) {
  const std::size_t size = model.discs.size();
  std::vector<Element> elements;
  std::vector<std::uint32_t> joined(size, 0);
  for (const Bond& bond : model.bonds) {
    elements.push_back(element_of(model, bond));
    ++joined[bond.first];
    ++joined[bond.second];
  }
  for (const Spring& spring : model.springs) elements.push_back(element_of(model, spring));

  Share share{std::vector<double>(size, 0.0), std::vector<double>(size, 0.0)};
  for (const Element& e : elements) {
    share.stretch[e.first] += e.k();
    share.stretch[e.second] += e.k();
    share.turn[e.first] += e.turning_1();
    share.turn[e.second] += e.turning_2();
  }
  double wall_kn = 0, wall_ks = 0;
  for (const MovingWall& wall : model.walls) {
    wall_kn = std::max(wall_kn, wall.contact.normal_stiffness);
    wall_ks = std::max(wall_ks, wall.contact.shear_stiffness);
  }
  const double walls = std::min<double>(2, static_cast<double>(model.walls.size()));
  const double smallest = *std::ranges::min_element(model.discs.radius);
  Stiffest stiffest, one_contact;  // `one_contact`: a disc's part of that of a contact
  for (std::uint32_t i = 0; i < size; ++i) {
    double kn = 0, ks = 0;
    for (std::uint32_t g = 0; g < model.groups(); ++g) {
      const LinearContact& contact = model.contacts[model.contact_number(model.group[i], g)];
      kn = std::max(kn, contact.normal_stiffness);
      ks = std::max(ks, contact.shear_stiffness);
    }
    const double radius = model.discs.radius[i];
    const std::uint32_t most = most_neighbours(radius, smallest);
    const double free = most > joined[i] ? most - joined[i] : 0;
    share.stretch[i] += free * std::max(kn, ks) + walls * std::max(wall_kn, wall_ks);
    share.turn[i] += (free * ks + walls * wall_ks) * radius * radius;
    share.stretch[i] /= model.mass[i];
    share.turn[i] /= model.inertia(i);
    if (free + walls == 0) continue;
    const double slip = share.stretch[i] + share.turn[i];
    stiffest.see(slip, "contact", i, i);  // on a wall
    if (free == 0) continue;
    one_contact.see(share.stretch[i], "contact", i, i);
    if (ks > 0) one_contact.see(share.stretch[i] * std::min(1.0, ks / kn) + share.turn[i], "contact", i, i);
  }
  stiffest.see(2 * one_contact.squared, "contact", one_contact.first, one_contact.second);
  for (const Element& e : elements) stiffest.see(highest(e, share), e.kind, e.first, e.second);
  const auto middle = [&stiffest](const std::vector<double>& at) {
    return (at[stiffest.first] + at[stiffest.second]) / 2;
  };
  const double step =
      stiffest.squared > 0 ? 2 / std::sqrt(stiffest.squared) : std::numeric_limits<double>::infinity();
  return {step, stiffest.kind, middle(model.discs.x), middle(model.discs.y)};
}

}  // namespace adit::dem
