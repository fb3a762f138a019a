// Stress and strain at a point in plane strain, where the stress across the plane takes part; isotropic
// elasticity. Tension positive.
#pragma once

#include <cmath>

namespace adit::fdm {

struct SolidStress {
  double xx, yy, zz, xy;  // [Pa]
};

inline SolidStress operator-(const SolidStress& a, const SolidStress& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy};
}
inline SolidStress operator+(const SolidStress& a, const SolidStress& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy};
}
inline SolidStress operator*(double factor, const SolidStress& s) {
  return {factor * s.xx, factor * s.yy, factor * s.zz, factor * s.xy};
}

// An increment of strain; xy is the engineering shear strain. Total strain has no zz, plastic strain may.
struct Strain {
  double xx, yy, zz, xy;
};

struct Elasticity {
  double bulk, shear;  // K, G [Pa]
  double lame() const { return bulk - 2 * shear / 3; }
};

inline Strain strain_of(const Elasticity& e, const SolidStress& stress) {
  const double mean = (stress.xx + stress.yy + stress.zz) / 3, compliance = 1 / (2 * e.shear);
  const double isotropic = mean / (3 * e.bulk) - mean * compliance;
  return {isotropic + stress.xx * compliance, isotropic + stress.yy * compliance,
          isotropic + stress.zz * compliance, 2 * compliance * stress.xy};
}

// Power per volume, or twice the energy where the strain is that of the stress.
inline double product(const SolidStress& stress, const Strain& strain) {
  return stress.xx * strain.xx + stress.yy * strain.yy + stress.zz * strain.zz + stress.xy * strain.xy;
}

// Elastic energy per volume [J/m^3].
inline double elastic_energy(const Elasticity& e, const SolidStress& stress) {
  return product(stress, strain_of(e, stress)) / 2;
}

// The engineering shear strain of simple shear that has the same second invariant: sqrt(2 e.e), e the
// deviator.
inline double shear_measure(const Strain& s) {
  const double mean = (s.xx + s.yy + s.zz) / 3;
  const double x = s.xx - mean, y = s.yy - mean, z = s.zz - mean;
  return std::sqrt(2 * (x * x + y * y + z * z) + s.xy * s.xy);
}

// Turns the plane counter-clockwise by the angle whose cosine and sine are given.
inline SolidStress turned(const SolidStress& s, double cosine, double sine) {
  const double c2 = cosine * cosine - sine * sine, s2 = 2 * cosine * sine;
  const double p = (s.xx + s.yy) / 2, t = (s.xx - s.yy) / 2;
  const double turned_t = c2 * t - s2 * s.xy;
  return {p + turned_t, p - turned_t, s.zz, s2 * t + c2 * s.xy};
}

// The same by the mean of xx and yy, half their difference xx - yy, xy and zz: what turns with the plane
// stands apart.
struct PointStress {
  double mean, difference, shear, across;
};
inline PointStress point_stress(const SolidStress& s) {
  return {(s.xx + s.yy) / 2, (s.xx - s.yy) / 2, s.xy, s.zz};
}
inline SolidStress solid_stress(const PointStress& s) {
  return {s.mean + s.difference, s.mean - s.difference, s.across, s.shear};
}

// What yields, as bits: now in the last step, past ever before. Hysteretic ground has no limit to yield at:
// its stiffness falls from the smallest strains on.
enum Yield : unsigned {
  kElastic = 0,
  kShearNow = 1,
  kTensionNow = 2,
  kShearPast = 4,
  kTensionPast = 8,
  kSlipNow = 16,
  kOpeningNow = 32,
  kSlipPast = 64,
  kOpeningPast = 128,
  kHysteretic = 256,
};

}  // namespace adit::fdm
