// Damping of the material inside the grid.
//
// Rayleigh: C = alpha M + beta K. A mode of angular frequency w has the ratio (alpha/w + beta w)/2; the ratio
// x at w1 and w2 needs alpha = 2 x w1 w2/(w1 + w2), beta = 2 x/(w1 + w2).
//   alpha: the force -alpha m (v(n-1/2) + v(n+1/2))/2, implicit as in dashpots.hpp.
//   beta:  the force beta (f(n) - f(n-1))/dt, f that of the zones: for constant K it is -beta K v(n-1/2), for
//   other
//          materials K is the stiffness of the moment, and what yields is not damped. It looks half a step
//          back, hence the shorter critical step 2/w (sqrt(1 + x^2) - x), x = beta w/2 (Belytschko 1983).
//
// Local (Cundall 1987): -a |f| sign(v(n-1/2)), f the unbalanced force of each component: what oscillates has
// the damping ratio a/pi, whatever its frequency, and what moves steadily none. Tied points are left out:
// what moves them are the ties, and their own forces are not what they lack of balance.
//
// Nothing is damped in statics, which have their own relaxation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/grid/field_arrays.hpp"
#include "fdm_server/solver/dashpots.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::fdm {

struct DampingLaw {
  double alpha = 0;  // [1/s]
  double beta = 0;   // [s]
  double local = 0;  // a

  bool any() const { return alpha != 0 || beta != 0 || local != 0; }
};

// The ratio at both frequencies [Hz].
DampingLaw rayleigh(double ratio, double low_frequency, double high_frequency);

// The critical step [s] of a grid whose undamped critical step is `undamped`.
double critical_step(const DampingLaw& law, double undamped);

class Damping {
 public:
  Damping(const DampingLaw& law, std::size_t points)
      : law_(law), local_(law.any() ? points : 0, law.local), state_(law.any() ? points : 0) {}
  const DampingLaw& law() const { return law_; }
  bool acts() const { return law_.any(); }
  // The motion of these points is that of another model.
  void tie(std::span<const std::uint32_t> points);

  // Adds all forces to points on which zones alone pull, and returns what they took since the last step [J].
  double damp(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
              const PointArrays& points);
  // The same in two parts. Adds beta's force where the points' forces are those of the zones alone.
  void add_viscous(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                   const PointArrays& points);
  // Adds the other forces, where the points have all forces, and returns what was dissipated since the last
  // step [J].
  double add_others(std::span<const protocol::IndexRange> ranges, const protocol::Step& step,
                    const PointArrays& points);

  void exchange(state::Archive& archive) { state_.exchange(archive); }

 private:
  // Forces of the zones at the last step, of beta at this one, of all damping at the last one [N].
  enum Field { kZonesX, kZonesY, kViscousX, kViscousY, kDampingX, kDampingY, kFields };

  DampingLaw law_;
  std::vector<double> local_;  // of each point
  FieldArrays<kFields> state_;
};

}  // namespace adit::fdm
