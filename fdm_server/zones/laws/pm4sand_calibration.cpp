#include "fdm_server/zones/laws/pm4sand_calibration.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "fdm_server/materials/pm4sand_point.hpp"
#include "fdm_server/zones/laws/cyclic_driver.hpp"
#include "fdm_server/zones/laws/last_that_holds.hpp"

namespace adit::fdm {
namespace {

constexpr double kVertical = pm4sand::kAtmosphere, kK0 = 0.5;
constexpr double kLeastRatio = 1e-3, kMostRatio = 2;

class ShearedPoint {
 public:
  explicit ShearedPoint(const Pm4Sand& sand)
      : sand_(sand), stress_{(1 + kK0) / 2 * kVertical, {(kK0 - 1) / 2 * kVertical, 0}} {
    state_ = std::bit_cast<decltype(state_)>(begin(sand, stress_));
  }
  void shear(double gamma) {
    constexpr double kNone = 0;
    Pm4SandPoints points{1, &kNone, &kNone, &gamma, &stress_.pressure, &stress_.shear.t, &stress_.shear.s,
                         {}};
    for (std::size_t n = 0; n < kPm4SandFields; ++n) points.state[n] = &state_[n];
    advance(sand_, points);
    strain_ += gamma;
  }
  double stress_ratio() const { return stress_.shear.s / kVertical; }
  double strain() const { return strain_; }

 private:
  Pm4Sand sand_;
  Pm4SandStress stress_;
  std::array<double, kPm4SandFields> state_;
  double strain_ = 0;
};

// To a stress ratio; the last step is as much of one as leads there. True if the strain was 3 % before.
bool shear_to(double end, double sense, ShearedPoint& point) {
  for (;;) {
    const ShearedPoint last = point;
    point.shear(sense * kLargestPart);
    if (sense * point.stress_ratio() > sense * end) {
      const double share = (end - last.stress_ratio()) / (point.stress_ratio() - last.stress_ratio());
      point = last;
      point.shear(share * sense * kLargestPart);
      return false;
    }
    if (std::abs(point.strain()) >= kLiquefyingStrain) return true;
  }
}

bool liquefies(Pm4Sand sand, double contraction_rate, double ratio) {
  sand.contraction_rate = contraction_rate;
  return cycles_to_strain(sand, ratio, kLiquefyingCycles).has_value();
}

}  // namespace

std::optional<double> cycles_to_strain(const Pm4Sand& sand, double ratio, double most) {
  ShearedPoint point(sand);
  double cycles = 0, whole = 0.25;  // up to the last reversal; what the present way adds
  for (double sense = 1; cycles < most; sense = -sense) {
    const double begin = point.stress_ratio(), end = sense * ratio;
    if (shear_to(end, sense, point)) {
      cycles += whole * (point.stress_ratio() - begin) / (end - begin);
      return cycles <= most ? std::optional(cycles) : std::nullopt;
    }
    cycles += whole;
    whole = 0.5;
  }
  return std::nullopt;
}

std::optional<double> contraction_rate(const Pm4Sand& sand, double resistance) {
  const auto holds = [&](double rate) { return liquefies(sand, rate, resistance); };
  if (!holds(kLeastContractionRate) || holds(kMostContractionRate)) return std::nullopt;
  return last_that_holds(kLeastContractionRate, kMostContractionRate, holds);
}

double cyclic_resistance(const Pm4Sand& sand, double contraction_rate) {
  return last_that_holds(kLeastRatio, kMostRatio,
                         [&](double ratio) { return !liquefies(sand, contraction_rate, ratio); });
}

}  // namespace adit::fdm
