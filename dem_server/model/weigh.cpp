#include "dem_server/model/weigh.hpp"

#include <algorithm>
#include <limits>

#include "dem_server/engines/general/critical_step.hpp"

namespace adit::dem {

Weighed weigh(const Weighed& whole, const SampledWeights& weights) {
  const Model& model = whole.model;
  constexpr std::uint32_t kVanished = std::numeric_limits<std::uint32_t>::max();
  Weighed out{model, {}, {}};
  std::vector<std::uint32_t> place(model.discs.size(), kVanished);
  std::vector<bool> keep(model.discs.size());
  std::vector<double> centre;  // weights of what stays
  out.model.mass.clear();
  out.model.inertia.clear();
  out.model.group.clear();
  for (std::uint32_t i = 0; i < model.discs.size(); ++i) {
    if (!(keep[i] = weights.centres[i] != 0)) continue;
    place[i] = static_cast<std::uint32_t>(out.id.size());
    out.id.push_back(whole.id[i]);
    centre.push_back(weights.centres[i]);
    out.model.mass.push_back(model.mass[i]);
    out.model.inertia.push_back(model.inertia[i]);
    out.model.group.push_back(model.group[i]);
  }
  keep_only(keep, out.model.discs);

  const auto stays = [&](auto& pair) {
    if (!keep[pair.first] || !keep[pair.second]) return false;
    pair.first = place[pair.first];
    pair.second = place[pair.second];
    return true;
  };
  std::vector<double> stiffness(out.id.size(), 0.0), weighted = stiffness;
  out.model.joined.clear();
  for (std::size_t k = 0; k < model.joined.size(); ++k) {
    Joined pair = model.joined[k];
    if (!stays(pair)) continue;
    const double own = stiffness_of(model, model.joined[k]),
                 weight = std::max(weights.midpoints[k], weights.floor);
    for (const std::uint32_t i : {pair.first, pair.second}) {
      stiffness[i] += own;
      weighted[i] += own * weight;
    }
    out.model.joined.push_back(pair);
    out.weights.joined.push_back(weight);
  }
  for (std::size_t i = 0; i < out.id.size(); ++i)
    out.weights.discs.push_back(stiffness[i] > 0 ? weighted[i] / stiffness[i]
                                                 : std::max(centre[i], weights.floor));
  std::erase_if(out.model.springs, [&](Spring& spring) { return !stays(spring); });
  std::erase_if(out.model.edges, [&](EdgeDashpot& edge) {
    const bool gone = !keep[edge.disc];
    edge.disc = place[edge.disc];
    return gone;
  });
  return out;
}

}  // namespace adit::dem
