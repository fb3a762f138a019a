// Moment over curvature of a section of fibres at a constant thrust.
#pragma once

#include <span>
#include <vector>

#include "protocol/sections/fibre_section.hpp"

namespace adit::sections {

struct CurvaturePoint {
  double curvature, strain, moment;  // [1/m]; at the middle of the thickness; about it [N m]
};

// Takes a section that was never strained through these curvatures, one after the other.
std::vector<CurvaturePoint> moment_curvature(const FibreSection& section, double thrust,
                                             std::span<const double> curvatures);

}  // namespace adit::sections
