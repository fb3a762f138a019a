// Mixed-discretization zone of FLAC (Marti & Cundall 1982, Int. J. Numer. Anal. Methods Geomech. 6): two
// overlays of two constant-strain triangles, (0 1 2)(0 2 3) and (0 1 3)(1 2 3). The isotropic part of the
// strain is averaged over each overlay's pair by area; corner forces are the mean of the two overlays.
//
// The triangles have the quadrilateral's straight sides, hence the area integral of div v is the same
// boundary integral in both overlays, and equals that of the bilinear field: the averaged isotropic strain is
// the mean gradient's. So p is one value a zone, with the forces of the mean gradient, and the deviatoric
// stresses t, s (plane_law.hpp) live on the four triangles, each counted half.
//
// Too stiff in bending where zones are large, because the triangles' deviatoric strain locks: n rows of zones
// of width a and height b have a section stiffer by (3 mu/E' (1 + a^2/b^2) - 1)/n^2.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "fdm_server/zones/columns.hpp"
#include "fdm_server/zones/mean_gradient.hpp"
#include "fdm_server/zones/zones.hpp"

namespace adit::fdm {

inline constexpr std::array<std::array<std::size_t, 3>, 4> kTriangles{
    {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}};

// Gradient in a triangle of a field that is 0 at its first corner: from the differences to the other two.
struct TriangleGradient {
  double x1, x2, y1, y2;  // [1/m]
};

struct MixedDiscretizationShape {
  double area;
  MeanGradient gradient;
  std::array<TriangleGradient, 4> triangles;  // in the order above
  std::array<double, 4> areas;
};
MixedDiscretizationShape mixed_discretization_shape(const Corners& corners);

class MixedDiscretizationZones final : public Zones {
 public:
  MixedDiscretizationZones(const Grid& grid, const PlaneLaw& law, std::span<const double> weights);
  std::size_t count() const override { return state_.rows(); }
  std::span<const ZoneRun> runs() const override { return runs_; }
  using Zones::add_forces;
  void add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) override;
  void set_stress(std::size_t zone, const Stress& stress) override;
  double strain_energy() const override;
  Stress stress(std::size_t zone) const override;

 private:
  // p; then t of each triangle, s of each triangle [Pa]
  enum Column { kMean, kDeviator, kShear = kDeviator + 4, kWeight = kShear + 4, kColumns };

  void strain_batch(const ZoneRun& run, std::uint32_t done, std::uint32_t count, double dt,
                    const PointView& points, CornerForces& forces);

  PlaneLaw law_;
  std::vector<MixedDiscretizationShape> shapes_;
  std::vector<ZoneRun> runs_;
  Columns<kColumns> state_;
};

}  // namespace adit::fdm
