#include "dem_server/condensation/require_linear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "dem_server/model/bond_springs.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {

void require_linear(const Model& model) {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw protocol::UserError("particles.begin", what);
  };
  require(!model.facets.empty(),
          "is for cells, but the particles are discs; pack `cells`, or leave out `begin`");
  require(breakable_bonds(model) > 0,
          "names a share of a strength, but nothing in the region can break; give its material `fracture`");
  const bool unsteady = std::ranges::any_of(model.loads, [](const Load& load) { return !load.steady; });
  for (const auto& [there, what] : {std::pair(unsteady, "loads that change with time"),
                                    {!model.motions.empty(), "prescribed motions"},
                                    {!model.walls.empty(), "walls"},
                                    {!model.bars.empty(), "bars"},
                                    {!model.edges.empty(), "quiet edges"},
                                    {!model.foundations.empty(), "foundations"}})
    require(!there,
            fmt::format("is for regions that only their interface moves, but this one has {}; leave out "
                        "`begin`, or keep them in the continuum",
                        what));
}

}  // namespace adit::dem
