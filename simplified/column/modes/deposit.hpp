// A horizontally layered soil deposit on rock, shaken by waves that travel vertically.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace adit::simplified::column {

struct Layer {
  double thickness;       // [m]
  double density;         // [kg/m^3]
  double wave_velocity;   // [m/s]: V_s for horizontal motion, V_p for vertical motion
  double damping = 0.05;  // hysteretic damping ratio xi: the modulus is rho V^2 (1 + 2 i xi)
  // chi: the modulus that resists differences between neighbouring columns over modulus(), see
  // joined_columns.hpp.
  double modulus_ratio = 1;

  double modulus() const { return density * wave_velocity * wave_velocity; }  // [Pa]
  double impedance() const { return density * wave_velocity; }                // [Pa s/m]
  bool operator==(const Layer&) const = default;
};

// The half-space below the deposit: elastic, without damping.
struct Rock {
  double density;            // [kg/m^3]
  double wave_velocity;      // [m/s]
  double modulus_ratio = 1;  // as of a layer

  double modulus() const { return density * wave_velocity * wave_velocity; }  // [Pa]
  double impedance() const { return density * wave_velocity; }                // [Pa s/m]
  bool operator==(const Rock&) const = default;
};

// Depths z are measured downwards from the surface [m].
struct Deposit {
  std::vector<Layer> layers;  // from the surface down
  // If absent, the rock is rigid and the given motion is that of the deposit's base. If present, the rock is
  // elastic and the given motion is that of its outcrop, twice the rising wave.
  std::optional<Rock> rock;

  double thickness() const;  // H [m]
  double mass() const;       // per area [kg/m^2]
  bool operator==(const Deposit&) const = default;
};

// Throws protocol::UserError, at `path` + ".layers[i].thickness" and the like, if the deposit has no layers,
// a value is not positive and finite, or a damping ratio lies outside 0 <= xi < 0.5.
void check(const Deposit& deposit, const std::string& path);

}  // namespace adit::simplified::column
