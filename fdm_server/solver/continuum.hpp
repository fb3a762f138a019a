// The continuum in motion: central differences with lumped masses.
//
//   v(n+1/2) = v(n-1/2) + dt f(n)/m,   u(n+1) = u(n) + dt v(n+1/2)
//
// The grid starts from rest at step 0, with half a kick: v(1/2) = dt/2 f(0)/m, as if v(-1/2) = -v(1/2).
// All masses and internal forces carry the zones' weights.
//
// Statics take the same steps, damped (protocol/participant/local_damping.hpp) or stopped; every stop starts
// from rest like step 0, at the stresses reached. A displacement U is imposed over the first steps of its
// stage as U (3 s^2 - 2 s^3), s being the share of these steps that is done: without a jump of velocity at
// either end, and slowly beside the waves that cross the grid (protocol/ground/imposed.hpp).
//
// Structures that the step is too long for, and contacts, move by mean acceleration
// (structures/mean_acceleration.hpp), but for those that touch a point of the interface, of dashpots or of
// foundations, whose forces are needed before all are known.
//
// Energies at step n: kinetic 1/2 sum m v(n-1/2) v(n+1/2), strain energy of the stresses; work of loads,
// prescribed motions, boundaries and ground, and what dashpots, slip and damping dissipate, summed as
// dt v(n+1/2) (F(n) + F(n+1))/2; dissipation of the materials (zones/nonlinear/nonlinear_zones.hpp). Then
// kinetic + strain + dissipated - work keeps its value of step 0 to rounding: M (v(n+3/2) - v(n-1/2)) = dt
// (f(n) + f(n+1)), times v(n+1/2)/2, is the change of the kinetic energy, and f = F - K u. That value is -1/2
// sum m v(1/2)^2 over all that no motion prescribes, 0 where nothing acts at t = 0.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "fdm_server/grid/field_arrays.hpp"
#include "fdm_server/interfaces/contacts.hpp"
#include "fdm_server/solver/damping.hpp"
#include "fdm_server/solver/dashpots.hpp"
#include "fdm_server/solver/loads.hpp"
#include "fdm_server/solver/sweep.hpp"
#include "fdm_server/structures/mean_acceleration.hpp"
#include "fdm_server/structures/structures.hpp"
#include "fdm_server/water/flow.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "protocol/foundation/springs.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"
#include "protocol/threads/team.hpp"

namespace adit::fdm {

struct Energies {
  double kinetic, strain, external_work;  // [J]
  double dissipated = 0;                  // since the start, by what yields, dashpots and damping [J]
};

class Continuum {
 public:
  // `masses`: one weighted mass a point, with that of the structures [kg]; points without mass are held until
  // they have one. Results do not depend on the number of threads.
  Continuum(ZoneSet zones, std::span<const double> masses, std::vector<Load> loads,
            std::vector<PrescribedMotion> motions, std::size_t threads = 1, Structures structures = {},
            Contacts contacts = {});

  // Before the first step, and before the interface is set. At most one dashpot a point, columns before what
  // is linked to them; where they `support`, points that bear on them are in equilibrium at step 0, whatever
  // the stresses.
  void set_dashpots(std::vector<Dashpot> dashpots, bool support);
  void set_damping(const DampingLaw& law);
  // Likewise.
  void set_foundations(std::vector<foundation::Springs> foundations);

  // From now on water flows from zone to zone after each step of time.
  void set_flow(Flow flow);
  bool flows() const { return flow_.has_value(); }

  // Makes these points the interface, before the first step.
  void set_interface(std::span<const std::uint32_t> points);

  // A zone that is taken away, and the share of its forces on the points that stays until the next
  // excavation.
  struct Excavated {
    std::uint32_t zone;
    double held = 0;
  };
  // Takes zones away between two steps, at rest, with their stresses: `masses` and `loads` are those of what
  // is left. Structures and contacts of the stages up to `stage` stand from then on. The interface must not
  // have any of their points.
  void excavate(std::span<const Excavated> zones, std::span<const double> masses, std::vector<Load> loads,
                std::uint32_t stage = 0);

