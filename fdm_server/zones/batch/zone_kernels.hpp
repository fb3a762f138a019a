// The kernels that all laws share: from displacements of the corners to strains, from stresses to corner
// forces, and the geometry of zones in large strain (sampling_shape.hpp, nonlinear_zones.hpp).
#pragma once

#include <cstdint>

#include "fdm_server/materials/solid.hpp"
#include "fdm_server/zones/batch/batch.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"

namespace adit::fdm {

// Strains from what the corners moved in a step.
void find_strains(ZoneKind kind, std::uint32_t count, const ShapeBatch& shapes, const CornerVectors& moved,
                  StrainBatch& strains);

// Adds the elastic stress of the strains.
void add_elastic(std::uint32_t count, const Elasticity& elasticity, const StrainBatch& strains,
                 const StressView& stresses);

// Elastic energy of each zone over the areas of its points, unweighted [J].
void find_energies(std::uint32_t count, const Elasticity& elasticity, const PointValues& areas,
                   const ConstStressView& stresses, BatchValues& energies);

// Stresses of zones from those of their points.
void mean_stresses(std::uint32_t count, const PointValues& areas, const ConstStressView& stresses,
                   PlaneStresses& means);
// |stress| of each zone, its Frobenius norm [Pa].
void stress_sizes(std::uint32_t count, const PlaneStresses& stresses, BatchValues& sizes);

// Corner forces of weighted stresses that belong to the areas of `reference`, at zones that have the shape
// `now`.
void find_forces(ZoneKind kind, std::uint32_t count, const ShapeBatch& reference, const ShapeBatch& now,
                 const ConstStressView& stresses, const double* weights, CornerForces& forces);

// Shapes of zones whose corners are at reference + displacements - `behind` times the step's. A zone that is
// turned inside out has no shape: values that are not finite, at which the run stops.
struct DeformedCorners {
  std::array<const double*, 4> x, y;  // reference
  const CornerVectors& displacements;
  const CornerVectors& moved;
};
void find_shapes(ZoneKind kind, std::uint32_t count, const DeformedCorners& corners, double behind,
                 double bending_factor, ShapeBatch& shapes);

// Half the turn of the ground in a step, as the cosine and sine of twice this half, by which stress turns.
struct HalfTurns {
  alignas(64) BatchValues cosine, sine;
};
void find_half_turns(std::uint32_t count, const ShapeBatch& shapes, const CornerVectors& moved,
                     HalfTurns& turns);
void turn(std::uint32_t count, const HalfTurns& turns, const StressView& stresses);

}  // namespace adit::fdm
