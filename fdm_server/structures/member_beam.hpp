// A beam of a member: it follows its present chord (second order), may slide in shear and may be lost.
//
// Strains e, b, a and forces N, B, S are those of beam.hpp, counted from the chord as it lies: with its
// length L and its turn psi since it was installed (Crisfield 1991, Non-linear Finite Element Analysis
// 1, 7.3),
//   e = L - l + l (a^2/(40 (1 + phi)^2) + b^2/24),   b = theta_2 - theta_1,   a = theta_1 + theta_2 - 2 psi.
// The last part of e is the mean of (w' - psi)^2/2 over the bent beam, so that thrust changes the stiffness
// of a beam between its ends, too. From the energy of these strains the ends get N along the chord and
//   B + N l b/12,   S + N l a/(20 (1 + phi)^2),
// and with this S the shear force -2 S/L. A column of eight beams buckles under Euler's load (P-delta).
//
// Sliding: the beam passes on no more than the strength V, |S| <= V l/2. What the beam within bears above it
// becomes slip, taken off its strain a in the next step, as in fibre_beam.hpp. A lost beam bears nothing.
//
// Dissipated since the start: the work of the ends, dt times their velocities times the mean of the forces of
// two steps as in the ledger of continuum.hpp, less what is stored within. Without yield, slip and loss it
// holds what the mean of forces misses of the curved path, l dN dpsi^2/4 a step and the like: it falls with
// dt^2.
//
// Mean acceleration and critical step need stiffnesses that bound the tangent's (mean_acceleration.hpp).
// While the chord has turned by at most kTurn, (e + psi w)^2 <= (1 + r) e^2 + (1 + 1/r) psi^2 w^2 with w the
// motion of one end across the other, and likewise for a; a thrust in tension adds N w^2/L. Hence the strains
// have (1 + r) of their stiffness, and w one of kAcross E A/l: for r = 1/4 and kTurn = 0.075 that leaves 2e-3
// of axial strain in tension.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fdm_server/structures/beam.hpp"
#include "fdm_server/structures/fibre_beam.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class MemberBeam {
 public:
  explicit MemberBeam(const Beam& beam, std::shared_ptr<const sections::FibreSection> section = nullptr);

  // Those that bound the present stiffness of this beam.
  static std::vector<StrainForm> strains(const Beam& beam);
  static double critical_step(const Beam& beam);

  // As a beam's.
  void add_forces(Beam& beam, double dt, const PointView& points, const RotationView& rotations);

  const FibreBeam* fibres() const { return fibres_ ? &*fibres_ : nullptr; }
  const Chord& chord() const { return chord_; }  // as it lies
  double stored() const;                         // [J]
  double dissipated() const { return work_ - stored(); }
  void forget_dissipation() { work_ = stored(); }

  // From now on at most this shear force passes [N].
  void limit_shear(double strength) { strength_ = strength; }
  double slip() const { return slip_; }  // the sum of its sizes [m]
  void lose() { lost_ = true; }

  void exchange(state::Archive& archive);

 private:
  struct Ends {
    double x = 0, y = 0;  // force on the first point, minus that on the second [N]
    double b = 0, s = 0;
  };
  BeamResultants respond(const Beam& beam, const BeamStrains& step);
  BeamResultants slide(const Beam& beam, BeamResultants forces);

  std::optional<FibreBeam> fibres_;
  const double length_, share_;  // l, 1/(1 + phi)^2
  Chord chord_;
  double b_ = 0, a_ = 0;
  BeamResultants within_{};  // of the elastic beam
  double elastic_energy_ = 0;
  double strength_, pending_ = 0, slip_ = 0;  // pending: of a, to be taken off [rad]
  bool lost_ = false;
  Ends ends_{};
  double work_ = 0;
};

}  // namespace adit::fdm
