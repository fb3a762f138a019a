#include "fdm_server/output/lining_probe.hpp"

#include <algorithm>

#include "fdm_server/supports/section_use.hpp"
#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"

namespace adit::fdm {

bool is_of_lining(scene::Quantity quantity) {
  return quantity == scene::THRUST || quantity == scene::MOMENT || quantity == scene::SHEAR_FORCE ||
         is_of_reinforced_section(quantity);
}

bool is_of_reinforced_section(scene::Quantity quantity) {
  return quantity == scene::UTILISATION || quantity == scene::CURVATURE;
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
  protocol::require(found->section || !is_of_reinforced_section(history.quantity()), path + ".quantity",
                    "is of sections of reinforced concrete, but lining `" + found->name +
                        "` is elastic; give it a `section`");
  const geometry::Point place{history.at().x(), history.at().y()};
  return {history.quantity(), static_cast<std::size_t>(found - linings.begin()),
          nearest_node(place, found->path, grid, path + ".at")};
}

double value(const LiningProbe& probe, const Supports& supports, const Structures& structures) {
  const Lining& lining = supports.linings[probe.lining];
  if (probe.quantity == scene::UTILISATION) return section_use(lining, structures, probe.node).utilisation;
  if (probe.quantity == scene::CURVATURE) return section_use(lining, structures, probe.node).curvature;
  const auto [thrust, moment, shear] = forces_at(lining, structures, probe.node);
  return probe.quantity == scene::THRUST ? thrust : probe.quantity == scene::MOMENT ? moment : shear;
}

}  // namespace adit::fdm
