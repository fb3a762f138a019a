// What the kernels of zones with a law pass on, for a batch of zones at a time: structures of arrays, one
// value a zone, kept in the first-level cache.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fdm_server/grid/field_arrays.hpp"
#include "fdm_server/zones/batch/sampling_shape.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"

namespace adit::fdm {

using BatchValues = std::array<double, kBatch>;
using PointValues = std::array<BatchValues, 4>;  // of each of a zone's points, or corners

// Vectors at the corners.
struct CornerVectors {
  alignas(64) PointValues x, y;
};

struct ShapeBatch {
  alignas(64) BatchValues area, x0, x1, y0, y1, c0, c1;
  PointValues point_area, gx, gy;

  [[gnu::always_inline]] void set(std::size_t i, const SamplingShape& shape) {
    area[i] = shape.area;
    x0[i] = shape.x0;
    x1[i] = shape.x1;
    y0[i] = shape.y0;
    y1[i] = shape.y1;
    c0[i] = shape.c0;
    c1[i] = shape.c1;
    for (std::size_t k = 0; k < 4; ++k) {
      point_area[k][i] = shape.points[k].area;
      gx[k][i] = shape.points[k].gx;
      gy[k][i] = shape.points[k].gy;
    }
  }
};

// Increments of strain: exx + eyy of the zones, exx - eyy and gamma_xy of their points.
struct StrainBatch {
  alignas(64) BatchValues volume;
  PointValues difference, shear;
};

// Stress of zones: the in-plane mean (sxx + syy)/2 and szz, which a zone's points share, (sxx - syy)/2 and
// sxy of each point [Pa].
enum StressField : std::size_t {
  kMeanStress,
  kAcross,
  kDifference,
  kShearStress = kDifference + 4,
  kStressFields = kShearStress + 4
};
using StressFields = FieldArrays<kStressFields>;

// From one zone on.
template <class Value>
struct StressViewOf {
  Value *mean, *across;
  std::array<Value*, 4> difference, shear;
};
using StressView = StressViewOf<double>;
using ConstStressView = StressViewOf<const double>;
template <class Fields, class View = std::conditional_t<std::is_const_v<Fields>, ConstStressView, StressView>>
View view(Fields& fields, std::size_t first) {
  View result{&fields[kMeanStress][first], &fields[kAcross][first], {}, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    result.difference[k] = &fields[kDifference + k][first];
    result.shear[k] = &fields[kShearStress + k][first];
  }
  return result;
}

}  // namespace adit::fdm
