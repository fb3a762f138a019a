#include "dem_server/engines/general/critical_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "dem_server/engines/general/facets/highest_frequency.hpp"
#include "dem_server/model/bond_springs.hpp"
#include "dem_server/model/placement/groups.hpp"
#include "protocol/foundation/critical_step.hpp"

namespace adit::dem {
namespace {

struct Element {
  const char* kind;
  std::uint32_t first, second;
  double kn, ks, km, arm_1, arm_2;
  bool facet = false;
  double k() const { return std::max(kn, ks); }
  double turning_1() const { return ks * arm_1 * arm_1 + km; }
  double turning_2() const { return ks * arm_2 * arm_2 + km; }
};

// Sums of k and r over what each disc is joined to and may touch.
struct Sums {
  std::vector<Element> elements;
  std::vector<double> stretch, turn;
  std::vector<double> free;  // places for contacts
  std::vector<double> slip;  // largest ks / k of these
};

// The same, over the discs' masses and inertias.
struct Share {
  std::vector<double> stretch, turn;
};

// A contact's spring with its dashpot; `inverse_mass` is 1 / m*.
double effective(double k, double beta, double inverse_mass, double dt) {
  if (beta == 0 || k == 0) return k;
  const double x = dt * std::sqrt(k * inverse_mass);
  return k * std::max(1.0, (1 + 4 * beta / x) / (1 + beta * x));
}

// Of discs, J = m R^2 / 2: a slip at the surface meets three times the inverse mass.
LinearContact effective(const LinearContact& contact, double inverse_mass, double dt) {
  LinearContact with = contact;
  with.normal_stiffness = effective(contact.normal_stiffness, contact.normal_damping, inverse_mass, dt);
  with.shear_stiffness = effective(contact.shear_stiffness, contact.shear_damping, 3 * inverse_mass, dt);
  return with;
}

// Of the masses of statics; how fast facets oscillate is found of all together
// (facets/highest_frequency.hpp).
Element facet_of(const Model& model, const Bond& bond) {
  const FacetBond& f = model.facets[bond.number];
  const double k = f.stiffness * f.length;
  return {"facet",         bond.first,      bond.second, k, k, k * f.length * f.length / 12,
          f.half_distance, f.half_distance, true};
}

Element element_of(const Model& model, const Bond& bond, double dt) {
  const std::uint32_t i = bond.first, j = bond.second;
  const double length = std::hypot(model.discs.x[j] - model.discs.x[i], model.discs.y[j] - model.discs.y[i]);
  const double arm_1 = (length + model.discs.radius[i] - model.discs.radius[j]) / 2;
  const LinearContact contact = effective(contact_of(model, bond), 1 / model.mass[i] + 1 / model.mass[j], dt);
  const BondSprings springs = stiffest_springs(model, bond, contact);
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

// Along and across each element; slip in the bond only softens it.
void add_elements(const Model& model, const Bar& bar, std::vector<Element>& elements) {
  const auto arm = [&](const BarNode& node) {
    return std::hypot(node.x - model.discs.x[node.disc], node.y - model.discs.y[node.disc]);
  };
  for (std::size_t k = 0; k < bar.elements(); ++k) {
    const BarNode &a = bar.nodes[k], &b = bar.nodes[bar.after(k)];
    if (!model.is_there(a.disc) || !model.is_there(b.disc)) continue;
    const double length = std::hypot(b.x - a.x, b.y - a.y), half = length / 2;
    elements.push_back({"bar", a.disc, b.disc, 0, bar.steel.modulus * bar.area / length, 0, arm(a), arm(b)});
    elements.push_back({"bar", a.disc, b.disc, 0, a.dowel_stiffness, 0, arm(a) + half, arm(b) + half});
  }
}

// Its discs may meet others: it breaks, or slides until they part.
bool lets_go(const Model& model, const Bond& bond) {
  return bond.law == Bond::Law::kSmoothJoint || is_breakable(model, bond);
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

// The hardest contact that a disc can have with another or a wall, and the largest ks / k of any.
struct Hardest {
  double kn = 0, ks = 0, slip = 0;
  double k() const { return std::max(kn, ks); }
  void add(const LinearContact& contact) {
    kn = std::max(kn, contact.normal_stiffness);
    ks = std::max(ks, contact.shear_stiffness);
    slip = std::max(
        slip, over(contact.shear_stiffness, std::max(contact.normal_stiffness, contact.shear_stiffness)));
  }
};

class Touching {
 public:
  explicit Touching(const Model& model)
      : model_(model),
        smallest_(*std::ranges::min_element(model.discs.radius)),
        heaviest_(*std::ranges::max_element(model.mass)) {}

  // In steps of dt, of all but facets.
  Sums sums(double dt) const { return sums(dt, false); }
  Sums sums_with_facets(double dt) const { return sums(dt, true); }
  // By which contacts of cells are stiffer than the facets whose places they take, at least 1.
  double over_facets(double dt) const;
  // The largest omega^2 of an element.
  Stiffest stiffest(const Sums& sums, const Masses& masses) const;

 private:
  Sums sums(double dt, bool facets) const;
  Hardest contact_of_disc(std::uint32_t i, double dt) const;
  Hardest wall_of_disc(std::uint32_t i, double dt) const;
  std::vector<Element> elements(double dt) const;

  // A particle lies on two of them at most. A cell's side on one may be as long as two of a regular hexagon.
  double walls() const {
    return (model_.outlines.empty() ? 1 : 2) * std::min<double>(2, static_cast<double>(model_.walls.size()));
  }

  const Model& model_;
  double smallest_, heaviest_;
};

Hardest Touching::contact_of_disc(std::uint32_t i, double dt) const {
  Hardest hardest;
  for (std::uint32_t g = 0; g < model_.groups(); ++g)
    hardest.add(effective(model_.contacts[model_.contact_number(model_.group[i], g)],
                          1 / model_.mass[i] + 1 / heaviest_, dt));
  return hardest;
}

Hardest Touching::wall_of_disc(std::uint32_t i, double dt) const {
  Hardest hardest;
  for (const MovingWall& wall : model_.walls) hardest.add(effective(wall.contact, 1 / model_.mass[i], dt));
  return hardest;
}

// The law's stiffness is that of a facet of a regular hexagon (Group::stiffness).
double Touching::over_facets(double dt) const {
  if (model_.cell_elasticity.empty()) return 1;
  std::vector<double> lightest(model_.groups(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < model_.mass.size(); ++i)
    if (model_.is_there(i)) lightest[model_.group[i]] = std::min(lightest[model_.group[i]], model_.mass[i]);
  double most = 1;
  for (std::uint32_t a = 0; a < model_.groups(); ++a)
    for (std::uint32_t b = a; b < model_.groups(); ++b) {
      if (std::isinf(lightest[a]) || std::isinf(lightest[b])) continue;  // no cells
      const LinearContact contact =
          effective(model_.contacts[model_.contact_number(a, b)], 1 / lightest[a] + 1 / lightest[b], dt);
      const double of_facet =
          in_series(model_.cell_elasticity[a].stiffness, model_.cell_elasticity[b].stiffness) /
          std::numbers::sqrt3;
      most = std::max({most, contact.normal_stiffness / of_facet, contact.shear_stiffness / of_facet});
    }
  return most;
}

std::vector<Element> Touching::elements(double dt) const {
  std::vector<Element> elements;
  for (const Bond& bond : model_.bonds)
    elements.push_back(bond.law == Bond::Law::kFacet ? facet_of(model_, bond) : element_of(model_, bond, dt));
  for (const Spring& spring : model_.springs) elements.push_back(element_of(model_, spring));
  for (const Bar& bar : model_.bars) add_elements(model_, bar, elements);
  return elements;
}

Sums Touching::sums(double dt, bool facets) const {
  const std::size_t size = model_.discs.size();
  std::vector<std::uint32_t> joined(size, 0);
  std::vector<bool> cell(size, false);
  Sums sums;
  sums.elements = elements(dt);
  for (auto* column : {&sums.stretch, &sums.turn, &sums.free, &sums.slip}) column->assign(size, 0.0);
  std::vector<Hardest> contacts(size);
  for (std::uint32_t i = 0; i < size; ++i) contacts[i] = contact_of_disc(i, dt);
  for (std::size_t k = 0; k < sums.elements.size(); ++k) {
    const Element& e = sums.elements[k];
    if (e.facet) cell[e.first] = cell[e.second] = true;
    if (e.facet && !facets) continue;
    const bool bond = k < model_.bonds.size(), breaks = bond && lets_go(model_, model_.bonds[k]);
    const auto add = [&](std::uint32_t i, double turning) {
      const Hardest contact = breaks ? contacts[i] : Hardest{};
      const double radius = model_.discs.radius[i];
      sums.stretch[i] += std::max(e.k(), contact.k());
      sums.turn[i] += contact.ks > e.ks ? std::max(turning, contact.ks * radius * radius) : turning;
      joined[i] += bond;
    };
    add(e.first, e.turning_1());
    add(e.second, e.turning_2());
  }
  for (std::uint32_t i = 0; i < size; ++i) {
    const Hardest &contact = contacts[i], wall = wall_of_disc(i, dt);
    const double radius = model_.discs.radius[i], walls = this->walls();
    const std::uint32_t most = most_neighbours(radius, smallest_);
    sums.free[i] = most > joined[i] && !cell[i] ? most - joined[i] : 0;
    sums.slip[i] = contact.slip;
    sums.stretch[i] += sums.free[i] * contact.k() + walls * wall.k();
    sums.turn[i] += (sums.free[i] * contact.ks + walls * wall.ks) * radius * radius;
  }
  return sums;
}

Stiffest Touching::stiffest(const Sums& sums, const Masses& masses) const {
  const std::size_t size = model_.discs.size();
  Share share;
  for (auto* column : {&share.stretch, &share.turn}) column->resize(size);
  Stiffest stiffest, one_contact;  // `one_contact`: a disc's part of that of a contact
  for (std::uint32_t i = 0; i < size; ++i) {
    share.stretch[i] = sums.stretch[i] / masses.mass[i];
    share.turn[i] = sums.turn[i] / masses.inertia[i];
    if (sums.free[i] + walls() == 0) continue;
    stiffest.see(share.stretch[i] + share.turn[i], "contact", i, i);  // on a wall
    if (sums.free[i] == 0) continue;
    one_contact.see(share.stretch[i], "contact", i, i);
    if (sums.slip[i] > 0) one_contact.see(share.stretch[i] * sums.slip[i] + share.turn[i], "contact", i, i);
  }
  stiffest.see(2 * one_contact.squared, "contact", one_contact.first, one_contact.second);
  for (const Element& e : sums.elements)
    if (!e.facet) stiffest.see(highest(e, share), e.kind, e.first, e.second);
  return stiffest;
}

// Infinitely long steps see the springs alone: their contacts' effective stiffness is k.
constexpr double kOfSprings = std::numeric_limits<double>::infinity();

Masses true_masses(const Model& model) {
  Masses masses;
  masses.mass = model.mass;
  masses.inertia.resize(model.mass.size());
  for (std::size_t i = 0; i < model.mass.size(); ++i) masses.inertia[i] = model.inertia(i);
  return masses;
}

double step_of(double squared) {
  return squared > 0 ? 2 / std::sqrt(squared) : std::numeric_limits<double>::infinity();
}

bool any_dashpots(const Model& model) {
  const auto damped = [](const LinearContact& c) { return c.normal_damping > 0 || c.shear_damping > 0; };
  return std::ranges::any_of(model.contacts, damped) ||
         std::ranges::any_of(model.walls, damped, &MovingWall::contact);
}

// The largest step that the dashpots leave stable, of one that springs alone allow, beside facets of this
// omega^2.
double with_dashpots(const Touching& touching, const Masses& masses, double facets, double unstable) {
  constexpr int kBisections = 30;
  double stable = 0;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = (stable + unstable) / 2;
    const Stiffest stiffest = touching.stiffest(touching.sums(middle), masses);
    ((stiffest.squared + facets * touching.over_facets(middle)) * middle * middle <= 4 ? stable : unstable) =
        middle;
  }
  return stable;
}

// The largest k / rho of foundations at a disc.
double foundation_frequency(const Model& model) {
  std::array<std::vector<double>, 2> sums{std::vector(model.discs.size(), 0.0),
                                          std::vector(model.discs.size(), 0.0)};
  for (const Foundation& one : model.foundations)
    for (const std::uint32_t i : one.discs)
      sums[one.direction == foundation::Direction::kX ? 0 : 1][i] +=
          one.law.stiffness * model.cell_area(i) / model.mass[i];
  return std::max(std::ranges::max(sums[0]), std::ranges::max(sums[1]));
}

// Foundations add their frequency to that of the pairs at every disc.
double on_foundations(const Model& model, double step) {
  if (model.foundations.empty()) return step;
  return foundation::critical_step(step, foundation_frequency(model));
}

// The springs of foundations are elements of one disc.
void add_foundations(const Model& model, Sums& sums) {
  for (const Foundation& one : model.foundations)
    for (const std::uint32_t i : one.discs) sums.stretch[i] += one.law.stiffness * model.cell_area(i);
}

// Discs that nothing pulls, or turns, keep their own.
Masses masses_of(const Sums& sums, double mass_per_stiffness, const Model& model) {
  constexpr double kRotary = 2;  // c
  Masses masses = true_masses(model);
  for (std::size_t i = 0; i < masses.mass.size(); ++i) {
    if (sums.stretch[i] > 0) masses.mass[i] = mass_per_stiffness * sums.stretch[i];
    if (sums.turn[i] > 0) masses.inertia[i] = mass_per_stiffness * kRotary * sums.turn[i];
  }
  return masses;
}

// By which this step [s] is critical.
double mass_per_stiffness(const Model& model, const Touching& touching, const Sums& sums, double step) {
  const Masses masses = masses_of(sums, 1, model);
  const double squared = touching.stiffest(sums, masses).squared + highest_square_of_facets(model, masses);
  return squared * step * step / 4;
}

// By which a body of cells oscillates fastest: it is the smallest one, as a rule.
Stiffest smallest_cell(const Model& model, double squared) {
  std::uint32_t smallest = 0;
  for (std::uint32_t i = 0; i < model.discs.size(); ++i)
    if (model.is_there(i) && model.mass[i] / model.density[model.group[i]] <
                                 model.mass[smallest] / model.density[model.group[smallest]])
      smallest = i;
  return {squared, "facet", smallest, smallest};
}

}  // namespace

CriticalElement critical_element(const Model& model) {
  const Touching touching(model);
  const Masses masses = true_masses(model);
  const double facets = highest_square_of_facets(model, masses);
  Stiffest stiffest = touching.stiffest(touching.sums(kOfSprings), masses);
  const double of_statics = step_of(stiffest.squared + facets * touching.over_facets(kOfSprings));
  double step = of_statics;
  if (stiffest.squared + facets > 0 && any_dashpots(model)) {
    step = with_dashpots(touching, masses, facets, step);
    stiffest = touching.stiffest(touching.sums(step), masses);
  }
  const auto allowed = [&model, damped = std::sqrt(1 + model.local_damping)](double undamped) {
    return on_foundations(model, undamped / damped);
  };
  if (facets > stiffest.squared) stiffest = smallest_cell(model, facets);
  const auto middle = [&stiffest](const std::vector<double>& at) {
    return (at[stiffest.first] + at[stiffest.second]) / 2;
  };
  const double static_step = allowed(of_statics);
  Sums springs = touching.sums_with_facets(kOfSprings);
  add_foundations(model, springs);
  return {allowed(step),         static_step,
          stiffest.kind,         middle(model.discs.x),
          middle(model.discs.y), mass_per_stiffness(model, touching, springs, static_step)};
}

Masses scaled_masses(const Model& model, double mass_per_stiffness) {
  Sums springs = Touching(model).sums_with_facets(kOfSprings);
  add_foundations(model, springs);
  return masses_of(springs, mass_per_stiffness, model);
}

}  // namespace adit::dem
