// The undrained cyclic simple shear test of one zone, and the constant of compaction that follows from it.
//
// The zone is strained at constant volume, as ground whose water is stiff and cannot leave: exx = eyy = ezz =
// 0. It begins with the effective stresses -sv vertically, -K0 sv horizontally and across. Small steps of the
// shear strain lead the shear stress to and fro between +-R sv. What the effective vertical pressure loses,
// the water has gained. The ground has liquefied when the effective vertical pressure is 5 % of that at the
// begin, or when the shear strain reaches 3 %: the former is the pressure ratio 0.95 that a column shows, the
// latter what a laboratory counts, and what counts where the ground gives way under the shear stress before
// its pressure is gone. K0 belongs to the result.
#pragma once

#include <optional>

#include "fdm_server/materials/compaction.hpp"
#include "fdm_server/materials/material.hpp"

namespace adit::fdm {

struct CyclicTest {
  double pressure = 100e3;  // sv [Pa]
  double k0 = 0.5;
  // From rest to R sv if the ground stays elastic. Where it does not, steps grow to as large a share of the
  // way since the last reversal.
  int steps = 100;
};

inline constexpr double kLiquefyingCycles = 15;    // of the cyclic resistance
inline constexpr double kLiquefyingStrain = 0.03;  // shear strain to one side

// Cycles at the ratio R until the ground liquefies. The last half cycle counts by the share of its stress
// that was reached. Nothing where the ground holds for `most` cycles.
std::optional<double> cycles_to_liquefaction(const Material& material, const Compaction& compaction,
                                             double ratio, double most, const CyclicTest& test = {});

struct Calibration {
  enum Outcome {
    kFound,
    kBeyondStrength,  // the ground gives way without compaction
    kFirm,            // the pressure does not fall whatever the compaction, as in ground without friction
  } outcome;
  Compaction compaction;      // if found
  double largest_resistance;  // that the strength allows, where the one asked for is beyond
};

// The compaction with which the ground liquefies after 15 cycles at the ratio `resistance`.
Calibration calibrated(const Material& material, double resistance, const CyclicTest& test = {});

}  // namespace adit::fdm
