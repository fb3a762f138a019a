// The largest stable time step of central differences.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/zones/zones.hpp"

namespace adit::fdm {

// Stiffness of one unweighted zone [N/m], measured on the kernel: column j is minus the corner forces after a
// unit displacement of degree of freedom j; order x0 y0 x1 y1 x2 y2 x3 y3.
Eigen::Matrix<double, 8, 8> zone_stiffness(ZoneKind kind, const Corners& corners, const PlaneLaw& law);

// Makes the zones of a grid, unstressed, with weights 1.
using MakeZones = std::function<std::unique_ptr<Zones>(const Grid& grid)>;

// 2/omega [s], omega^2 the largest eigenvalue of K_e phi = omega^2 M_e phi over all zones, M_e = rho A/4.
// A proven bound: by Rayleigh's quotient, u.K u / u.M u of the assembled system is a mean of the zones'
// quotients with positive weights u.M_e u, so that no frequency of the grid exceeds the largest of a zone
// (Irons & Treharne 1971; Belytschko 1983). Energy weights scale K_e and M_e alike and change nothing;
// neither do prescribed motions, which restrict u.
double critical_step(ZoneKind kind, const Grid& grid, const PlaneLaw& law, double density);
double critical_step(const Grid& grid, double density, const MakeZones& make);

}  // namespace adit::fdm
