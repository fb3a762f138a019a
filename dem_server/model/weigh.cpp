#include "dem_server/model/weigh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "dem_server/model/at_stage.hpp"
#include "dem_server/model/bond_springs.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/selection.hpp"

namespace adit::dem {
namespace {

constexpr std::uint32_t kVanished = std::numeric_limits<std::uint32_t>::max();

// Keeps the discs whose weight is not 0. Returns the new number of each disc, or kVanished.
std::vector<std::uint32_t> keep_discs(std::span<const double> weights, Model& model) {
  std::vector<std::uint32_t> place(model.discs.size(), kVanished);
  std::vector<bool> keep(model.discs.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < place.size(); ++i)
    if ((keep[i] = weights[i] != 0)) place[i] = kept++;
  keep_only(keep, model.discs);
  keep_only(keep, model.mass, model.weight, model.id, model.group, model.present);
  if (!model.gyration_square.empty()) keep_only(keep, model.gyration_square);
  if (!model.outlines.empty()) keep_only(keep, model.outlines);
  if (!model.cell_stiffness.empty()) keep_only(keep, model.cell_stiffness);
  for (ParticleStage& stage : model.stages)
    keep_only(keep, stage.present, stage.group, stage.held, stage.fresh, stage.mass);
  return place;
}

// Mean weight of each disc's bonds, by stiffness; that of its centre where it has none, as it comes in.
// Stiffnesses count as shares of the largest: equal ones give the plain mean.
void weigh_by_bonds(const std::vector<double>& stiffness, Model& model) {
  const double largest = stiffness.empty() ? 0 : std::ranges::max(stiffness);
  std::vector<double> sum(model.discs.size(), 0.0), weighted = sum;
  for (std::size_t k = 0; k < model.bonds.size(); ++k)
    for (const std::uint32_t i : {model.bonds[k].first, model.bonds[k].second}) {
      sum[i] += stiffness[k] / largest;
      weighted[i] += stiffness[k] / largest * model.bonds[k].weight;
    }
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (sum[i] > 0) model.weight[i] = weighted[i] / sum[i];
}

// Conditions that act on several discs.
template <class Condition>
void keep_conditions(const std::vector<std::uint32_t>& place, std::vector<Condition>& conditions) {
  for (Condition& condition : conditions) {
    std::erase_if(condition.discs, [&](std::uint32_t disc) { return place[disc] == kVanished; });
    if (condition.discs.empty()) protocol::refuse_empty(condition.path + ".where", "particles");
    for (std::uint32_t& disc : condition.discs) disc = place[disc];
  }
}

// A bond of a later stage has the weight of the bond that joins its discs in the beginning, or else the mean
// of the discs' own.
template <class Stays>
void weigh_stages(Model& model, const Stays& stays) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> weights;
  if (!model.stages.empty())
    for (const Bond& bond : model.bonds) weights[{bond.first, bond.second}] = bond.weight;
  for (ParticleStage& stage : model.stages) {
    std::erase_if(stage.bonds, [&](Bond& bond) { return !stays(bond); });
    for (Bond& bond : stage.bonds) {
      const auto found = weights.find({bond.first, bond.second});
      bond.weight =
          found != weights.end() ? found->second : (model.weight[bond.first] + model.weight[bond.second]) / 2;
    }
  }
}

// Of weights beyond the overlap.
constexpr double kRounding = 1e-9;

// A bar bears in one model: particles hold it with their whole weight.
void place_bars(const std::vector<std::uint32_t>& place, std::span<const double> weights, Model& model) {
  for (Bar& bar : model.bars)
    for (BarNode& node : bar.nodes) {
      protocol::require(
          weights[node.disc] > 1 - kRounding, bar.path + ".along",
          fmt::format("lies in the overlap with the continuum, at ({:.6g}, {:.6g}) m; end the bar where the "
                      "particles have their whole weight",
                      node.x, node.y));
      node.disc = place[node.disc];
    }
}

}  // namespace

Model weigh(const Model& whole, const SampledWeights& weights) {
  Model model = whole;
  for (std::size_t i = 0; i < model.weight.size(); ++i)
    model.weight[i] = std::max(weights.centres[i], weights.floor);
  const auto place = keep_discs(weights.centres, model);
  const auto stays = [&](auto& pair) {
    if (place[pair.first] == kVanished || place[pair.second] == kVanished) return false;
    pair.first = place[pair.first];
    pair.second = place[pair.second];
    return true;
  };
  std::vector<double> stiffness;
  model.bonds.clear();
  for (std::size_t k = 0; k < whole.bonds.size(); ++k) {
    Bond bond = whole.bonds[k];
    if (!stays(bond)) continue;
    bond.weight = std::max(weights.midpoints[k], weights.floor);
    model.bonds.push_back(bond);
    const BondSprings springs = stiffest_springs(whole, whole.bonds[k]);
    stiffness.push_back(std::max(springs.kn, springs.ks));
  }
  weigh_by_bonds(stiffness, model);
  weigh_stages(model, stays);
  std::erase_if(model.touching, [&](TouchingPair& pair) { return !stays(pair); });
  std::erase_if(model.springs, [&](Spring& spring) { return !stays(spring); });
  place_bars(place, weights.centres, model);
  std::erase_if(model.edges, [&](EdgeDashpot& edge) {
    const bool gone = place[edge.disc] == kVanished;
    edge.disc = place[edge.disc];
    return gone;
  });
  require_overlap_stays(model);
  if (model.discs.size() == 0) return model;  // for the caller to refuse, before a load that lost its discs
  keep_conditions(place, model.loads);
  keep_conditions(place, model.motions);
  keep_conditions(place, model.foundations);
  return model;
}

}  // namespace adit::dem
