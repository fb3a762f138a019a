// The strains of a beam, bar or joint as linear forms of what moves: with e = sum of factors times
// displacements and rotations, the energy of each is stiffness e^2/2, whatever yields.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace adit::fdm {

// A component of a point's motion, or a rotation.
struct Freedom {
  enum Kind : std::uint8_t { kX, kY, kRotation, kKinds } kind;
  std::uint32_t number;  // of the point or rotation
  auto operator<=>(const Freedom&) const = default;
};

// One value a freedom: a column a kind.
using Motions = std::array<const double*, Freedom::kKinds>;
using Actions = std::array<double*, Freedom::kKinds>;

struct StrainForm {
  double stiffness;
  struct Share {
    Freedom of;
    double factor;
  };
  std::vector<Share> shares;
};

}  // namespace adit::fdm
