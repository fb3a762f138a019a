#include "simplified/beam/model/mesh.hpp"

#include <cmath>

namespace adit::simplified::beam {
namespace {

constexpr double kSame = 1e-6;  // [m] cuts closer together than this count as one

// Elements of equal length from the last node to `end`, all of one section.
void add_elements(Mesh& mesh, double end, int section, double longest) {
  const double start = mesh.nodes.back();
  const int count = std::max(1, static_cast<int>(std::ceil((end - start) / longest - 1e-9)));
  for (int k = 1; k <= count; ++k) {
    mesh.elements.push_back(static_cast<int>(mesh.links.size()));
    mesh.links.push_back({section, -1});
    mesh.nodes.push_back(k == count ? end : start + (end - start) * k / count);
  }
}

void add_joint(Mesh& mesh, int joint) {
  mesh.joints.push_back(static_cast<int>(mesh.links.size()));
  mesh.links.push_back({-1, joint});
  mesh.nodes.push_back(mesh.nodes.back());
}

}  // namespace

Mesh build_mesh(const Tunnel& tunnel) {
  Mesh mesh;
  mesh.nodes.push_back(tunnel.sections.front().from);
  std::size_t joint = 0;
  for (std::size_t s = 0; s < tunnel.sections.size(); ++s) {
    const double end = tunnel.sections[s].to;
    for (; joint < tunnel.joints.size() && tunnel.joints[joint].chainage < end + kSame; ++joint) {
      const double x = tunnel.joints[joint].chainage;
      if (x > mesh.nodes.back() + kSame)
        // A joint at a change of section takes the place of that change, so that no sliver of an element
        // remains.
        add_elements(mesh, std::abs(x - end) < kSame ? end : x, static_cast<int>(s), tunnel.element_length);
      add_joint(mesh, static_cast<int>(joint));
    }
    if (end > mesh.nodes.back() + kSame) add_elements(mesh, end, static_cast<int>(s), tunnel.element_length);
  }
  return mesh;
}

}  // namespace adit::simplified::beam
