// Particles that an area of the scene selects, by their centres at rest.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dem_server/particles/assembly.hpp"
#include "protocol/geometry/selection.hpp"

namespace adit::dem {

inline std::vector<std::uint32_t> select(const scene::Area& area, const Particles& particles,
                                         double tolerance, const std::string& path) {
  std::vector<double> centres;
  centres.reserve(2 * particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    centres.push_back(particles.x[i]);
    centres.push_back(particles.y[i]);
  }
  return protocol::select(area, centres, tolerance, path, "particles");
}

}  // namespace adit::dem