  // Then, in the same stage: these zones of the grid get the materials of the ground, or come into being
  // there free of stress (zones/zone_set.hpp). Points that had no mass before begin their motion where the
  // grid has them.
  void renew(ZoneKind kind, const Grid& grid, const Ground& ground, std::span<const std::uint32_t> zones);

  // At rest: from now on these are the points' masses, and those of the structures make this step the
  // critical one of each of them (structures.hpp; 0: they are true). Loads stay.
  void set_masses(std::span<const double> masses, double structures_step);

  // Adds an impulse [N s] to a point's velocity; a prescribed component does not yield.
  void push(std::uint32_t point, double x, double y);

  // Moves from step n - 1 to n (from rest: does not move), finds the forces at n dt and predicts the
  // velocities at n + 1/2. Steps follow one another from 0 with the same dt. Fills `energies` of step n where
  // given.
  void step(const protocol::Step& step, Energies* energies = nullptr);

  // The same to the same bits in two halves: first the points of the interface with the zones that touch one,
  // then everything else.
  void step_interface(const protocol::Step& step);
  void step_interior(const protocol::Step& step);
  void took(double seconds) { team_.took(seconds); }  // the whole step, after it

  // The energies of a step that was made in halves: to be asked for after both, if its velocities were
  // remembered before the first.
  void remember_velocities();
  Energies energies(const protocol::Step& step);
  // For what is asked of all zones beside the steps.
  protocol::Team& team() { return team_; }

  // All velocities become 0: before a step from rest.
  void stop() { slow(0); }
  // All velocities are multiplied by this factor.
  void slow(double factor);
  // Time begins: at rest, work from 0, stresses as they are. Step 0 is next.
  void start_over();
  // What supports the dashpots of these points from step 0 on holds against this drift beside (dashpots.hpp).
  void settle(protocol::IndexRange points, const protocol::Drift& drift);
  void reset_displacements();
  // Of a continuum that was excavated alike.
  void exchange(state::Archive& archive);

  // One value a point.
  std::span<const double> ux() const { return points_[kUx]; }  // at the last step [m]
  std::span<const double> uy() const { return points_[kUy]; }
  std::span<const double> vx() const { return points_[kVx]; }  // half a step later [m/s]
  std::span<const double> vy() const { return points_[kVy]; }
  std::span<double> vx() { return points_[kVx]; }
  std::span<double> vy() { return points_[kVy]; }
  std::span<const double> masses() const { return points_[kMass]; }                  // weighted [kg]
  std::span<const double> inverse_mass_x() const { return points_[kInverseMassX]; }  // 0: prescribed [1/kg]
  std::span<const double> inverse_mass_y() const { return points_[kInverseMassY]; }
  const ZoneSet& zones() const { return zones_; }
  ZoneSet& zones() { return zones_; }
  const Structures& structures() const { return structures_; }
  const Contacts& contacts() const { return contacts_; }
  // Whether the structures move by mean acceleration in time steps so long [s].
  bool longer_than_structures(double dt) const { return dt > structures_step_; }

  // Whether statics hold a point of the interface, in x and in y.
  std::array<bool, 2> held_in_statics(std::uint32_t point) const;
  // The points that bear on dashpots of boundaries, ascending.
  std::vector<std::uint32_t> points_on_dashpots() const;
  // The force of the dashpots of these points, but for those against columns, against a unit velocity [N
  // s/m]; infinite where any of the points is prescribed or held by springs.
  Vector drag(protocol::IndexRange points) const;

  // A point whose velocity is not finite, if any.
  std::optional<std::uint32_t> first_non_finite() const;

