// What is observed of a lining of particles.
#pragma once

#include "dem_server/lining/sections.hpp"

namespace adit::dem {

struct Lining {
  Sections sections;
};

}  // namespace adit::dem
