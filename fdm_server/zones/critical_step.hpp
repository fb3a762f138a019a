// The largest stable time step of central differences.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"

namespace adit::fdm {

// Stiffness of one unweighted zone [N/m], measured on the kernel: column j is minus the corner forces after a
// unit displacement of degree of freedom j; order x0 y0 x1 y1 x2 y2 x3 y3.
Eigen::Matrix<double, 8, 8> zone_stiffness(ZoneKind kind, const Corners& corners, const PlaneLaw& law);

// 2/omega [s], omega^2 the largest eigenvalue of K_e phi = omega^2 M_e phi over all zones, M_e = rho A/4.
// A proven bound: by Rayleigh's quotient, u.K u / u.M u of the assembled system is a mean of the zones'
// quotients with positive weights u.M_e u, so that no frequency of the grid exceeds the largest of a zone
// (Irons & Treharne 1971; Belytschko 1983). Energy weights scale K_e and M_e alike and change nothing;
// neither do prescribed motions, which restrict u. 0 where a stiffness is beyond all numbers.
double critical_step(ZoneKind kind, const Grid& grid, const PlaneLaw& law, double density);

// Whether the water in the pores leaves at once, as in statics, or stays and adds its stiffness.
enum class Drainage { kDrained, kUndrained };

// That of every zone by itself [s], of all the ground's materials: their elastic stiffness bounds every
// law's.
std::vector<double> zone_steps(ZoneKind kind, const Grid& grid, const Ground& ground,
                               Drainage drainage = Drainage::kUndrained);

// The zone with the smallest critical step [s], by its centre [m].
struct CriticalZone {
  double step = std::numeric_limits<double>::infinity();
  std::array<double, 2> centre{};
};

CriticalZone critical_zone(ZoneKind kind, const Grid& grid, const Ground& ground,
                           Drainage drainage = Drainage::kUndrained);
inline double critical_step(ZoneKind kind, const Grid& grid, const Ground& ground) {
  return critical_zone(kind, grid, ground).step;
}

}  // namespace adit::fdm
