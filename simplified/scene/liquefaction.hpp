// Sand of the scene's ground that may liquefy, and what its pore pressure does to the tunnel.
#pragma once

#include <optional>
#include <vector>

#include "protocol/messages/scene.pb.h"
#include "simplified/scene/excitation.hpp"

namespace adit::simplified {

// The numbers of the layers that state a resistance in at least one profile.
std::vector<int> liquefiable_layers(const scene::Ground& ground);
bool may_liquefy(const scene::Simplified& scene);

// Throws UserError if a layer may liquefy, but the water table is not given, the shaking does not pass
// through the ground, or the sand bears no effective pressure.
void check_liquefaction(const scene::Simplified& scene);

// The part of a layer below the water table, in one profile.
struct WetSand {
  double top, bottom;  // below the surface [m]
  double resistance;   // amplitude of shear stress in its middle that liquefies it in 15 cycles [Pa]
  double exponent;
  double middle() const { return (top + bottom) / 2; }
};

// Absent if the layer does not liquefy there, or lies above the water table.
std::optional<WetSand> wet_sand(const scene::Ground& ground, const scene::SoilProfile& profile, int layer);

// Lets the pressure of every layer of `field` rise with its shear stress. The stress is that in the direction
// in which the rock shakes: one motion moves it in all directions.
void raise_pressure(const scene::Simplified& scene, GroundField& field);

// The pressure ratio that the tunnel feels, at the places of the field and at every step: the mean over the
// height of its section, over which the springs' stiffness is averaged, too (ground.hpp). Ground that cannot
// liquefy counts with 0.
std::vector<double> pressure_at_tunnel(const scene::Simplified& scene, const GroundField& field);

// The vertical load on the tunnel in liquefied ground [N/m], upward if positive: (rho A - m) g, where A is
// the outer area of the section, m its mass per metre, and rho the mean density of the ground within its
// height.
//
// At rest water and ground bear the weight m g: the water rho_w g A, contact stresses the rest. With the
// pressure ratio r the pressure of the water at a depth is u + r sigma', of which u is that at rest; by its
// slope, rho_w g + r (rho - rho_w) g, it bears rho_w g A + r (rho - rho_w) g A. Contact stresses fall as the
// effective stress does, by 1 - r. What is left over is r (rho A - m) g, linear in r.
double uplift(const scene::Simplified& scene, double chainage, const scene::Section& section);

}  // namespace adit::simplified
