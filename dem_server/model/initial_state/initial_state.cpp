#include "dem_server/model/initial_state/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem_server/model/initial_state/admissible.hpp"
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
  const auto absent = [&](std::uint32_t disc) { return !model.present.empty() && !model.present[disc]; };
  std::erase_if(pairs, [&](const Pair& pair) {
    return absent(pair.first) || absent(pair.second) || std::ranges::binary_search(bonded, by_discs(pair));
  });
  return pairs;
}

double largest(const std::vector<PairForces>& forces) {
  double most = 0;
  for (const PairForces& f : forces) most = std::max({most, std::abs(f.normal), std::abs(f.shear)});
  return most;
}

// Gives the model's links what they can bear of the wanted forces, in rounds: those that bear less yield no
// further, and the others balance what is left. Returns how many bear less.
std::size_t bear_all(const Fabric& fabric, std::vector<PairForces> wanted, Model& model) {
  std::vector<Link> links(fabric.links().begin(), fabric.links().end());
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
    fabric.balance(links, wanted);
  }
  return static_cast<std::size_t>(std::ranges::count(cut, true));
}

}  // namespace

void set_initial_state(const StressAtHeight& stated, Model& model) {
  model.overlaps_free = true;
  const auto touching = touching_without_bond(model);
  for (const auto [first, second] : touching) model.touching.push_back({first, second, 0, 0});
  const Fabric fabric(model, touching, stated);
  const std::size_t cut = bear_all(fabric, fabric.forces(), model);
  if (cut > 0)
    model.notes.push_back(fmt::format(
        "initial stress: {} of {} bonds and contacts cannot bear their part of it (tension of a contact, "
        "shear "
        "beyond friction, more than a strength) and bear what they can; the others took over the rest as far "
        "as possible, and statics finds what is left",
        cut, fabric.links().size()));
}

}  // namespace adit::dem
