// Zones of one law with their stresses: what a kernel of any kind offers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/plane_law.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"
#include "protocol/state/archive.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::fdm {

enum class ZoneKind { kAssumedStrain, kMixedDiscretization };

// What a zone can tell of its material beside the stress in the plane.
enum class ZoneField {
  kStressZz,            // across the plane [Pa]
  kPlasticShearStrain,  // engineering, summed over the run
  kYieldState,          // bits of Yield (materials/solid.hpp): what yields now or did before
};

// Mean stresses of the zones of a batch, unweighted: (sxx + syy)/2, (sxx - syy)/2 and sxy [Pa].
struct PlaneStresses {
  alignas(64) std::array<double, kBatch> mean, difference, shear;
};

// What a zone bears, unweighted, so that it pulls on its corners as another zone of its shape does: mean
// stress and stress across the plane [Pa], generalized stresses of the pattern (shape/hourglass.hpp) [N].
struct BorneStress {
  Stress mean{};
  double across = 0;
  double pattern_x = 0, pattern_y = 0;
};

class ZoneKernel {
 public:
  virtual ~ZoneKernel() = default;
  virtual std::size_t count() const = 0;
  // All zones, in their order.
  virtual std::span<const ZoneRun> runs() const = 0;
  // The points' displacements, which stay at this place; every step has moved them before it asks for forces.
  // Zones whose stress is a function of them read it there, zones that add up strain increments need none.
  virtual void follow(const double* ux, const double* uy) = 0;
  // Adds the weighted internal forces of the runs' zones to the points' forces, after the points moved by dt
  // times their velocities. Several threads may ask at once, each for zones of its own.
  virtual void add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) = 0;
  void add_forces(double dt, const PointView& points) { add_forces(runs(), dt, points); }
  // A zone's stress becomes uniform: before the first step. Across the plane it is that of plane strain.
  virtual void set_stress(std::size_t zone, const Stress& stress) = 0;
  // Then another stress across the plane, where the material has one of its own.
  virtual void set_stress_zz(std::size_t /*zone*/, double /*zz*/) {}
  // Where the points are now, the zone bears this. What its law remembers begins anew.
  virtual void set_borne(std::size_t zone, const BorneStress& borne) = 0;
  // Takes the zones whose flag is set away, from runs() too: their energy and stress are 0 from then on.
  virtual void remove(const std::vector<bool>& gone) = 0;
  // The displacements are about to become 0; stresses stay.
  virtual void start_over() = 0;
  // Statics are over: what counts from time 0 on begins.
  virtual void begin_time() {}
  // The time at the begin of the step that comes [s]; 0 in statics.
  virtual void set_time(double /*time*/) {}
  // What changes from step to step, of zones of which as many were taken away.
  virtual void exchange(state::Archive& archive) = 0;
  // Weighted elastic energy of some of the zones, or of all [J]. Several threads may ask at once.
  virtual double strain_energy(const protocol::IndexRange& zones) const = 0;
  double strain_energy() const { return strain_energy({0, static_cast<std::uint32_t>(count())}); }
  // Weighted work that plastic and hysteretic strain took since the start [J]; never falls.
  virtual double dissipated() const { return 0; }
  // Mean stress of a zone, unweighted.
  virtual Stress stress(std::size_t zone) const = 0;
  // Unweighted, on its corners; 0 of a zone that was taken away.
  virtual ZoneForces forces(std::size_t zone) const = 0;
  // Stresses of some zones, at most kBatch. Several threads may ask at once.
  virtual void find_stresses(const protocol::IndexRange& zones, PlaneStresses& stresses) const = 0;
  // The largest share of the strengths of its material that the zone's stress uses (materials/demand.hpp),
  // where it is sampled; 0 without a strength, and of a zone that was taken away. Several threads may ask at
  // once.
  virtual double demand(std::size_t zone) const = 0;
  // 0 of a zone that was taken away.
  virtual double field(std::size_t zone, ZoneField field) const = 0;
};

}  // namespace adit::fdm
