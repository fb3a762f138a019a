// How well the zones carry waves.
//
// In a grid of zones of height h a plane wave of wave number k runs too slowly by (k h)^2 / 24: by 1.6 % with
// 10 zones a wavelength. Ten are the common advice (Kuhlemeyer and Lysmer 1973: 8 to 10); docs/boundaries.md
// says what they give.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/motion/motion.hpp"

namespace adit::fdm {

// The zone that carries least.
struct Resolution {
  double frequency;        // of which 10 zones are a wavelength of shear waves [Hz]
  double speed;            // of these waves, elastic and of small strain [m/s]
  double size;             // longest side of the zone [m]
  std::uint32_t material;  // its number
};

// Sides that reach across the whole grid do not count: there is nothing that could vary along them.
Resolution resolution(const Grid& grid, const Ground& ground);

// What the user should know if the motion of the base, if any, has frequencies that matter beyond that: up to
// its `high_corner`, or up to the frequency below which 99 % of its energy lies. Above this the root mean
// square of the acceleration is a tenth of the whole.
std::optional<std::string> note_on_resolution(const Resolution& resolution, const scene::Continuum& scene,
                                              const motion::Motion& motion);

}  // namespace adit::fdm
