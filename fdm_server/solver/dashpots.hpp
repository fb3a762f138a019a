// Dashpots at grid points: quiet boundaries, and the link between a side of the grid and its free field.
//
// Lysmer & Kuhlemeyer 1969 (J. Eng. Mech. Div. ASCE 95): a wave that meets the boundary head-on leaves
// through the stress rho c_p v_n, rho c_s v_t. An edge of length L with normal n and tangent t gives half of
//   C = L rho (c_p n n' + c_s t t')
// to each of its ends. The force -C (v(n-1/2) + v(n+1/2))/2 is implicit for its own point, so that the limit
// of the time step is that of the grid without dashpots; it is written as a force known before the update,
//   (I + kick/2 C W) F = -C (v(n-1/2) + kick/2 W f),
// f being all other forces and W the inverse masses (0: a prescribed component). Of the multipliers, which
// tie a point to another model, those of the step before stand for those of this one, which are not known
// yet: at rest they balance the other forces.
//
// A side with a free field bears in addition the stress of the column beside it, s n L (with its viscous
// part, damping_law.hpp), and the same dashpots act against the column's velocity: + C w. In a
// plane vertical wave both points then move alike, as if the ground went on.
//
// A quiet edge may have springs beside its dashpots: the viscous-spring boundary of Liu, Du & Yan (2006,
// Earthq. Eng. Eng. Vib. 5), G/R across the edge and G/2R along it, at the distance R from what sends the
// waves. They count the displacement since time 0, and what they take and give back is work of the boundary.
// An edge of length L of a zone of area A and density rho adds at most 2 L G/(R A rho) to the omega^2 of that
// zone, whose quarter of mass bears half of the edge's springs.
//
// Support: when statics end, the points on dashpots are held by the forces that balance those of zones, loads
// and multipliers, and keep these forces in time. What the other points still lack of equilibrium, R
// together, is inertia that no force of the ground balances: with these supports the model would go on at the
// velocity V with C V = R, C being all dashpots of the ground, for ever. The supports get -C_i V besides:
// their sum then balances all loads, as the reactions of a model at rest do, and what is unbalanced inside
// goes away through the dashpots as a wave.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/materials/damping_law.hpp"
#include "fdm_server/solver/sweep.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "protocol/participant/step.hpp"

namespace adit::fdm {

struct Symmetric {
  double xx = 0, xy = 0, yy = 0;

  Symmetric& operator+=(const Symmetric& other);
  bool operator==(const Symmetric&) const = default;
};

struct Vector {
  double x = 0, y = 0;
};

// Where a point of the grid's side meets its column.
struct FreeFieldLink {
  std::uint32_t column_point;
  Symmetric damping;  // the share of the point's dashpots that act against the column [N s/m]
  // Zones of the column below and above, each with half the length of its side, times the side's n_x and
  // weight [m].
  std::array<std::uint32_t, 2> zones{};
  std::array<double, 2> lengths{};
};

// What the edge of one zone brings to one of its points.
struct DashpotShare {
  std::uint32_t zone;
  Symmetric damping{}, spring{};
  bool hold_x = false, hold_y = false;
};

struct Dashpot {
  std::uint32_t point;
  std::vector<DashpotShare> shares{};
  Symmetric damping{};                  // all dashpots of the point [N s/m]
  Symmetric spring{};                   // all its springs [N/m]
  bool hold_x = false, hold_y = false;  // in statics
  std::optional<FreeFieldLink> field{};

  Vector origin{};  // displacement at time 0 [m]
  // Forces of the last step [N].
  Vector settling{};                  // share of what the model lacked of equilibrium when statics ended
  Vector support{};                   // what holds the point at rest, with it
  Vector stress{};                    // of the free field
  Elements viscous_x{}, viscous_y{};  // of its damping
  Vector given{};                     // support, free field and springs
  Vector drag{};                      // of the dashpots
};

void add(Dashpot& dashpot, const DashpotShare& share);
// The edges of zones that are gone absorb and hold nothing any more. What supports the point stays.
void leave_out(const std::vector<bool>& gone, std::span<Dashpot> dashpots);
// The dashpots of a point but for those against its column.
Symmetric of_ground(const Dashpot& dashpot);
Vector operator*(const Symmetric& c, const Vector& v);

// Since the start [J].
struct BoundaryWork {
  double dissipated = 0, external = 0;
};

// Adds the forces of the dashpots at step n to those of the points, which hold all others. Where `supports`,
// step 0 finds the forces that keep the points in equilibrium as they are. `damping`: of the columns.
// Free-field columns come before the points that are linked to them.
void add_boundary_forces(std::span<Dashpot> dashpots, bool supports, const DampingLaw& damping,
                         const protocol::Step& step, const ZoneSet& zones, const PointArrays& points,
                         BoundaryWork& work);

}  // namespace adit::fdm
