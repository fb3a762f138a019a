#include "simplified/beam/elements/structure.hpp"

#include <cmath>

namespace adit::simplified::beam {
namespace {

void assemble(BlockTridiagonal& matrix, int link, const ElementMatrix& element) {
  matrix.diagonal[link] += element.topLeftCorner<kDofs, kDofs>();
  matrix.diagonal[link + 1] += element.bottomRightCorner<kDofs, kDofs>();
  matrix.lower[link] += element.bottomLeftCorner<kDofs, kDofs>();
}

}  // namespace

Structure::Structure(const Tunnel& described)
    : tunnel(described),
      mesh(build_mesh(described)),
      mass(mesh.nodes.size()),
      stiffness(mesh.nodes.size()),
      load(kDofs * mesh.nodes.size()) {
  for (const int link : mesh.elements) {
    const Element element(tunnel.sections[mesh.links[link].section], mesh.nodes[link + 1] - mesh.nodes[link]);
    if (tunnel.inertia) assemble(mass, link, element.mass());
    assemble(stiffness, link, element.stiffness());
    const auto nodal = element.load();
    for (int i = 0; i < 2 * kDofs; ++i) load[kDofs * link + i] += nodal[i];
    elements.push_back(element);
  }
  if (tunnel.start == Portal::kFixed) fixed_nodes.push_back(0);
  if (tunnel.end == Portal::kFixed) fixed_nodes.push_back(mesh.nodes.size() - 1);
}

void Structure::fix(BlockTridiagonal& matrix) const {
  for (const std::size_t node : fixed_nodes) {
    matrix.diagonal[node].setIdentity();
    // A portal is the first or the last node and has one neighbour, so it has one block of coupling.
    matrix.lower[node == 0 ? 0 : node - 1].setZero();
  }
}

void Structure::clear_fixed(std::span<double> vector) const {
  for (const std::size_t node : fixed_nodes)
    for (int i = 0; i < kDofs; ++i) vector[kDofs * node + i] = 0;
}

SectionForces Structure::forces(std::size_t element, std::span<const double> u) const {
  const int link = mesh.elements[element];
  const Section& section = tunnel.sections[mesh.links[link].section];
  const Element& e = elements[element];
  const double *a = u.data() + kDofs * link, *b = a + kDofs, l = e.length();
  const auto curvature = [&](int rotation) { return (b[rotation] - a[rotation]) / l; };
  const auto shear = [&](Direction d, int rotation) {
    const BendingPlane& plane = e.plane(d);
    return 12 * plane.rigidity / ((1 + plane.shear_factor) * l * l) *
           ((b[d] - a[d]) / l - 0.5 * (a[rotation] + b[rotation]));
  };
  const double strain = (b[0] - a[0]) / l;
  const double bending =
      std::abs(curvature(3)) * section.half_width + std::abs(curvature(4)) * section.half_height;
  return {section.youngs_modulus * section.area * strain,
          e.plane(kLateral).rigidity * curvature(3),
          e.plane(kVertical).rigidity * curvature(4),
          shear(kLateral, 3),
          shear(kVertical, 4),
          strain - bending,
          strain + bending};
}

double Structure::middle(std::size_t element) const {
  return mesh.nodes[mesh.elements[element]] + 0.5 * elements[element].length();
}

double Structure::middle_displacement(std::size_t element, Direction d, std::span<const double> u) const {
  const double *a = u.data() + kDofs * mesh.elements[element], *b = a + kDofs;
  // Half-way between the nodes the shape functions of the rotations are l/8 and -l/8, whatever the shear.
  const double bulge = d == kAxial ? 0 : elements[element].length() / 8 * (a[d + 2] - b[d + 2]);
  return 0.5 * (a[d] + b[d]) + bulge;
}

double Structure::middle_rotation(std::size_t element, std::span<const double> u) const {
  const double* a = u.data() + kDofs * mesh.elements[element];
  const Shape middle = shape(elements[element].plane(kLateral), elements[element].length(), 0.5);
  double rotation = 0;
  for (std::size_t i = 0; i < kLateralDofs.size(); ++i) rotation += middle.rotation[i] * a[kLateralDofs[i]];
  return rotation;
}

}  // namespace adit::simplified::beam
