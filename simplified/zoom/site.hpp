// The ground at a place of the tunnel, for a model of its cross-section.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"
#include "simplified/scene/excitation.hpp"

namespace adit::simplified {

// The lateral motion of the ground at a chainage, at every step from time 0.
struct SiteMotion {
  double dt;                              // [s]
  std::vector<double> base_acceleration;  // outcrop of the rock below the soil column [m/s^2]
  std::vector<double> tunnel_velocity;    // free field at the depth of the tunnel's axis [m/s]
};

// Empty where the ground does not move across the tunnel, or where its motion does not come through soil
// columns.
SiteMotion site_motion(const GroundField& ground, double dt, double chainage);

// Writes, for a place of this name, into `directory`:
//   <name>_ground.csv   time, acceleration of the base, velocity of the ground at the tunnel
//   <name>_base.csv     the acceleration of the base alone, as `file` of a ground motion reads it
//   <name>_profile.csv  the layers of the soil from the surface down
// The first two are left out where there is no such motion.
void write_site(const std::filesystem::path& directory, const std::string& name, const scene::Ground& ground,
                const SiteMotion& motion, double chainage);

}  // namespace adit::simplified
