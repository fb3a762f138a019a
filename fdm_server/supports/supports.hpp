// The linings, members and bolts that stand on the grid, and the interfaces through it and beside linings.
#pragma once

#include <cstdint>
#include <vector>

#include "fdm_server/interfaces/contacts.hpp"
#include "fdm_server/interfaces/interface.hpp"
#include "fdm_server/structures/structures.hpp"
#include "fdm_server/supports/lining.hpp"

namespace adit::fdm {

struct BoltBars {
  Path path;
  std::uint32_t first_bar, bars;  // numbers in the structures
  double spacing;                 // a bar's thrust times this is that of one bolt [m]
};

struct Supports {
  Structures structures{};
  std::vector<Lining> linings{};
  std::vector<Lining> members{};  // chains of beams of their own
  std::vector<BoltBars> bolts{};
  Contacts contacts{};
  std::vector<Interface> interfaces{};
};

}  // namespace adit::fdm
