#include "fdm_server/output/lining_probe.hpp"

#include <algorithm>

#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"

namespace adit::fdm {

bool is_of_lining(scene::Quantity quantity) {
  return quantity == scene::THRUST || quantity == scene::MOMENT || quantity == scene::SHEAR_FORCE;
}

LiningProbe resolve_lining_probe(const scene::History& history, const Supports& supports, const Grid& grid,
                                 const std::string& path) {
  const auto& linings = supports.linings;
  const auto found = std::ranges::find(linings, history.lining(), &Lining::name);
  if (found == linings.end()) {
    std::vector<std::string> names;
    for (const Lining& lining : linings) names.push_back(lining.name);
    throw protocol::UserError(
        path + ".lining",
        history.has_lining() ? "is `" + history.lining() + "`, but no lining of the continuum has this name" +
                                   protocol::did_you_mean(history.lining(), names)
                             : std::string("is missing; name the lining whose force is recorded"));
  }
  const geometry::Point place{history.at().x(), history.at().y()};
  return {history.quantity(), static_cast<std::size_t>(found - linings.begin()),
          nearest_node(place, found->path, grid, path + ".at")};
}

double value(const LiningProbe& probe, const Supports& supports, const Structures& structures) {
  const auto [thrust, moment, shear] = forces_at(supports.linings[probe.lining], structures, probe.node);
  return probe.quantity == scene::THRUST ? thrust : probe.quantity == scene::MOMENT ? moment : shear;
}

}  // namespace adit::fdm
