// Paths along sides of zones on which the faces of zones, or of a lining and zones, do not share points: the
// grid is cut there, and contacts join the faces.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "fdm_server/grid/cut.hpp"
#include "fdm_server/grid/grid.hpp"
#include "fdm_server/interfaces/contacts.hpp"
#include "fdm_server/interfaces/interface.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/supports/lining.hpp"

namespace adit::fdm {

class Seams {
 public:
  // A path of the grid's points, and whether it parts the zones beside it from the beginning. A lining that
  // is installed later finds one side excavated.
  struct Seam {
    Path path;
    bool cuts;
  };
  // Cuts the grid. `weights`: of the zones, none: all 1. `kept`: points that stay whole.
  Seams(std::span<const Seam> seams, const std::vector<bool>& kept, const Ground& ground,
        std::span<const double> weights, Grid& grid);

  // The zones on the left and on the right of the k-th side of a path; kNoZone where there is none.
  std::array<std::uint32_t, 2> beside(const Path& path, std::size_t k) const;

  // Adds the contacts of the zones on the left of a path with those on its right. In large strain the points
  // of the face with fewer sides slide along the other one, which the left ones do if there are as many.
  Interface join(const Path& path, const ContactLaw& law, bool large_strain, Contacts& contacts) const;
  // Adds those of a lining with the zones on both its sides, from this stage on. `own`: its points in the
  // order of the path. `share`: how much of each metre of the plane it has.
  Interface join(const Path& path, std::span<const std::uint32_t> own, const ContactLaw& law, double share,
                 std::uint32_t stage, Contacts& contacts) const;

  // Adds those of a layer with the lining below, on its left. `below`, `layer`: their points along the path.
  Interface join(const Path& path, std::span<const std::uint32_t> below, std::span<const std::uint32_t> layer,
                 const ContactLaw& law, std::uint32_t stage, Contacts& contacts) const;

 private:
  // What a side brings to a contact at one of its ends.
  struct End {
    std::array<std::uint32_t, 2> points;  // first, second
    Contacts::Half half;
  };
  std::uint32_t copy(std::uint32_t point, std::uint32_t zone) const;
  // The sides of the zones on the left (0) or right (1) of a path.
  std::vector<Side> face(const Path& path, std::size_t on) const;
  double weight(std::uint32_t zone) const { return zone == kNoZone || weights_.empty() ? 1 : weights_[zone]; }
  // (K + 4 G/3) over the zone's size across the side [Pa/m].
  double stiffness_of(std::uint32_t zone, double side) const;
  // `sense`: positive where the first face lies on the left of the path, negative on the right; its size is
  // the share of each metre of the plane in which the faces touch.
  End end(const Path& path, std::size_t k, const std::array<std::uint32_t, 2>& points,
          const std::array<std::uint32_t, 2>& zones, double sense) const;
  Interface add(std::vector<End> ends, bool closed, const ContactLaw& law, std::uint32_t stage,
                Contacts& contacts) const;

  const Ground& ground_;
  std::span<const double> weights_;
  const Grid& grid_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> on_left_;  // zones of directed sides
};

}  // namespace adit::fdm
