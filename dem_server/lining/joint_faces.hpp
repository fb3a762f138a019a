// Opening, offset and rotation of a joint between two bodies of particles, from the motions of its faces.
//
// The faces are the particles of the pairs that the joint's line parts at rest: the near face on its right,
// the far one on its left. Each moves as a rigid body: of the displacements u_i of its particles at r_i from
// their mean place c, least squares give
//   w = sum r_i x (u_i - mean u) / sum r_i^2,      u(m) = mean u + w x (m - c),
// at the middle m of the line. With t along the line and n its left normal,
//   opening = (u_far - u_near).n,    offset = (u_far - u_near).t,    rotation = w_far - w_near,
// which no rigid motion of both changes. Displacements are those since time began, rotations small.
//
// What falls off must not decide, grains or a whole corner, nor a grain that rolls on a single bond, nor one
// of the ground at the joint's end: of a face the particles of one body count, the largest of those that hold
// at least half as many of the face as the one that holds most. Where several are as large, all of them
// count.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dem_server/packing/discs.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/geometry/shape.hpp"

namespace adit::dem {

struct JointMotion {
  double opening, offset, rotation;  // [m], [m], [rad]
};

// What firm bonds hold together (observe/branches.hpp, observe/fragments.hpp).
struct Bodies {
  std::span<const std::uint32_t> number;  // of each particle: its body
  std::span<const std::uint32_t> size;    // of each body: its particles
};

class JointFaces {
 public:
  // `near`: pairs of particles that touch or nearly do.
  JointFaces(std::string name, const geometry::Point& from, const geometry::Point& to,
             const Particles& particles, std::span<const Pair> near);

  const std::string& name() const { return name_; }
  // Ascending, each particle once.
  std::span<const std::uint32_t> near_face() const { return near_; }
  std::span<const std::uint32_t> far_face() const { return far_; }

  // NaN where fewer than two particles of a face hold together.
  JointMotion motion(const Particles& particles, const Bodies& bodies) const;

 private:
  std::string name_;
  geometry::Point from_, to_;
  std::vector<std::uint32_t> near_, far_;
};

}  // namespace adit::dem
