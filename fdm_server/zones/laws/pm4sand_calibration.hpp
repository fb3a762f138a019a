// The contraction rate h_po of PM4Sand that a cyclic resistance asks for.
//
// One point of the sand is sheared at constant volume, as ground whose water is stiff and cannot leave, from
// a vertical pressure of one atmosphere and half of it horizontally. The shear stress goes to and fro between
// +-R times the vertical pressure, until the shear strain reaches 3 % to one side. It does in the fewer
// cycles the smaller h_po is. The test is that for which the report gives its parameters.
#pragma once

#include <optional>

#include "fdm_server/materials/pm4sand.hpp"

namespace adit::fdm {

// Cycles at the ratio R until the shear strain is 3 %; nothing where that takes more than `most`. The last
// half cycle counts by the share of its stress that was reached.
std::optional<double> cycles_to_strain(const Pm4Sand& sand, double ratio, double most);

// The sand's own h_po does not count in what follows.

// h_po with which the sand takes 15 cycles (kLiquefyingCycles) at the ratio `resistance`, to a thousandth.
// Nothing where it would lie out of this range.
inline constexpr double kLeastContractionRate = 0.01, kMostContractionRate = 10;
std::optional<double> contraction_rate(const Pm4Sand& sand, double resistance);

// The ratio at which the sand with this h_po takes 15 cycles, to a thousandth.
double cyclic_resistance(const Pm4Sand& sand, double contraction_rate);

}  // namespace adit::fdm
