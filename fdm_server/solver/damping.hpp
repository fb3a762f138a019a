// The forces of damping on the points of the grid: what a law (damping_law.hpp) does from step to step.
//
// alpha: the force -alpha m (v(n-1/2) + v(n+1/2))/2, implicit as in dashpots.hpp. Maxwell's elements follow
// the forces of the zones: the beams of a lining, hundreds of times as stiff as the ground, are not damped by
// them, but by the ground around them.
//
// Local (Cundall 1987): -a |f| sign(v(n-1/2)), f the unbalanced force of each component: what oscillates has
// the damping ratio a/pi, whatever its frequency, and what moves steadily none. Tied points are left out:
// what moves them are the ties, and their own forces are not what they lack of balance.
//
// Nothing is damped in statics, which have their own relaxation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/grid/field_arrays.hpp"
#include "fdm_server/materials/damping_law.hpp"
#include "fdm_server/solver/sweep.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::fdm {

class Damping {
 public:
  Damping(const DampingLaw& law, std::size_t points)
      : law_(law),
        local_(law.any() ? points : 0, law.local),
        free_(law.any() ? points : 0, 1.0),
        state_(law.any() ? points : 0),
        elements_(law.count() > 1 ? points : 0) {}
  const DampingLaw& law() const { return law_; }
  bool acts() const { return law_.any(); }
  // The motion of these points is that of another model.
  void tie(std::span<const std::uint32_t> points);

  // Adds all forces to points on which zones alone pull, and returns what they took since the last step [J].
  double damp(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
              const PointArrays& points);
  // The same in two parts. Adds the elements' force where the points' forces are those of the zones alone.
  void add_viscous(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                   const PointArrays& points);
  // Adds the other forces, where the points have all forces, and returns what was dissipated since the last
  // step [J].
  double add_others(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                    const PointArrays& points);

  void exchange(state::Archive& archive) {
    state_.exchange(archive);
    elements_.exchange(archive);
  }

 private:
  // Forces of the zones at the last step, of the elements at this one, of all damping at the last one [N].
  enum Field { kZonesX, kZonesY, kViscousX, kViscousY, kDampingX, kDampingY, kFields };

  DampingLaw law_;
  std::vector<double> local_, free_;  // of each point: share of local damping; 0 where it is tied, else 1
  FieldArrays<kFields> state_;
  FieldArrays<2 * kMostElements> elements_;  // each by itself, x and y, where there are several [N]
};

}  // namespace adit::fdm
