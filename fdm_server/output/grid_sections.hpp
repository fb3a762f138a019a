// Sections of zones: the resultants of the forces that cross a line of zone sides.
//
// The zones beside the line pull on its points by their corner forces, those on its right by R, those on its
// left by L. With the inertia of the points shared by both sides, (R - L)/2 is what the right exerts on the
// left; at rest R = -L. With d the direction of the line, n its normal to the left, and s from its middle:
//   thrust = -sum F.n,   shear = sum F.d,   moment = -sum s F.n,   F = (R - L)/2.
// Forces are those without energy weight: within an overlap they are what the whole ground bears, of which
// the zones carry a share. Places are those of the undeformed grid. A zone belongs to the side on which its
// middle lies, and only where that lies beside the line, not beyond its ends.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/damping_law.hpp"
#include "fdm_server/output/damped_stress.hpp"
#include "fdm_server/supports/lining.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/participant/step.hpp"
#include "protocol/sections/strength.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class GridSections {
 public:
  // `zone_kinds` as in zone_fit.hpp. protocol::UserError for a section without length, off the sides of zones
  // or without ground on one of its sides, and for a name given twice.
  GridSections(const scene::Continuum& scene, const Grid& grid, std::span<const std::uint32_t> zone_kinds,
               const DampingLaw& damping);

  // The number of the section that a history names. protocol::UserError at `path`, the history's, where there
  // is none, and where it asks for the use of a section without strength.
  std::size_t number_of(const scene::History& history, const std::string& path) const;

  // After every step, once the zones have their stress of it: what damping adds (damped_stress.hpp).
  void follow(const ZoneSet& zones, const protocol::Step& step);
  // Signs as in GridSection of structures.proto.
  LiningForces of(const ZoneSet& zones, std::size_t section) const;
  // Of a section whose strength is stated.
  sections::Use use(const ZoneSet& zones, std::size_t section) const;

  void exchange(state::Archive& archive);

 private:
  struct Corner {
    std::uint32_t zone;
    std::size_t corner;
    double share;  // 1/2 of the zones on the right, -1/2 of those on the left
    double along;  // from the middle [m]
  };
  struct Section {
    std::string name;
    double x, y;  // its direction
    std::vector<Corner> corners;
    DampedValue thrust{}, moment{}, shear{};
    std::shared_ptr<const sections::Strength> strength;
  };
  static LiningForces undamped(const ZoneSet& zones, const Section& section);

  DampingLaw damping_;
  std::vector<Section> sections_;
};

}  // namespace adit::fdm
