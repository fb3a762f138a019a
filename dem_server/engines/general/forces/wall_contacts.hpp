// Rigid straight walls that particles touch from either side, and at their ends: discs with the nearest point
// of the wall, cells as polygons in which it lies (polygons/depth.hpp). They move as they are
// told.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem_server/engines/general/forces/touch.hpp"
#include "dem_server/engines/general/polygons/cell_polygons.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class WallContacts {
 public:
  WallContacts() = default;
  // Those that touch are cells where there are `polygons`. Overlaps at the start bear no force where
  // `overlaps_free`.
  WallContacts(std::vector<MovingWall> walls, const CellPolygons& polygons, const FacetSet& facets,
               const Particles& particles, double skin, bool overlaps_free);

  // Moves them by a step. Returns how far the fastest went [m].
  double move(const protocol::Step& step);
  // Lists anew which particles are near.
  void list(const Particles& particles);
  // Adds the contacts' forces to the resultants, from velocities at n - 1/2, and accounts them.
  void add_forces(const protocol::Step& step, const FacetSet& facets, Particles& particles);
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

  // A particle near a wall.
  struct Near {
    std::uint32_t wall, disc;
    double slack = 0;  // depth that bears nothing [m]
    Touch touch{};
  };
  std::span<const Near> near() const { return near_; }  // by wall, then by particle
  // A particle that presses on a wall, as its first body.
  std::optional<Encounter> encounter(const Near& near, const FacetSet& facets, const Particles& particles,
                                     double dt = 0) const;

  void exchange(state::Archive& archive) {
    archive("walls", std::span(states_));
    archive("touches", near_);
    archive("walls_sum_work", work_);
    archive("walls_sum_friction", friction_);
    archive("walls_sum_dashpots", dashpots_);
  }

 private:
  // Of a particle's centre, from a wall's first end [m].
  PlaneVector place(std::uint32_t wall, std::uint32_t disc, const Particles& particles) const;
  Encounter of_disc(const Near& near, const Particles& particles, double dt) const;
  std::array<geometry::Point, 2> ends(const Near& near, const Particles& particles) const;
  double depth_in_cell(const Near& near, const FacetSet& facets, const Particles& particles) const;
  std::optional<Encounter> of_cell(const Near& near, const FacetSet& facets,
                                   const Particles& particles) const;

  struct State {
    double ux = 0, uy = 0, vx = 0, vy = 0;  // travelled [m], velocity [m/s]
    double fx = 0, fy = 0;                  // on the discs at the last step [N]
  };

  std::vector<MovingWall> walls_;
  std::vector<State> states_;
  CellPolygons polygons_;
  std::vector<Near> near_;
  double skin_ = 0;
  double work_ = 0, friction_ = 0, dashpots_ = 0;
};

}  // namespace adit::dem
