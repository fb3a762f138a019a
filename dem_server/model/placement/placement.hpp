// Where the scene wants discs, before they are joined.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dem_server/packing/discs.hpp"
#include "dem_server/packing/random/random_dense.hpp"
#include "dem_server/packing/voronoi/voronoi_cells.hpp"
#include "protocol/geometry/bounding_box.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Gaps as shares of the mean radius of two discs.
struct Reach {
  double unstated = scene::Bonds::default_instance().reach();  // up to which bonds join that state none
  double near = 1e-3;                                          // up to which rounding may have opened them
};

// Of cells of Voronoi, whose nuclei are the discs' centres.
struct CellShapes {
  std::vector<double> area, polar_moment;  // about the nucleus [m^2], [m^4]
  std::vector<CellOutline> outlines;
  std::vector<Facet> facets;

  void keep_only(const std::vector<bool>& keep);
};

struct Placement {
  Discs discs;
  // Mass of the solid that a disc of this radius stands for [kg per metre of thickness].
  std::function<double(double density, double radius)> mass;
  geometry::BoundingBox extent;       // of the solid [m]
  std::vector<std::uint32_t> number;  // of each in the table it came from; empty without one
  bool overlaps_free = true;
  Reach reach{};
  std::optional<CellShapes> cells{};

  // Keeps the discs for which keep[i] is set.
  void keep_only(const std::vector<bool>& keep);
  // Points at rest within this distance lie on a line of the scene [m].
  double tolerance() const;
};

// Packs or places the discs and takes away what lies outside `within` and the ring. `normal_stiffness` of the
// contacts [N/m] is that under which a random packing is grown. Says in `notes` what it reached.
Placement place_discs(const scene::Particles& particles, double normal_stiffness, const Growing& growing,
                      std::vector<std::string>& notes);

// Throws the UserError of a box that holds too few discs for a bond.
[[noreturn]] void refuse_small_box(const scene::HexagonalPacking& packing, std::size_t particles);

// Discs by their centres: what `area` selects, ascending. UserError where it selects none.
std::vector<std::uint32_t> select(const scene::Area& area, const Placement& placement,
                                  const std::string& path);

}  // namespace adit::dem
