#include "dem_server/lining/joint_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "dem_server/model/placement/joint_lines.hpp"

namespace adit::dem {
namespace {

using Face = std::vector<std::uint32_t>;

// Those of one body: the largest of those that hold two particles and at least half as many as the one that
// holds most; of several as large all, so that numbers decide nothing.
Face holding_together(const Face& face, const Bodies& bodies) {
  std::map<std::uint32_t, Face> parts;
  for (const std::uint32_t i : face) parts[bodies.number[i]].push_back(i);
  std::size_t most = 0;
  for (const auto& [body, part] : parts) most = std::max(most, part.size());
  std::erase_if(parts,
                [most](const auto& part) { return part.second.size() < 2 || 2 * part.second.size() < most; });
  std::uint32_t largest = 0;
  for (const auto& [body, part] : parts) largest = std::max(largest, bodies.size[body]);
  Face together;
  for (const auto& [body, part] : parts)
    if (bodies.size[body] == largest) together.insert(together.end(), part.begin(), part.end());
  return together;
}

struct RigidMotion {
  double x, y, rotation;  // at the place asked for
};

RigidMotion rigid_motion(const Face& face, const Particles& p, const geometry::Point& place) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (face.size() < 2) return {kNone, kNone, kNone};
  const auto count = static_cast<double>(face.size());
  double x = 0, y = 0, ux = 0, uy = 0;
  for (const std::uint32_t i : face) {
    x += p.x[i] / count;
    y += p.y[i] / count;
    ux += (p.ux[i] - p.settled_x[i]) / count;
    uy += (p.uy[i] - p.settled_y[i]) / count;
  }
  double turning = 0, square = 0;
  for (const std::uint32_t i : face) {
    const double rx = p.x[i] - x, ry = p.y[i] - y;
    turning += rx * (p.uy[i] - p.settled_y[i] - uy) - ry * (p.ux[i] - p.settled_x[i] - ux);
    square += rx * rx + ry * ry;
  }
  const double rotation = turning / square;
  return {ux - rotation * (place.y - y), uy + rotation * (place.x - x), rotation};
}

}  // namespace

JointFaces::JointFaces(std::string name, const geometry::Point& from, const geometry::Point& to,
                       const Particles& p, std::span<const Pair> near)
    : name_(std::move(name)), from_(from), to_(to) {
  const JointLine line(from, to);
  std::set<std::uint32_t> near_face, far_face;
  for (const auto& [i, j] : near) {
    if (!line.parts({p.x[i], p.y[i]}, {p.x[j], p.y[j]})) continue;
    for (const std::uint32_t k : {i, j}) (line.side({p.x[k], p.y[k]}) < 0 ? near_face : far_face).insert(k);
  }
  near_.assign(near_face.begin(), near_face.end());
  far_.assign(far_face.begin(), far_face.end());
}

JointMotion JointFaces::motion(const Particles& p, const Bodies& bodies) const {
  const geometry::Point middle{(from_.x + to_.x) / 2, (from_.y + to_.y) / 2};
  const RigidMotion near = rigid_motion(holding_together(near_, bodies), p, middle),
                    far = rigid_motion(holding_together(far_, bodies), p, middle);
  const auto [tx, ty] = JointLine(from_, to_).direction();
  const double x = far.x - near.x, y = far.y - near.y;
  return {y * tx - x * ty, x * tx + y * ty, far.rotation - near.rotation};
}

}  // namespace adit::dem
