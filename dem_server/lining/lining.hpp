// What is observed of a lining of particles.
#pragma once

#include <vector>

#include "dem_server/lining/joint_faces.hpp"
#include "dem_server/lining/ovals.hpp"
#include "dem_server/lining/sections.hpp"

namespace adit::dem {

struct Lining {
  Sections sections;
  std::vector<JointFaces> joints;
  std::vector<Oval> ovals;
};

}  // namespace adit::dem
