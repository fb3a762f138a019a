// A beam of reinforced concrete: its forces follow from fibres at two sections.
//
// The ends move as those of beam.hpp, with the strains e, b, a. Its two sections are Gauss's points, s = l/2
// (1 -+ 1/sqrt 3), and the curvature is linear between the ends, as in the static solution of a beam without
// load:
//   kappa = b/l -+ c/sqrt 3,   c = 3 a_b/l,   a = a_b + a_s
// with a_b the part of a that bends and a_s that which shears. Strains are counted at the elastic centroid
// (fibre_section.hpp), M about it, e being the elongation there:
//   eps = e/l -+ eta.
// eta and a_b are free within the beam: eta so that both sections carry the same thrust, and a_b so that
// bending and shear carry the same S. Then
//   N = (N_1 + N_2)/2,   B = (M_1 + M_2)/2,   S_b = sqrt 3/2 (M_2 - M_1),   S_s = k_s a_s,   k_s = G A_s l/4.
// In the elastic beam eta = 0 and a_b = a/(1 + phi); of every step's strain they take this share, and besides
// one elastic step towards equilibrium,
//   d eta = -(N_2 - N_1)/(2 E A),   d a_b = (S_s - S_b)/(3 E I/l + k_s).
// By virtual work S = (S_b + phi S_s)/(1 + phi). What the two corrections take up, (N_1 - N_2) l/2 d eta +
// (S_s - S_b) d a_b, is positive: they dissipate, and vanish with the mismatch. No system of equations is
// solved, and since no fibre is stiffer than at first, the tangent of the step never exceeds the elastic
// stiffness: the critical step and mean_acceleration.hpp are those of the elastic beam.
//
// Dissipated since the start: the work of the ends, dt times the strain rates times the mean of the forces of
// two steps as in the ledger of continuum.hpp, less what fibres and shear store.
#pragma once

#include <array>
#include <memory>

#include "fdm_server/structures/beam.hpp"
#include "protocol/sections/fibre_section.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

// The section that the elastic beam has at first.
Section elastic_section(const sections::FibreSection& section, double shear_modulus, double density,
                        bool shear_flexible);

class FibreBeam {
 public:
  FibreBeam(const Beam& beam, std::shared_ptr<const sections::FibreSection> section);

  // Adds a step's strains; the forces of the ends.
  BeamResultants strain(const BeamStrains& step);

  double stored() const;  // [J]
  double dissipated() const { return work_ - stored(); }
  void forget_dissipation() { work_ = stored(); }

  const sections::FibreSection& section() const { return *section_; }
  // The section near the first end, near the second; curvatures at the ends.
  const sections::FibreStates& states(std::size_t end) const { return states_[end]; }
  double curvature(std::size_t end) const;

  void exchange(state::Archive& archive);

 private:
  std::shared_ptr<const sections::FibreSection> section_;
  double length_, phi_;
  std::array<sections::FibreStates, 2> states_;
  double elongation_ = 0, turn_ = 0;   // e at the centroid, b
  double bent_ = 0, sheared_ = 0;      // a_b, a_s
  double difference_ = 0;              // eta
  BeamResultants forces_{};            // of the ends, at the axis
  double thrusts_ = 0, mismatch_ = 0;  // N_2 - N_1, S_s - S_b
  double work_ = 0;
};

}  // namespace adit::fdm
