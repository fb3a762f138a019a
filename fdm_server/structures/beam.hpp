// A straight beam between two grid points: thrust, moment and shear by increments.
//
// An end shares the velocity of its grid point and has a rotation theta of its own, counter-clockwise; s runs
// along the beam from its first point, n to its left. Three strains are left of the six velocities of the
// ends once rigid motion is taken out:
//   elongation             e = u_2 - u_1
//   bending                b = theta_2 - theta_1
//   antisymmetric bending  a = theta_1 + theta_2 - 2 (w_2 - w_1)/l        (u along s, w along n)
// The exact static solution of Timoshenko's beam without load between its ends (Przemieniecki 1968) is
// uncoupled in them:
//   N = EA/l e,   B = EI/l b,   S = 3 EI/(l (1 + phi)) a,   phi = 12 EI/(G A_s l^2)
// with phi = 0 that of Euler and Bernoulli. Forces on the ends are minus the derivatives of the energy
// N^2 l/2EA + …; in the beam the thrust is N, the moment M(s) = B - S + 2 S s/l = EI dtheta/ds, the shear
// force (along n, on the section that looks along s) Q = -dM/ds = -2 S/l. A positive moment stretches the
// right-hand side of the path: the ground's side of a tunnel that the path rounds counter-clockwise.
//
// Masses are lumped: m = rho A l/2 at either end, and a rotary inertia J. The three strains do not share
// inertia (their gradients are orthogonal in the inverse masses), so that the frequencies of the free beam
// are those of each alone:
//   omega_e^2 = 2 EA/(l m),   omega_b^2 = 2 EI/(l J),   omega_a^2 = 3 EI/(l (1 + phi)) (8/(m l^2) + 2/J).
// With J = 3 rho I l/2, three times the section's own, omega_b^2 is a third of omega_e^2, and omega_a^2 is
// omega_e^2 (1 + 12 r^2/l^2)/(1 + phi), r^2 = I/A: at most omega_e^2, because 12 EI/(G A_s l^2) >= 12 r^2/l^2
// for every nu >= -1/2. So rotation never governs and the critical step is that of the axial wave, l/c;
// without shear flexibility it is shorter by sqrt(1 + 12 r^2/l^2), which tells in beams shorter than thick.
// Where the elastic centroid lies beside the axis, by z, the elongation there is e + z b, and the energy is
// uncoupled in it, b and a; omega^2 of the first two is then the larger root of their two equations.
// Where the axis lies beside the path, by d, its elongation is e + d b of the points; the mass there brings
// d^2 times itself to J.
// The price is three times the rotary inertia in waves: bending waves of wave number k are slower by the
// share 3/2 (k r)^2 instead of 1/2 (k r)^2, by 1.2 % instead of 0.4 % where they are 20 times as long as the
// lining is thick. Statics do not change.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "fdm_server/structures/strain_form.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

// What a beam's section resists with, per metre of thickness of the plane.
struct Section {
  double axial;    // E A [N]
  double bending;  // E I [N m^2]
  double shear;    // G A_s [N]; infinite: sections stay at right angles to the axis (Euler-Bernoulli)
  double mass;     // rho A [kg/m]
  double rotary;   // rho I [kg m]
  // How far the elastic centroid lies to the right of the axis, of a section whose bars are not alike on both
  // sides [m]; then E I is about the centroid.
  double eccentricity = 0;
  double offset = 0;  // how far the axis lies to the right of the path [m]
};

// A lining's material. In plane strain E / (1 - nu^2) replaces E, because the lining cannot strain along the
// tunnel; the shear modulus E / (2 (1 + nu)) stays.
struct LiningMaterial {
  double young;  // E, or E / (1 - nu^2) [Pa]
  double shear;  // G [Pa]
  double density;
};
inline LiningMaterial lining_material(bool plane_strain, double young, double poisson, double density) {
  return {plane_strain ? young / (1 - poisson * poisson) : young, young / (2 * (1 + poisson)), density};
}

// A section of area A and moment of inertia I; 5/6 of the area carries shear, as in a rectangle.
inline Section make_section(const LiningMaterial& material, double area, double inertia,
                            bool shear_flexible) {
  constexpr double kShearShare = 5.0 / 6;
  return {material.young * area, material.young * inertia,
          shear_flexible ? kShearShare * material.shear * area : std::numeric_limits<double>::infinity(),
          material.density * area, material.density * inertia};
}

// What the kernels read and add to, one value a rotation.
struct RotationView {
  const double* rate;  // [rad/s]
  double* couple;      // [N m]
};

// From the first point to the second.
struct Chord {
  double x, y;  // unit vector
  double length;
};
Chord chord(double x1, double y1, double x2, double y2);

// The three strains, or their rates; the forces that do work on them, N, B and S.
struct BeamStrains {
  double e, b, a;
};
struct BeamResultants {
  double n, b, s;
};
inline BeamResultants operator+(const BeamResultants& a, const BeamResultants& b) {
  return {a.n + b.n, a.b + b.b, a.s + b.s};
}

struct BeamForces {
  double thrust;         // tension positive [N]
  double shear;          // Q [N]
  double first, second;  // M at the two ends [N m]
};

class Beam {
 public:
  Beam(std::array<std::uint32_t, 2> points, std::array<std::uint32_t, 2> rotations, const Chord& chord,
       const Section& section);

  const std::array<std::uint32_t, 2>& points() const { return points_; }
  const std::array<std::uint32_t, 2>& rotations() const { return rotations_; }
  const Chord& chord() const { return chord_; }
  double end_mass() const { return mass_; }        // at either end [kg]
  double end_inertia() const { return inertia_; }  // J [kg m^2]
  double critical_step() const;                    // 2/omega of the free beam [s]
  std::array<StrainForm, 3> strains() const;       // e of the elastic centroid, b, a
  double shear_flexibility() const { return phi_; }

  // Adds the strain of dt times the velocities to the forces, and these to those of the points and rotations.
  void add_forces(double dt, const PointView& points, const RotationView& rotations);
  // The same for a beam whose forces follow other laws (fibre_beam.hpp): its rates of strain, and the forces
  // N, B, S to add, along its chord or this one.
  BeamStrains rates(const PointView& points, const RotationView& rotations) const;
  void add_forces(const BeamResultants& forces, const PointView& points, const RotationView& rotations) {
    add_forces(forces, chord_, points, rotations);
  }
  void add_forces(const BeamResultants& forces, const Chord& along, const PointView& points,
                  const RotationView& rotations);
  const BeamResultants& resultants() const { return forces_; }
  // What these strains add to them in the elastic beam, and what it stores with such forces [J].
  BeamResultants resists(const BeamStrains& strains) const;
  double elastic_energy(const BeamResultants& forces) const;

  BeamForces forces() const;
  double strain_energy() const { return elastic_energy(forces_); }

  void exchange(state::Archive& archive) {
    archive("beam_n", forces_.n);
    archive("beam_b", forces_.b);
    archive("beam_s", forces_.s);
  }

 private:
  std::array<std::uint32_t, 2> points_, rotations_;
  Chord chord_;
  double axial_, bending_, shear_;  // stiffness of e [N/m], of b and a [N m]
  double mass_, inertia_, phi_, eccentricity_, offset_;
  BeamResultants forces_{};
};

}  // namespace adit::fdm
