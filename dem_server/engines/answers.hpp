// What an engine says of its particles, as counts and sums.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace adit::dem {

struct Counts {
  std::size_t particles, bonds;
};

// What bounds the time step: "bond", "joint", "spring", "contact", at (x, y) [m].
struct CriticalElement {
  double step;         // [s]
  double static_step;  // the smallest in statics, where no dashpots act
  const char* kind;
  double x, y;
  // Of the masses by which the static step is critical for all elements alike, in all stages [kg m/N].
  double mass_per_stiffness = 0;
};

// The bond with the largest |normal force| of a step, or where there are none the contact; unweighted.
struct Strongest {
  double force = 0, x = 0, y = 0;  // [N], [m]
};

// A name with its unit, and its value.
struct Figure {
  std::string name;
  double value;
};

struct EnergyShare {
  const char* name;
  double value;  // [J]
};

// At the step made last, weighted [J]; all but the first two since the start.
struct Energies {
  double kinetic = 0, strain = 0, external_work = 0, released = 0, dissipated = 0;
  std::vector<EnergyShare> shares;  // what some of these consist of
};

// How far the particles are from rest (wire.proto, message Relaxation).
struct Unrest {
  double unbalanced_force = 0, internal_force = 0;  // [N]
  std::size_t particles = 0, elements = 0;          // elements: bonds and contacts
  double largest = 0, x = 0, y = 0;                 // unbalanced force of a particle [N], and its place [m]
  double net_x = 0, net_y = 0;                      // of all that are not on quiet edges [N]
  double drag_x = 0, drag_y = 0;                    // of quiet edges against a unit velocity [N s/m]
  // The particle that has moved farthest in this stage [m], where it was at rest [m], and how many particles
  // are one body with it; none where the engine does not look at this step.
  struct Farthest {
    double distance, x, y;
    std::uint32_t group, body;
  };
  std::optional<Farthest> farthest{};
};

}  // namespace adit::dem
