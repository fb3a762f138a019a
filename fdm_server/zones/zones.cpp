#include "fdm_server/zones/zones.hpp"

#include "fdm_server/zones/assumed_strain.hpp"
#include "fdm_server/zones/mixed_discretization.hpp"

namespace adit::fdm {

std::unique_ptr<Zones> make_zones(ZoneKind kind, const Grid& grid, const PlaneLaw& law,
                                  std::span<const double> weights) {
  if (kind == ZoneKind::kMixedDiscretization)
    return std::make_unique<MixedDiscretizationZones>(grid, law, weights);
  return std::make_unique<AssumedStrainZones>(grid, law, weights);
}

}  // namespace adit::fdm
