// Random dense packing of discs in a box, grown to a stated isotropic stress.
//
// The procedure of Potyondy & Cundall 2004, Int. J. Rock Mech. Min. Sci. 41, 1329, section 3: discs of random
// sizes are drawn until they fill the box to the porosity, thrown into it at half their size, grown to full
// size and brought to rest without friction; then all radii change together until the walls feel the stress.
// Floaters, discs with fewer than three contacts, are then taken away and the stress is met again, until
// there are none.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "dem_server/packing/discs.hpp"
#include "protocol/geometry/bounding_box.hpp"
#include "protocol/log/progress.hpp"

namespace adit::dem {

struct RandomPacking {
  geometry::BoundingBox box;
  double radius_min, radius_max;  // sizes are uniform between them [m]
  double porosity;                // of the discs as drawn; random frictionless discs jam near 0.16
  double stress;                  // isotropic, compression positive, over the contacts' normal stiffness
  std::uint64_t seed;
  bool keep_floaters = false;
  // The stress is met again without the floaters until none is left, so that the packing stands under it.
  // Else it is what was met with them, and the discs stay where they then were.
  bool stands = false;
};

// What was reached.
struct PackingState {
  double porosity = 0;                // 1 - area of the discs / area of the box, before floaters went
  double stress_x = 0, stress_y = 0;  // of the walls, over the normal stiffness
  double coordination = 0;   // mean number of contacts of the discs that are no floaters, walls included
  double radius_factor = 1;  // by which the drawn radii had to be changed
  std::size_t floaters = 0;
};

struct GrownPacking {
  Discs discs;
  PackingState state;
};

struct Growing {
  protocol::Progress progress = [](const std::string&) {};  // hears how far it is
  std::size_t threads = 1;                                  // that share it, 0: as many as pay
};

// No value where the stress was not reached within 1 %: the porosity asked for is too far from where discs
// jam. The packing does not depend on the number of threads.
std::optional<GrownPacking> pack_randomly(const RandomPacking& wanted, const Growing& growing = {});

// Number of discs that would be drawn, in the mean.
double count_random(const RandomPacking& wanted);

}  // namespace adit::dem
