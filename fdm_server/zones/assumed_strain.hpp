// Assumed-strain zone: one mean stress and two bending stresses (Belytschko & Bindeman 1991, Comput.
// Methods Appl. Mech. Eng. 88, the "QBI" field).
//
// The corner velocities split into a linear field and the hourglass pattern h = xi eta of amplitudes
//   q_x = gamma . v_x,  q_y = gamma . v_y,  gamma = 1/4 [h - (h.x) b_x - (h.y) b_y],
// b the mean gradient, so that q = 0 for every linear field on any quadrilateral (patch test). The hourglass
// pattern strains the zone by the assumed field
//   exx = h,x q_x - nu' h,y q_y,   eyy = h,y q_y - nu' h,x q_x,   gamma_xy = 0:
// in-plane bending without the parasitic shear that locks the bilinear zone, and without transverse stress,
// sxx = E' h,x q_x, syy = E' h,y q_y. Its energy 1/2 E' (H_xx q_x^2 + H_yy q_y^2 - 2 nu' H_xy q_x q_y), with
// H_ij = integral of h,i h,j dA, gives the generalized stresses
//   Q_x = E' (H_xx q_x - nu' H_xy q_y),   Q_y = E' (H_yy q_y - nu' H_xy q_x),
// and corner forces gamma Q. On rectangles this is the zone with incompatible modes of Wilson and Taylor.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "fdm_server/zones/columns.hpp"
#include "fdm_server/zones/mean_gradient.hpp"
#include "fdm_server/zones/zones.hpp"

namespace adit::fdm {

struct AssumedStrainShape {
  double area;
  MeanGradient gradient;
  std::array<double, 4> gamma;
  double hxx, hyy, hxy;
};
AssumedStrainShape assumed_strain_shape(const Corners& corners);

class AssumedStrainZones final : public Zones {
 public:
  AssumedStrainZones(const Grid& grid, const PlaneLaw& law, std::span<const double> weights);
  std::size_t count() const override { return state_.rows(); }
  std::span<const ZoneRun> runs() const override { return runs_; }
  using Zones::add_forces;
  void add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) override;
  void set_stress(std::size_t zone, const Stress& stress) override;
  double strain_energy() const override;
  Stress stress(std::size_t zone) const override;

 private:
  // p, t, s as in plane_law.hpp [Pa]; Q_x, Q_y [Pa m]
  enum Column { kMean, kDeviator, kShear, kBendingX, kBendingY, kWeight, kColumns };

  void strain_batch(const ZoneRun& run, std::uint32_t done, std::uint32_t count, double dt,
                    const PointView& points, CornerForces& forces);

  PlaneLaw law_;
  std::vector<AssumedStrainShape> shapes_;
  std::vector<ZoneRun> runs_;
  Columns<kColumns> state_;
};

}  // namespace adit::fdm
