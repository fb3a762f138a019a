// Damping of the material inside the grid.
//
// Rayleigh: C = alpha M + beta K. A mode of angular frequency w has the ratio (alpha/w + beta w)/2; the ratio
// x at w1 and w2 needs alpha = 2 x w1 w2/(w1 + w2), beta = 2 x/(w1 + w2).
//   alpha: the force -alpha m (v(n-1/2) + v(n+1/2))/2, implicit as in dashpots.hpp.
//   beta:  a dashpot beta K in series with a spring 6 K (Maxwell), K that of the zones: of the force
//            g(n) = a g(n-1) + (1 - a) beta (f(n) - f(n-1))/dt,   a = (2 tau - dt)/(2 tau + dt),
//          f being the zones' force, by the trapezoidal rule. For constant K the modulus is
//          G (1 + i w beta/(1 + i w tau)), tau = beta/6; otherwise K is the stiffness of the moment, and what
//          yields is not damped. Up to w2 the ratio is Rayleigh's within x^2/9 of it, and the modulus G
//          within 2/3 x^2 (0.17 % where x is 5 %). Steps longer than 2 tau have tau = dt/2 instead: a = 0,
//          the dashpot alone, which looks half a step back.
//
// Critical step: with e(n) = a e(n-1) + u(n) - u(n-1), so that g = -c K e, c = (1 - a) beta/dt, the sum
//   1/2 M v.v + 1/2 (K + B) u(n).u(n+1) + 1/2 c K (e(n).e(n+1) + (1 - a)/2 e(n).e(n))
// (B: stiffness without damping, as of linings; v between u(n) and u(n+1)) falls in each step by
// (1 - a)/4 c K (e(n) + e(n-1)).(e(n) + e(n-1)), and is not negative where
//   M - dt^2/4 (B + K (1 + beta/tau)) > 0.
// The left side is a sum over elements, so that each may be asked by itself. The dashpot alone allows zones
// 2/w (sqrt(1 + y^2) - y), y = beta w/2 (Belytschko 1983): a tenth of 2/w and less where they are small
// beside the waves. With the spring it is at least 2/w/sqrt(7). The beams of a lining, hundreds of times as
// stiff as the ground, would do with a hundredth: they are not damped by beta, but by the ground around them.
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
#include "fdm_server/solver/sweep.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::fdm {

struct DampingLaw {
  double alpha = 0;  // [1/s]
  double beta = 0;   // [s]
  double local = 0;  // a

  double relaxation() const { return beta / 6; }  // tau [s]

  bool any() const { return alpha != 0 || beta != 0 || local != 0; }
};

// The ratio at both frequencies [Hz].
DampingLaw rayleigh(double ratio, double low_frequency, double high_frequency);

// The critical step [s] of zones whose undamped critical step is `undamped`.
double critical_step(const DampingLaw& law, double undamped);

// The force g of the stiffness part, from step to step: g = keep g + take (f(n) - f(n-1)).
struct Maxwell {
  double keep = 0, take = 0;
  Maxwell(const DampingLaw& law, const protocol::Step& step);
  double operator()(double g, double growth) const { return keep * g + take * growth; }
};

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
