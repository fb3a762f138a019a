// A law of the ground, as zones ask for it: a batch at a time. It holds what its zones' points remember
// beside their stress.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "fdm_server/materials/material.hpp"
#include "fdm_server/zones/batch/batch.hpp"
#include "fdm_server/zones/batch/zone_kernels.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

// Zones `first` … `first + count`, none of them beyond a multiple of kBatch, are strained.
struct LawStep {
  std::size_t first;
  std::uint32_t count;
  const PointValues& areas;  // undeformed, of each point
  const StrainBatch& strains;
  StressView stresses;
  double* dissipated;  // of each zone, unweighted [J]
  // Strain across the plane of each zone, beside the increments of `strains`, whose volume holds it; 0 where
  // null.
  const double* across = nullptr;
};

class ZoneLaw {
 public:
  explicit ZoneLaw(const Elasticity& elasticity) : elasticity_(elasticity) {}
  virtual ~ZoneLaw() = default;

  // Takes the stresses to the end of the step. Elastic, unless a law says otherwise.
  virtual void advance(const LawStep& step) {
    add_elastic(step.count, elasticity_, step.strains, step.stresses);
  }
  // The batch that begins with a zone is wanted next, and comes into the cache.
  virtual void prefetch(std::size_t /*first*/) const {}
  // In large strain: what has a direction turns with the ground.
  virtual void turn(std::size_t /*first*/, std::uint32_t /*count*/, const HalfTurns& /*turns*/) {}
  // Before the first step.
  virtual void set_stress(std::size_t /*zone*/, std::size_t /*point*/, const PointStress& /*stress*/) {}
  // Statics are over.
  virtual void begin_time() {}
  // The time at the begin of the step that comes [s]; 0 in statics.
  virtual void set_time(double /*time*/) {}
  virtual void exchange(state::Archive& /*archive*/) {}
  // Energy of zones `first` … `first + count` whose points have these undeformed areas and stresses,
  // unweighted [J]. Elastic, unless a law says otherwise.
  virtual void find_energies(std::size_t /*first*/, std::uint32_t count, const PointValues& areas,
                             const ConstStressView& stresses, BatchValues& energies) const {
    fdm::find_energies(count, elasticity_, areas, stresses, energies);
  }
  virtual double plastic_shear_strain(std::size_t /*zone*/, std::size_t /*point*/) const { return 0; }
  virtual unsigned yields(std::size_t /*zone*/, std::size_t /*point*/) const { return kElastic; }
  // The share that a point's stress uses of the strength that is left (materials/demand.hpp); 0 without one.
  virtual double demand(std::size_t /*zone*/, std::size_t /*point*/, const PointStress& /*stress*/) const {
    return 0;
  }

 protected:
  Elasticity elasticity_;
};

// The law of a material, for so many zones. `strengths`: by which its cohesion and tension are multiplied in
// each zone; empty: 1.
std::unique_ptr<ZoneLaw> make_law(const Material& material, std::size_t zones, bool large_strain,
                                  std::span<const double> strengths = {});

}  // namespace adit::fdm
