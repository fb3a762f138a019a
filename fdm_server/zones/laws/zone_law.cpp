#include "fdm_server/zones/laws/zone_law.hpp"

#include "fdm_server/zones/laws/compacting_law.hpp"
#include "fdm_server/zones/laws/hysteretic_law.hpp"
#include "fdm_server/zones/laws/limited_law.hpp"
#include "fdm_server/zones/laws/plastic_law.hpp"
#include "fdm_server/zones/laws/pm4sand_law.hpp"
#include "fdm_server/zones/laws/reversal_law.hpp"

namespace adit::fdm {

namespace {

std::unique_ptr<ZoneLaw> make_skeleton(const Material& material, std::size_t zones, bool large_strain,
                                       std::span<const double> strengths) {
  if (material.pm4sand) return std::make_unique<Pm4SandLaw>(material.elasticity(), *material.pm4sand, zones);
  const bool limited = material.mohr_coulomb || material.weak_plane;
  if (material.hysteretic) {
    auto chain =
        std::make_unique<HystereticLaw>(material.elasticity(), *material.hysteretic, zones, large_strain);
    if (!limited) return chain;
    return std::make_unique<LimitedLaw>(std::move(chain), material, zones, large_strain, strengths);
  }
  if (material.reversals)
    return std::make_unique<ReversalLaw>(material.elasticity(), *material.reversals, zones, large_strain);
  if (limited) return std::make_unique<PlasticLaw>(material, zones, large_strain, strengths);
  return std::make_unique<ZoneLaw>(material.elasticity());
}

}  // namespace

std::unique_ptr<ZoneLaw> make_law(const Material& material, std::size_t zones, bool large_strain,
                                  std::span<const double> strengths) {
  auto skeleton = make_skeleton(material, zones, large_strain, strengths);
  if (!material.compaction) return skeleton;
  return std::make_unique<CompactingLaw>(std::move(skeleton), material.elasticity(), *material.compaction,
                                         zones);
}

}  // namespace adit::fdm
