#include "fdm_server/zones/laws/cyclic_driver.hpp"

#include <algorithm>
#include <cmath>

#include "fdm_server/zones/laws/compacting_law.hpp"
#include "fdm_server/zones/laws/last_that_holds.hpp"

namespace adit::fdm {
namespace {

constexpr double kLeftOfPressure = 0.05;
constexpr double kLeastC1 = 1e-6, kMostC1 = 1e3;

// A zone of a square metre that is sheared uniformly.
class ShearedZone {
 public:
  ShearedZone(const Material& material, const Compaction& compaction, const CyclicTest& test)
      : law_(make_law(material, 1, false), material.elasticity(), compaction, 1), stresses_(1) {
    law_.begin_time();
    const PointStress stress =
        point_stress({-test.k0 * test.pressure, -test.pressure, -test.k0 * test.pressure, 0});
    stresses_[kMeanStress][0] = stress.mean;
    stresses_[kAcross][0] = stress.across;
    for (std::size_t k = 0; k < 4; ++k) {
      areas_[k][0] = 0.25;
      stresses_[kDifference + k][0] = stress.difference;
      law_.set_stress(0, k, stress);
    }
  }
  void shear(double gamma) {
    for (auto& of_point : strains_.shear) of_point[0] = gamma;
    law_.advance({0, 1, areas_, strains_, view(stresses_, 0), &dissipated_});
    strain_ += gamma;
  }
  double shear_strain() const { return strain_; }
  double shear_stress() const { return stresses_[kShearStress][0]; }
  double vertical_pressure() const { return stresses_[kDifference][0] - stresses_[kMeanStress][0]; }

 private:
  CompactingLaw law_;
  StressFields stresses_;
  PointValues areas_{};
  StrainBatch strains_{};
  double strain_ = 0, dissipated_ = 0;
};

}  // namespace

std::optional<double> cycles_to_liquefaction(const Material& material, const Compaction& compaction,
                                             double ratio, double most, const CyclicTest& test) {
  ShearedZone zone(material, compaction, test);
  const double amplitude = ratio * test.pressure,
               least = amplitude / material.elasticity().shear / test.steps;
  double cycles = 0, whole = 0.25;  // up to the last reversal; what the present way adds
  for (double sense = 1; cycles < most; sense = -sense) {
    const double from = zone.shear_stress(), begin = zone.shear_strain();
    double reached = from;
    while (sense * reached < amplitude) {
      zone.shear(sense * std::max(least, std::abs(zone.shear_strain() - begin) / (2 * test.steps)));
      reached = sense * std::max(sense * reached, sense * zone.shear_stress());
      if (zone.vertical_pressure() <= kLeftOfPressure * test.pressure ||
          std::abs(zone.shear_strain()) >= kLiquefyingStrain) {
        cycles += whole * std::min((reached - from) / (sense * amplitude - from), 1.0);
        return cycles <= most ? std::optional(cycles) : std::nullopt;
      }
    }
    cycles += whole;
    whole = 0.5;
  }
  return std::nullopt;
}

Calibration calibrated(const Material& material, double resistance, const CyclicTest& test) {
  const auto holds = [&](double c1, double ratio) {
    return !cycles_to_liquefaction(material, compaction(c1), ratio, kLiquefyingCycles, test);
  };
  if (!holds(kLeastC1, resistance)) {
    const double largest =
        last_that_holds(1e-3 * resistance, resistance, [&](double ratio) { return holds(kLeastC1, ratio); });
    return {Calibration::kBeyondStrength, {}, largest};
  }
  if (holds(kMostC1, resistance)) return {Calibration::kFirm, {}, 0};
  const double c1 =
      last_that_holds(kLeastC1, kMostC1, [&](double middle) { return holds(middle, resistance); });
  return {Calibration::kFound, compaction(c1), 0};
}

}  // namespace adit::fdm
