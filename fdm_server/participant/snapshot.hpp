// The state of the grid and its supports as pieces that a viewer can draw.
#pragma once

#include <cstdint>
#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/interfaces/contact_peaks.hpp"
#include "fdm_server/interfaces/interface.hpp"
#include "fdm_server/output/peaks.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/supports/peak_forces.hpp"
#include "fdm_server/supports/peak_joints.hpp"
#include "fdm_server/supports/peak_use.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::fdm {

// One piece "grid" of quadrilaterals, without the zones of weight 0; point fields displacement_m and
// velocity_m_per_s (three components, z = 0, as viewers expect vectors; the velocity is that of half a step
// later), cell fields stress_Pa (xx, yy, xy) and weight.
void fill_snapshot(const Grid& grid, const Continuum& continuum, std::span<const double> weights,
                   wire::Snapshot& snapshot);

// Adds to that piece the cell fields material and group, numbers in the lists of the model (wire.proto), a
// zone of several groups having the last one; where zones are scattered, stiffness_factor and
// strength_factor; where a material states a strength, demand (materials/demand.hpp); where one follows a law
// beyond elasticity, yield_state (the bits of materials/solid.hpp) and plastic_shear_strain.
void add_ground(const Grid& grid, const Ground& ground, const ZoneSet& zones, std::span<const double> weights,
                wire::Piece& piece);

// Pieces of lines, where there are any: "linings" with point fields displacement_m, thrust_N, moment_Nm,
// shear_N, their peaks since time began by sign, peak_largest_… and peak_least_…, with the thrust beside
// those of the moment, thrust_at_peak_largest_moment_N and …_least_…, and the lining's number as cell field
// lining; where a lining has a section of reinforced concrete, also the point fields utilisation,
// shear_utilisation, moment_ratio, curvature_per_m, steel_strain, crack_width_m and hinge_rotation_rad with
// their peaks by size, peak_…, and the ultimate moments at the present thrust, least_moment_capacity_Nm and
// largest_moment_capacity_Nm (0 in elastic linings); where a lining has joints of segments, outer_opening_m,
// inner_opening_m and joint_rotation_rad, and the largest opening of either face since time began,
// peak_joint_opening_m (0 at other nodes); "members" with the same of one member, and cell field member;
// "bolts" with displacement_m and, of one bolt, cell field thrust_N.
struct ChainPeaks {
  const PeakForces& forces;
  const PeakUse& use;
  const PeakJoints& joints;
};
void add_supports(const Grid& grid, const Continuum& continuum, const Supports& supports,
                  const ChainPeaks& of_linings, const ChainPeaks& of_members, wire::Snapshot& snapshot);
// A piece of lines "interfaces", where there are any, one point a contact: point fields displacement_m of the
// first face, normal_stress_Pa, shear_stress_Pa, opening_m, offset_m, and since time began peak_offset_m and
// peak_opening_m; the interface's number as cell field interface.
void add_interfaces(const Grid& grid, const Continuum& continuum, std::span<const Interface> interfaces,
                    const ContactPeaks& peaks, wire::Snapshot& snapshot);
// Adds the peaks to that piece: at points as of every model (peak_motion.hpp), in zones peak_shear_strain,
// peak_largest_principal_stress_Pa and peak_smallest_principal_stress_Pa; where a material states a strength
// peak_demand and peak_demand_time_s.
void add_peaks(const Peaks& peaks, std::span<const double> weights, wire::Piece& piece);

}  // namespace adit::fdm
