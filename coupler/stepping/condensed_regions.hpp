// Particles that wait, condensed to the grid points that move them, until something in them comes near its
// strength (`particles.begin`).
//
// A region that is linear is, to the grid points q in its overlap, a mass M_c, a stiffness K_c and a steady
// force p (wire.proto, Condense). With the grid points' own mass M, their predicted velocities V* and the
// time step dt, one step of both is
//     (M + M_c + ¼ dt² K_c) (V(n+½) − V(n−½)) = M (V* − V(n−½)) + dt (p − K_c q(n)),
// the mean acceleration for the region: it is stable whatever the step, and only K_c and M_c, which are small
// and constant, enter. The grid gets the impulses M (V(n+½) − V*) at its points. Nothing else is exchanged,
// and the particles rest, but for the steps at which results are wanted or the demand is looked at: there
// they are told how the grid points have moved and are put into the state into which they have followed.
//
// The demand is looked at with every row of results, every fifty steps, which is about the period of the
// shortest waves that a grid carries, at the first steps 1, 2, 4, …, and as soon as it may have come near: it
// changes by less than its largest rate so far, per square root of strain energy, allows.
//
// Energy: with M' = M_c + ¼ dt² K_c the scheme is the leap-frog one of M', so that ½ V(n−½)·M' V(n+½) + ½
// q·K_c q − p·q changes by the work of the grid's impulses exactly, as the ledger has it.
//
// Regions begin one after another: the points of the grid that move one that still waits have nothing to do
// with the multipliers of the others, so that the scheme of those (stepper.hpp, shared_kick.hpp) goes on
// beside.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupler/exchange/round_trip.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/stepping/ledger.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

// How a region that waited began to be computed.
struct Beginning {
  std::uint64_t step;  // of the model
  double demand;
  std::string reason = {};  // why it could not wait; empty: the demand was reached
};

// The motion of the grid at a region's coupling points, from the first to before the last of the model's,
// when it begins; one pair each [m/s].
struct GridMotion {
  std::size_t begin, end;
  std::vector<double> velocities;  // half a step of the particles after the time of the step
  std::vector<double> kicks;       // by the grid's own forces, of a whole step
};

// Steps of the grid from one look at the demand to the next, at most.
constexpr std::uint64_t kLookInterval = 50;
// What a step of a region takes that so many grid points move, on a core of 2023 [s].
double seconds_to_move(std::size_t masters);

class CondensedRegions {
 public:
  // Throws protocol::UserError at `begin` of a region that is not joined to a continuum alone.
  CondensedRegions(Model& model, Ledger& ledger, StepCost& cost);

  bool asked() const { return !regions_.empty(); }  // by the scene
  bool any_wait() const;
  // All particles of the scene do.
  bool nothing_but_they_move() const;
  // Before a step. Those wait no longer that it finds cannot.
  void prepare() {
    if (!condensed_) condense();
  }
  // The grid goes to step n = 0, 1, 2 …, with what it gets from them; if nothing but they move.
  void step(std::uint64_t n, Wanted wanted);
  // They go to step n, for which the grid has predicted its velocities and got the corrections of others.
  void move(std::uint64_t n);
  // After the step: where it is due, they are told how the grid has moved, and the demand is known.
  void look(std::uint64_t n, Wanted wanted);
  // Begins those in which the demand has come to their share, after step n.
  std::vector<GridMotion> begin_near(std::uint64_t n);

  // The particles are told how the grid has moved at the step reached, if they were not.
  void tell() {
    if (any_wait() && condensed_ && !told_) follow({});
  }

  struct Story {
    std::string region;
    std::optional<Beginning> beginning;  // none: it still waits
    double largest_demand;               // of the looks at it while it waited
  };
  std::vector<Story> stories() const;
  std::uint64_t followings() const { return followings_; }  // steps at which particles were told

  void exchange(state::Archive& archive);

 private:
  struct Region {
    std::size_t particles = 0, grid = 0;  // participants
    std::size_t begin = 0, end = 0;       // its coupling points among the model's
    bool waits = true;
    std::optional<Beginning> beginning = {};
    double share = 1;                     // of the demand, at which it begins
    std::vector<std::size_t> own, place;  // of each master: among the grid's own points; its coupling point
    Eigen::VectorXd mass;                 // M, infinite where a motion is prescribed [kg]
    bool any_prescribed = false;
    Eigen::MatrixXd stiffness, inertia;     // K_c, M' [N/m], [kg]
    Eigen::VectorXd force;                  // p [N]
    Eigen::MatrixXd inverse;                // of M + M' [1/kg]
    double strain_at_rest = 0;              // [J]
    Eigen::VectorXd q, before, velocities;  // V(n−½), V(n+½) [m], [m/s]
    Eigen::VectorXd restoring, kick;        // K_c q(n) [N], V* − V(n−½) [m/s]
    Eigen::VectorXd impulses;               // on it, of the last step [N s]
    double work = 0;                        // of these [J]
    double demand = 0, rate = 0;            // the latest, and its largest change per root of energy [J^-1/2]
    double largest_demand = 0;
    Eigen::VectorXd q_told, restoring_told;  // when it was looked at last
    double external_work = 0;                // that the particles told last [J]
    bool prescribed(Eigen::Index k) const { return any_prescribed && std::isinf(mass[k]); }
    // Of a component of the masters, among those of the grid's coupling points.
    std::size_t at(Eigen::Index k) const {
      return 2 * place[static_cast<std::size_t>(k / 2)] + static_cast<std::size_t>(k % 2);
    }
    // Twice the strain energy of the motion since the particles were told [J].
    double square_since_told() const { return (q - q_told).dot(restoring - restoring_told); }
    // A share of the grid's step after the time of the step.
    Eigen::VectorXd velocities_after(double share) const {
      return 0.5 * (before + velocities) + share * (velocities - before);
    }
  };

  void condense();
  void begin(Region& region, const Beginning& beginning);
  void set_waits(Region& region, bool waits);
  void find_masters(Region& region, wire::Condense& request) const;
  std::string why_not_moved(const Region& region) const;  // empty: it can be
  const std::string& other_side(std::size_t participant, const Segment& segment) const;
  std::string costs_more(const Region& region) const;  // empty: it does not
  void read(Region& region, const wire::Condensed& told);
  void move(Region& region, std::uint64_t n);
  void book_grids(Wanted wanted);
  static ParticipantEnergies energies_of(const Region& region);
  static bool may_be_near(const Region& region);
  void follow(Wanted wanted);
  GridMotion begin_moving(const Region& region);
  std::vector<double> at_points(const Region& region, const Eigen::VectorXd& of_masters) const;
  double particles_dt() const { return model_.dt / model_.substeps; }

  Model& model_;
  Ledger& ledger_;
  StepCost& cost_;
  std::vector<Region> regions_;
  bool condensed_ = false;
  std::uint64_t reached_ = 0;  // step of the model
  bool told_ = false;          // the particles, how the grid has moved at it
  std::uint64_t followings_ = 0;
  wire::Advance request_;
};

}  // namespace adit::coupler
