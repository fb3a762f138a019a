// Rings of segments beside one another, as the scene states them.
//
// Rings with joints in other places follow one another in turn along the tunnel. Each of both kinds has half
// of every metre of the plane, along the same path, with points and an interface of its own. In each joint
// between two rings are the dowels, one joint in each width of a ring: per metre of the plane they have
// 1/width of their stiffness and strength. Errors: UserError with the scene's path where a ring has no other
// one beside it that can be.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/model/supports/layers.hpp"
#include "fdm_server/supports/lining.hpp"
#include "fdm_server/supports/supports.hpp"

namespace adit::fdm {

class Rings {
 public:
  explicit Rings(const SceneLinings& linings);

  // Of each lining the number of the ring beside which it lies; -1: none.
  const std::vector<int>& beside() const { return beside_; }
  bool is_second(int lining) const { return beside_[static_cast<std::size_t>(lining)] >= 0; }
  bool is_ring(int lining) const;
  // How much of each metre of the plane it has.
  double share(int lining) const { return is_ring(lining) ? 0.5 : 1; }

  // Members stand on linings, of which there is one in each place.
  void require_free_of_members(std::span<const LiningPlan> linings,
                               std::span<const LiningPlan> members) const;

  // Between the rings, whose linings are there.
  void add_dowels(const SceneLinings& linings, std::span<const LiningPlan> plans, const Grid& grid,
                  Supports& supports) const;

 private:
  std::vector<int> beside_;
};

}  // namespace adit::fdm
