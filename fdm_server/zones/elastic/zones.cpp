#include "fdm_server/zones/zones.hpp"

#include "fdm_server/zones/elastic/elastic.hpp"

namespace adit::fdm {

std::unique_ptr<Zones> make_zones(ZoneKind kind, const Grid& grid, const PlaneLaw& law,
                                  std::span<const double> weights) {
  return std::make_unique<ElasticZones>(kind, grid, law, weights);
}

}  // namespace adit::fdm