 private:
  enum Field {
    kUx,
    kUy,
    kVx,
    kVy,
    kFx,
    kFy,
    kInverseMassX,
    kInverseMassY,
    kSteadyX,
    kSteadyY,
    kMass,
    kLastVx,
    kLastVy,
    kFields
  };
  struct Loading {
    Load load;
    double factor = 0;  // of the last step
  };
  struct Prescribed {
    PrescribedMotion motion;
    double mass;          // of all its points
    double before = 0;    // velocity half a step ago; from rest that of the mirrored half step
    double after = 0;     // and half a step ahead
    double reaction = 0;  // total force that the motion needed at the last step
    double moved = 0;     // displacement so far in its stage of statics [m]
  };

  // What is computed together. The zones and structures that touch a point of the interface are its part's,
  // so that its forces need nothing of the interior.
  struct Part {
    Sweep sweep;
    Structures::Part structures;
    Contacts::Part contacts;
    std::vector<protocol::IndexRange> points, kept;  // kept: for others than zones to pull on
    std::vector<Loading> loads;
    std::vector<Prescribed> motions;
    std::vector<Dashpot> dashpots;
    std::vector<foundation::Springs> foundations;
  };

  // Says which points the parts may sweep: those that others pull on, too, have to wait for these.
  void plan(const std::vector<bool>& chosen);
  PointArrays arrays(const protocol::Step& step);
  void add_steady(const Load& load);
  Prescribed prescribed(PrescribedMotion motion) const;
  void place(std::vector<Load> loads);
  void take_masses(std::span<const double> masses);
  Load held_forces(std::span<const Excavated> zones);
  std::vector<bool> of_interface() const;  // of every point
  void hold(Axis axis, std::uint32_t point, double impulse);
  void pull(Part& part, const protocol::Step& step);
  void apply_loads(Part& part, const protocol::Step& step);
  foundation::PointMotion motion(const foundation::Springs& springs);
  void find_motions(Part& part, const protocol::Step& step);
  double velocity_in_statics(Prescribed& one, const protocol::Step& step) const;
  void find_reactions(Part& part, const protocol::Step& step);
  bool averages(const protocol::Step& step) const {
    return !step.relax && (longer_than_structures(step.dt) || !contacts_.empty());
  }
  void average_structures(const protocol::Step& step);
  void plan_average(double dt);
  double twice_kinetic_energy_of_points(const protocol::Step& step);
  double twice_kinetic_energy_of_average(const protocol::Step& step) const;
  void predict(const Part& part, const protocol::Step& step);
  void flow(const protocol::Step& step);
  double steady_work() const;

  ZoneSet zones_;
  Structures structures_;
  Contacts contacts_;
  FieldArrays<kFields> points_;
  protocol::Team team_;
  Part interface_, interior_;
  std::unordered_map<std::uint32_t, std::array<bool, 2>> held_;  // in statics, of the interface: x, y
  double structures_step_;                                       // critical [s]
  // Of those of the interior, once a step is too long for them; the motions of the interior that drive its
  // prescribed freedoms.
  std::optional<MeanAcceleration> average_;
  struct Driven {
    std::size_t freedom, motion;
  };
  std::vector<Driven> driven_;
  // Of the interior: by mean acceleration, in pairs of points and together, and explicitly.
  Contacts::Part contact_pairs_, averaged_contacts_, moving_contacts_;
  std::size_t first_contact_strain_ = 0;  // of those of the average
  std::optional<Flow> flow_;
  std::vector<double> excess_, inflow_;  // of each zone, where water flows
  Damping damping_{{}, 0};
  bool supports_ = false;
  BoundaryWork boundary_work_;
  bool steady_ = false;                    // are there steady loads
  double external_work_ = 0, damped_ = 0;  // of all other loads, and of motions
  double last_dt_ = 0, last_kick_ = 0;
  bool damps_ = false;    // the last step was damped locally, as those of statics may be
  bool relaxes_ = false;  // the last step was one of statics
  std::uint32_t stage_ = 0;
  std::uint64_t step_of_stage_ = 0;    // in statics, the next
  std::vector<double> tie_x_, tie_y_;  // of the multipliers at the last step [N]; empty: nothing is tied
};

}  // namespace adit::fdm
