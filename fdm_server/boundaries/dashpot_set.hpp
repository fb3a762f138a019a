// The dashpots of all conditions, gathered point by point.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "fdm_server/boundaries/edge_set.hpp"
#include "fdm_server/solver/dashpots.hpp"

namespace adit::fdm {

class DashpotSet {
 public:
  // The edge bears on dashpots in its normal and its tangential direction, or in one of them.
  void add_quiet(const EdgeSet& edges, std::size_t e, const ImpedanceOf& impedance, bool normal, bool shear);
  // The edge has springs besides, at this distance from what sends the waves [m].
  void add_springs(const EdgeSet& edges, std::size_t e, const ImpedanceOf& impedance, double source_distance);
  // The edge's points are held in statics.
  void hold(const EdgeSet& edges, std::size_t e, bool x, bool y);
  // The grid's side leans on its column.
  void add_free_field(const FreeFieldColumn& column, const ImpedanceOf& impedance);

  // As Continuum::set_dashpots wants them: columns first.
  std::vector<Dashpot> in_order(const Grid& grid) const;

 private:
  Dashpot& at(std::uint32_t point);
  std::map<std::uint32_t, Dashpot> dashpots_;
};

}  // namespace adit::fdm
