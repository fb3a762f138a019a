#include "protocol/sections/moment_curvature.hpp"

#include "protocol/sections/axial_strain.hpp"

namespace adit::sections {

std::vector<CurvaturePoint> moment_curvature(const FibreSection& section, double thrust,
                                             std::span<const double> curvatures) {
  std::vector<CurvaturePoint> points;
  FibreStates states(section);
  for (const double curvature : curvatures) {
    const double strain = axial_strain(
        [&](double trial) {
          FibreStates tried = states;
          return tried.strain_to(section, trial, curvature).thrust;
        },
        thrust, states.strain());
    points.push_back({curvature, strain, states.strain_to(section, strain, curvature).moment});
  }
  return points;
}

}  // namespace adit::sections
