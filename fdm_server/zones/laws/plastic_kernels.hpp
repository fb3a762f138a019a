// The kernels of zones with Mohr-Coulomb's strength, a weak plane or both: which zones are beyond their
// strength, and their return (cone_return.hpp, weak_plane.hpp, admissible.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fdm_server/materials/cone_return.hpp"
#include "fdm_server/materials/weak_plane.hpp"
#include "fdm_server/zones/batch/batch.hpp"

namespace adit::fdm {

using BatchFlags = std::array<std::int64_t, kBatch>;

// The cones of points that soften: fields of YieldCone in their order, each for the points in turn.
inline constexpr std::size_t kConeFields = 4;
using ConeFields = FieldArrays<4 * kConeFields>;

// What a material's zones have in common.
struct Plasticity {
  Elasticity elasticity;
  YieldCone cone;  // of points that do not soften; without limits where there is only a weak plane
  bool softens;
  bool has_plane;
  PlaneStrength plane;
};

struct ConeView {
  std::array<std::array<const double*, 4>, kConeFields> fields;  // null where nothing softens
};
struct DirectionView {
  const double *cosine, *sine;  // of the weak plane, PlaneDirection
};

// Which zones have a point beyond its strength, and how: bits. Returns those of all.
enum Outside : std::int64_t { kHolds = 0, kSheared = 1, kTorn = 3 };
// `strength`: by which the strength of each zone is multiplied; cones of points that soften have it already.
Outside find_outside(const Plasticity& law, std::uint32_t count, const StressView& stresses,
                     const ConeView& cones, const DirectionView& directions, const double* strength,
                     BatchFlags& outside);

// Zones that return together.
struct Returning {
  std::uint32_t count;
  // The elastic predictor and what is behind it: increments of strain, areas, cones, directions, factors of
  // strength.
  alignas(64) BatchValues mean, across, volume, cosine, sine, strength;
  PointValues difference, shear, strain_difference, strain_shear, area;
  std::array<PointValues, kConeFields> cones;
  // What becomes of each point: its stress, what its plastic shear strain grows by, and bits of Yield, kOpen
  // where neither closed form serves.
  PointValues to_mean, to_difference, to_shear, to_across, sheared;
  std::array<BatchFlags, 4> yields;
  // Of the zones that yield: the plastic work and what averaging takes, unweighted [J].
  BatchValues dissipated;

  PointStress predicted(std::size_t k, std::size_t i) const {
    return {mean[i], difference[k][i], shear[k][i], across[i]};
  }
  void set(std::size_t k, std::size_t i, const PointStress& to) {
    to_mean[k][i] = to.mean;
    to_difference[k][i] = to.difference;
    to_shear[k][i] = to.shear;
    to_across[k][i] = to.across;
  }
};

// Regions of the cone to which points return: F_13 alone, the point where all three stresses are at the
// cut-off, or any.
enum class Regions { kShearPlane, kCutOffPoint, kAll };
// Says whether any point stays open.
bool return_points(const Plasticity& law, Regions regions, Returning& zones);

// Averages the mean stresses of the points of zones that yield, which is what `mean` and `across` become, and
// adds up what they dissipate.
void average_and_dissipate(const Plasticity& law, Returning& zones);

}  // namespace adit::fdm
