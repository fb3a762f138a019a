// Means over a measurement circle of what discs and the forces between them do.
//
// A mean is weighed by w(r) = 3 (1 - r^2 / R^2)^2 / (pi R^2) around the circle's middle: it falls to nothing
// at the edge, so that no disc or contact counts by a jump as it crosses. Stress follows Goldhirsch 2010,
// Granular Matter 12, 239: a force between two discs is carried along the straight branch between their
// centres, and
//   sigma = sum over the branches of f x l  times the mean of w along the branch,
// f being the force on the first disc and l the branch from the first to the second; what lies outside the
// circle counts nothing, what crosses its edge counts by what lies inside. Momentum is balanced by this
// stress exactly, whatever R. Of an even state in a lattice it is right to (a / R)^(7/2), a a few spacings:
// below 0.1 % from R = 10 radii of a disc on.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "dem_server/observe/observable.hpp"

namespace adit::dem {

struct Circle {
  double x, y, radius;  // [m]
};

struct Tensor {
  double xx, yy, xy;
};

// Tension positive [N/m^2 per metre of thickness]; the symmetric part, where bonds also bend.
Tensor mean_stress(const Circle& circle, std::span<const Branch> branches);

// The rate of the velocity field that is linear over the circle and nearest to the discs' (weighed least
// squares) [1/s]; xy is the tensor's, half of the rate of gamma. No value where fewer than three discs, or
// only discs of one line, have their centres inside.
std::optional<Tensor> mean_strain_rate(const Circle& circle, std::span<const double> x,
                                       std::span<const double> y, std::span<const double> vx,
                                       std::span<const double> vy);

// The share of the circle's area, not weighed, that no disc covers. Overlaps of discs count twice.
double porosity(const Circle& circle, std::span<const double> x, std::span<const double> y,
                std::span<const double> radius);

// Mean of the discs' numbers of neighbours; 0 where no centre is inside.
double mean_coordination(const Circle& circle, std::span<const double> x, std::span<const double> y,
                         std::span<const std::uint32_t> coordination);

}  // namespace adit::dem
