#include "dem_server/model/initial_state/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "dem_server/model/initial_state/admissible.hpp"
#include "dem_server/model/initial_state/equilibrium.hpp"
#include "dem_server/model/initial_state/fabric.hpp"

namespace adit::dem {
namespace {

constexpr double kTouching = 1e-6;  // of a radius: gaps below are none
constexpr double kCut = 1e-9;       // of the largest force: less is rounding
constexpr int kMostRounds = 20;

std::vector<Pair> touching_without_bond(const Model& model) {
  const auto by_discs = [](const auto& pair) { return std::pair(pair.first, pair.second); };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> bonded;
  for (const Bond& bond : model.bonds) bonded.push_back(by_discs(bond));
  std::ranges::sort(bonded);
  auto pairs = pairs_within(model.discs, kTouching * std::ranges::max(model.discs.radius));
  std::erase_if(pairs, [&](const Pair& pair) {
    return !model.is_there(pair.first) || !model.is_there(pair.second) ||
           std::ranges::binary_search(bonded, by_discs(pair));
  });
  return pairs;
}

double largest(const std::vector<PairForces>& forces) {
  double most = 0;
  for (const PairForces& f : forces) most = std::max({most, std::abs(f.normal), std::abs(f.shear)});
  return most;
}

// Makes forces balance where some links are softer than others.
using Balance = std::function<void(std::span<const Link> links, std::vector<PairForces>& forces)>;

// Gives the model's links what they can bear of the wanted forces, in rounds: those that bear less yield no
// further, and the others balance what is left. Returns how many bear less.
std::size_t bear_all(std::vector<Link> links, std::vector<PairForces> wanted, const Balance& balance,
                     Model& model) {
  std::vector<bool> cut(links.size(), false);
  const double rounding = kCut * largest(wanted);
  const std::size_t bonds = model.bonds.size();
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (std::size_t k = 0; k < links.size(); ++k) {
      const PairForces borne = k < bonds ? bear(model, wanted[k], model.bonds[k])
                                         : bear(model, wanted[k], model.touching[k - bonds]);
      const bool normal = std::abs(borne.normal - wanted[k].normal) > rounding,
                 shear = std::abs(borne.shear - wanted[k].shear) > rounding,
                 moment = std::abs(borne.moment - wanted[k].moment) > rounding * links[k].arm_1;
      wanted[k] = borne;
      if (normal) links[k].kn = 0;
      if (normal || shear) links[k].ks = 0;
      if (normal || moment) links[k].km = 0;
      if (normal || shear || moment) cut[k] = changed = true;
    }
    if (!changed) break;
    balance(links, wanted);
  }
  return static_cast<std::size_t>(std::ranges::count(cut, true));
}

std::vector<PairForces> forces_at_rest(const Model& model) {
  std::vector<PairForces> forces;
  for (const Bond& bond : model.bonds)
    forces.push_back({bond.at_rest.normal + bond.contact_normal, bond.at_rest.shear + bond.contact_shear,
                      bond.at_rest.moment});
  for (const TouchingPair& pair : model.touching) forces.push_back({pair.normal, pair.shear, 0});
  return forces;
}

// Energy weights of the links.
std::vector<double> link_weights(const Model& model) {
  std::vector<double> weights;
  for (const Bond& bond : model.bonds) weights.push_back(bond.weight);
  for (const TouchingPair& pair : model.touching)
    weights.push_back((model.weight[pair.first] + model.weight[pair.second]) / 2);
  return weights;
}

void scale(PairForces& forces, double factor) {
  forces = {factor * forces.normal, factor * forces.shear, factor * forces.moment};
}

// Faces close around every cell: a stress that balances in the solid does so on them, too.
void set_on_facets(const StressAt& stated, Model& model) {
  for (Bond& bond : model.bonds) {
    if (bond.law != Bond::Law::kFacet) continue;
    const FacetBond& facet = model.facets[bond.number];
    const double nx = facet.nx, ny = facet.ny, h = facet.half_distance;
    const PlaneVector middle = dem::vector_of(nx, ny, h, 2 * h * facet.skew);
    const protocol::GroundStress stress =
        stated(model.discs.x[bond.first] + middle.x, model.discs.y[bond.first] + middle.y);
    const double x = stress.xx * nx + stress.xy * ny, y = stress.xy * nx + stress.yy * ny;
    bond.at_rest = {facet.length * along(nx, ny, x, y), facet.length * across(nx, ny, x, y), 0};
  }
  model.stress_balances = true;
}

}  // namespace

void set_initial_state(const StressAt& stated, Model& model) {
  model.overlaps_free = true;
  if (!model.facets.empty()) {
    set_on_facets(stated, model);
    return;
  }
  const auto touching = touching_without_bond(model);
  for (const auto [first, second] : touching) model.touching.push_back({first, second, 0, 0});
  const Fabric fabric(model, touching, stated);
  const auto links = fabric.links();
  std::vector<PairForces> forces = fabric.stated_forces();
  const bool as_stated = fabric.in_balance(forces);
  if (!as_stated) fabric.balance(forces);
  const std::size_t cut = bear_all(
      {links.begin(), links.end()}, std::move(forces),
      [&fabric](std::span<const Link> softened, std::vector<PairForces>& unbalanced) {
        fabric.balance(softened, unbalanced);
      },
      model);
  model.stress_balances = as_stated && cut == 0;
  if (cut > 0)
    model.notes.push_back(fmt::format(
        "initial stress: {} of {} bonds and contacts cannot bear their part of it (tension of a contact, "
        "shear "
        "beyond friction, more than a strength) and bear what they can; the others took over the rest as far "
        "as possible, and statics finds what is left",
        cut, fabric.links().size()));
}

void balance_in_overlap(const StressAt& stated, std::span<const double> weights, Model& model) {
  if (model.stress_balances) return;
  std::vector<Pair> touching;
  for (const TouchingPair& pair : model.touching) touching.push_back({pair.first, pair.second});
  const std::vector<Link> links = links_of(model, touching);
  const std::vector<double> shares = link_weights(model);
  const Faces faces = find_faces(model.discs, links);
  std::vector<bool> border = faces.border;
  for (std::size_t i = 0; i < border.size(); ++i)
    if (weights[i] < kShared) border[i] = false;
  const std::vector<bool> held = held_motions(model, border, stated);
  std::vector<double> external = external_forces(model);
  const std::vector<double> overlap = forces_of_overlap(model.discs, faces, weights, stated);
  for (std::size_t m = 0; m < external.size(); ++m) external[m] += overlap[m];

  const auto balance = [&](std::span<const Link> softened, std::vector<PairForces>& forces) {
    std::vector<Link> weighed(softened.begin(), softened.end());
    for (std::size_t k = 0; k < weighed.size(); ++k) {
      for (double* stiffness : {&weighed[k].kn, &weighed[k].ks, &weighed[k].km}) *stiffness *= shares[k];
      scale(forces[k], shares[k]);
    }
    Equilibrium(weighed, model.discs, held).balance(weighed, external, forces);
    for (std::size_t k = 0; k < forces.size(); ++k) scale(forces[k], 1 / shares[k]);
  };
  std::vector<PairForces> forces = forces_at_rest(model);
  balance(links, forces);
  bear_all(links, std::move(forces), balance, model);
}

}  // namespace adit::dem
