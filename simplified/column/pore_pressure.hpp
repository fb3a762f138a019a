// Pore pressure of loose sand under cycles of shear stress, undrained, after Seed, Martin and Lysmer (1975)
// in the form of Booker, Rahman and Seed (1976). Cycles of the amplitude a liquefy it in N cycles,
//     N = 15 (R / a)^(1/b),
// where R is the amplitude that does so in 15, and b the exponent of the resistance. A half cycle does the
// damage 1/(2N), half cycles add up, and with the damage D the pressure has grown by the share
//     r_u = (2/pi) asin(D^(1/(2 theta))),   theta = 0.7 (clean sands: De Alba, Chan and Seed 1975)
// of the effective vertical pressure at rest; the sand has liquefied at D = 1.
//
// Half cycles are those of rainflow counting: where a small loop closes, the half cycle that it interrupted
// goes on. Their damage is spread over their path, so that nothing jumps. At a distance of 2a from the
// reversal where it began, a half cycle has done
//     d(a) = (a / R)^(1/b) / 30,
// and the first path of all, before any reversal, d(|stress|)/2, a quarter cycle. Where the stress exceeds
// its largest value so far, the half cycle ends and the first path goes on: both do the same damage from
// there on (Masing's rule). So D = n/N at every peak of a sine, n being its cycles so far.
#pragma once

#include <vector>

namespace adit::simplified::column {

class PorePressure {
 public:
  // `resistance`: R [Pa], above 0, may be infinite. `exponent`: b, above 0.
  PorePressure(double resistance, double exponent) : resistance_(resistance), power_(1 / exponent) {}

  void follow(double stress);  // from the last stress, at first 0, straight to this one [Pa]

  double damage() const { return damage_; }
  double ratio() const;  // r_u, from 0 to 1

 private:
  double of_half_cycle(double amplitude) const;  // d(a)
  void advance(double stress);                   // without a reversal, and within the loop

  double resistance_, power_;
  double stress_ = 0, damage_ = 0;
  std::vector<double> reversals_;  // of the loops that are still open, the last one innermost
};

}  // namespace adit::simplified::column
