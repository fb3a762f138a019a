// A stretch of a bolt between two grid points: it carries thrust only, and yields in tension and compression.
// Lumped masses rho A l/2; its one frequency is that of the axial wave, omega^2 = 2 EA/(l m), 2/omega = l/c.
#pragma once

#include <array>
#include <cstdint>

#include "fdm_server/structures/beam.hpp"
#include "fdm_server/structures/yielding_spring.hpp"

namespace adit::fdm {

struct BarSection {
  double axial;  // E A [N]
  double yield;  // largest thrust [N]
  double mass;   // rho A [kg/m]
};

class Bar {
 public:
  Bar(std::array<std::uint32_t, 2> points, const Chord& chord, const BarSection& section)
      : points_(points),
        chord_(chord),
        spring_(section.axial / chord.length, section.yield),
        mass_(section.mass * chord.length / 2) {}

  const std::array<std::uint32_t, 2>& points() const { return points_; }
  double end_mass() const { return mass_; }
  double critical_step() const;
  StrainForm strain() const;

  // As a beam's; returns what it dissipates [J].
  double add_forces(double dt, const PointView& points);

  double thrust() const { return spring_.force(); }
  double strain_energy() const { return spring_.strain_energy(); }

  void exchange(state::Archive& archive) { spring_.exchange(archive); }

 private:
  std::array<std::uint32_t, 2> points_;
  Chord chord_;
  YieldingSpring spring_;
  double mass_;
};

}  // namespace adit::fdm
