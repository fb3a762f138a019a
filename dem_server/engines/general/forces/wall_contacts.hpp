// Rigid straight walls that discs touch from either side, and at their ends: contacts of
// laws/linear_contact.hpp with the nearest point of the wall. They move as they are told.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class WallContacts {
 public:
  WallContacts() = default;
  // Overlaps at the start bear no force where `overlaps_free`.
  WallContacts(std::vector<MovingWall> walls, std::span<const double> radius, const Particles& particles,
               double skin, bool overlaps_free);

  // Moves them by a step. Returns how far the fastest went [m].
  double move(const protocol::Step& step);
  // Lists anew which discs are near.
  void list(const Particles& particles);
  // Adds the contacts' forces to the resultants, from velocities at n - 1/2, and accounts them.
  void add_forces(const protocol::Step& step, Particles& particles);
  // After the forces: their velocities of n + 1/2.
  void drive(const protocol::Step& step);
  void stop();

  double work() const { return work_; }          // of the walls on the discs, since the start [J]
  double friction() const { return friction_; }  // dissipated since the start [J]
  double dashpots() const { return dashpots_; }
  void start_over() { work_ = friction_ = dashpots_ = 0; }
  double strain_energy() const;
  struct Force {
    double x, y;  // of the discs on the wall [N]
  };
  Force force(std::size_t wall) const { return {-states_[wall].fx, -states_[wall].fy}; }
  std::size_t size() const { return walls_.size(); }
  std::span<const MovingWall> walls() const { return walls_; }
  struct Place {
    double x, y;  // travelled since the start [m]
  };
  Place travelled(std::size_t wall) const { return {states_[wall].ux, states_[wall].uy}; }

  // A disc near a wall.
  struct Touch {
    std::uint32_t wall, disc;
    double slack = 0;              // the contact overlaps by -(gap + slack) [m]
    double shear = 0;              // of the spring [N]
    double normal = 0;             // of spring and dashpot [N]
    ContactForces dashpots{0, 0};  // their share [N]
  };
  std::span<const Touch> touches() const { return touches_; }  // by wall, then by disc
  // A disc against the nearest point of a wall; the elongation is the gap, without slack.
  PairKinematics kinematics(std::uint32_t wall, std::uint32_t disc, const Particles& particles,
                            double dt = 0) const;

  void exchange(state::Archive& archive) {
    archive("walls", std::span(states_));
    archive("touches", touches_);
    archive("walls_sum_work", work_);
    archive("walls_sum_friction", friction_);
    archive("walls_sum_dashpots", dashpots_);
  }

 private:
  // Forces on the disc of a touch, which takes them and what they store and dissipate.
  ContactForces forces(const LinearContact& law, const PairKinematics& pair, double dt, double inverse_mass,
                       double inverse_inertia, Touch& touch);

  struct State {
    double ux = 0, uy = 0, vx = 0, vy = 0;  // travelled [m], velocity [m/s]
    double fx = 0, fy = 0;                  // on the discs at the last step [N]
  };

  std::vector<MovingWall> walls_;
  std::vector<State> states_;
  std::vector<double> radius_;
  std::vector<Touch> touches_;
  double skin_ = 0;
  double work_ = 0, friction_ = 0, dashpots_ = 0;
};

}  // namespace adit::dem
