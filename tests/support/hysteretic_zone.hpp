// A zone of a square metre with Iwan's elements, whose four points are strained alike.
#pragma once

#include <array>

#include "fdm_server/zones/laws/hysteretic_law.hpp"

namespace adit::fdm::test {

class HystereticZone {
 public:
  HystereticZone(const Elasticity& elasticity, const IwanElements& elements)
      : law_(elasticity, elements, 1, false), stresses_(1) {
    for (auto& of_point : areas_) of_point[0] = kArea;
  }

  void set_stress(const SolidStress& stress) {
    const PointStress point = point_stress(stress);
    const StressView view = fdm::view(stresses_, 0);
    view.mean[0] = point.mean;
    view.across[0] = point.across;
    for (std::size_t k = 0; k < 4; ++k) {
      view.difference[k][0] = point.difference;
      view.shear[k][0] = point.shear;
    }
  }
  SolidStress stress() const { return solid_stress(point()); }

  // Returns the energy per volume that is dissipated.
  double add(const Strain& strain) {
    strains_.volume[0] = strain.xx + strain.yy;
    for (std::size_t k = 0; k < 4; ++k) {
      strains_.difference[k][0] = strain.xx - strain.yy;
      strains_.shear[k][0] = strain.xy;
    }
    double dissipated = 0;
    law_.advance({0, 1, areas_, strains_, view(stresses_, 0), &dissipated});
    return dissipated;
  }
  // Per volume; that of the initial stress over the strains since included.
  double energy() const {
    BatchValues energies;
    law_.find_energies(0, 1, areas_, view(stresses_, 0), energies);
    return energies[0];
  }

 private:
  static constexpr double kArea = 0.25;
  PointStress point() const {
    return {stresses_[kMeanStress][0], stresses_[kDifference][0], stresses_[kShearStress][0],
            stresses_[kAcross][0]};
  }

  HystereticLaw law_;
  StressFields stresses_;
  PointValues areas_{};
  StrainBatch strains_{};
};

}  // namespace adit::fdm::test
