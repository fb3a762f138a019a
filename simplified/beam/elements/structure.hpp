// The parts of the model that do not change during a run: mesh, elements, mass, linear stiffness, static
// loads, prescribed nodes.
#pragma once

#include <span>
#include <vector>

#include "simplified/beam/elements/block_tridiagonal.hpp"
#include "simplified/beam/elements/element.hpp"
#include "simplified/beam/model/mesh.hpp"

namespace adit::simplified::beam {

// Stress resultants at the middle of an element; tension positive, M = EI dψ/dx, V = G A_s (du/dx − ψ) =
// −dM/dx.
struct SectionForces {
  double axial = 0, moment_lateral = 0, moment_vertical = 0, shear_lateral = 0, shear_vertical = 0;
  double strain_low = 0, strain_high = 0;  // axial strains of the outermost fibres
};

struct Structure {
  // The tunnel must have been checked, and must outlive this object.
  explicit Structure(const Tunnel& tunnel);

  const Tunnel& tunnel;
  Mesh mesh;
  std::vector<Element> elements;
  BlockTridiagonal mass;       // zero if inertia is switched off
  BlockTridiagonal stiffness;  // stiffness of the lining
  std::vector<double> load;    // [N] [N m] by degree of freedom
  std::vector<std::size_t> fixed_nodes;

  std::size_t dofs() const { return kDofs * mesh.nodes.size(); }
  void fix(BlockTridiagonal& matrix) const;  // rows of prescribed nodes become those of the identity
  void clear_fixed(std::span<double> vector) const;
  SectionForces forces(std::size_t element, std::span<const double> u) const;
  double middle(std::size_t element) const;  // [m] chainage
  double middle_displacement(std::size_t element, Direction direction, std::span<const double> u) const;
  double middle_rotation(std::size_t element, std::span<const double> u) const;  // ψ_y [rad]
};

}  // namespace adit::simplified::beam
