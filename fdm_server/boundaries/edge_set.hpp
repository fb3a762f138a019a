// The boundary's edges as the conditions share them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fdm_server/boundaries/boundary_edge.hpp"
#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/grid/grid.hpp"
#include "fdm_server/solver/dashpots.hpp"

namespace adit::fdm {

// rho c_p and rho c_s of a zone [Pa s/m] and its shear modulus [Pa], times its energy weight.
struct Impedance {
  double normal, shear;
  double modulus = 0;
};
Impedance impedance(const PlaneLaw& law, double density, double weight);
using ImpedanceOf = std::function<Impedance(std::uint32_t zone)>;

// rho (c_p n n' + c_s t t') of the edge [Pa s/m].
Symmetric dashpots(const BoundaryEdge& edge, const Impedance& impedance);

// The springs of an edge at this distance from what sends the waves, G/R (n n' + t t'/2) [Pa/m].
Symmetric springs(const BoundaryEdge& edge, double shear_modulus, double source_distance);

// A length of an edge that a point stands for [m], with the zone behind it.
struct EdgeShare {
  std::uint32_t point, zone;
  double length;
  double x;  // of the point, or of the side whose column it ends [m]
};

class EdgeSet {
 public:
  EdgeSet(const Grid& grid, std::span<const BoundaryEdge> outline, std::span<const FreeFieldColumn> columns);

  const Grid& grid() const { return grid_; }
  std::span<const BoundaryEdge> outline() const { return outline_; }
  const BoundaryEdge& operator[](std::size_t e) const { return outline_[e]; }
  // The edge's number; none where it is not of the boundary.
  std::optional<std::size_t> find(std::uint32_t from, std::uint32_t to) const;

  // The numbers of these edges, which may run either way. UserError at `path` where one is none of the
  // boundary.
  std::vector<std::size_t> numbers(std::span<const Edge> edges, const std::string& path) const;

  // An edge has one condition: UserError at `path` where it has one already.
  void claim(std::size_t e, const std::string& holder, const std::string& path);

  // Half of the edge to each of its points; and the foot or head of a column that continues it, all to one
  // point.
  std::vector<EdgeShare> shares(std::size_t e) const;

 private:
  const Grid& grid_;
  std::span<const BoundaryEdge> outline_;
  std::span<const FreeFieldColumn> columns_;
  std::vector<std::string> holders_;  // scene paths
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> number_of_;
};

}  // namespace adit::fdm
