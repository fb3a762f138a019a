// The kernels of zones that remember reversals (hysteresis/reversals.hpp), where they stay on their piece.
#pragma once

#include "fdm_server/hysteresis/reversals.hpp"
#include "fdm_server/zones/batch/batch.hpp"
#include "fdm_server/zones/laws/hysteretic_axes.hpp"

namespace adit::fdm {

// Inner pieces of zones, from one zone on; share and spring are null where loops are Masing's.
struct InnerView {
  std::array<double*, kZoneStrains> strain, drift;
  double *radius, *end;
  const double *share, *spring;
};

// What a step makes of zones, over the shear modulus: the stress grows by after f2 - before f1 from the
// strain f1 to f2. Zones that leave their piece keep their strain and grow by nothing.
struct Advanced {
  alignas(64) BatchValues before, after;
  BatchValues dissipated;  // of a zone
  std::array<std::int64_t, kBatch> leaves;
};

// Fills all but the growth; says whether any zone leaves its piece.
bool stay_on_piece(const PolylineView& line, std::uint32_t count, const PointValues& areas,
                   const StrainBatch& strains, const InnerView& inner, Advanced& advanced);

// Takes strains and stresses to the end of the step; the axes are null where they have not turned.
void grow(const Elasticity& elasticity, std::uint32_t count, const StrainBatch& strains,
          const Advanced& advanced, const AxesView& axes, const InnerView& inner, const StressView& stresses);

}  // namespace adit::fdm
