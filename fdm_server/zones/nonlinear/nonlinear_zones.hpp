// Zones of one material with a law beyond linear elasticity, or in large strain: strain increments at the
// sampling points, the law, corner forces. Of either kind (sampling_shape.hpp).
//
// The in-plane mean stress is shared: the four points have one change of volume, and corner forces see their
// mean stress only. Where a law dilates, each point would ask for a change of volume of its own; as in mixed
// discretization (Marti & Cundall 1982) the mean stresses are averaged after the law, so that it is asked for
// in the mean.
//
// Energy: with corner forces f of step n the leap-frog scheme books the work of (f(n) + f(n+1))/2. Here it is
// sum (s(n) + s(n+1))/2 : de over the points. Beside the change of the elastic energy of s it holds the
// plastic work (s(n) + s(n+1))/2 : (de - C^-1 ds), and what averaging takes; so that the ledger closes to
// rounding. Both are >= 0 (the plastic work as long as the stress changes in a step by less than the
// strength, as where waves are resolved).
//
// Large strain: the increment of strain and the turn of the ground come from the coordinates half way through
// the step (Hughes & Winget 1980, Int. J. Numer. Meth. Eng. 15): rigid motion, however far a step turns,
// strains nothing. The stress turns by half before the law and by half after it, which keeps second order.
// What turns and grows is Kirchhoff's stress, tau = J sigma, whose power belongs to undeformed area: with the
// corotated rate its elastic energy is a function of the state. Forces take the coordinates at the end of the
// step, so that the booked work differs from the points' by second order in dt.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/materials/material.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"
#include "fdm_server/zones/nonlinear/sampling_shape.hpp"

namespace adit::fdm {

class NonlinearZones final : public ZoneKernel {
 public:
  // Plane strain.
  NonlinearZones(ZoneKind kind, const Grid& grid, const Material& material, std::span<const double> weights,
                 bool large_strain);

  std::size_t count() const override { return weights_.size(); }
  std::span<const ZoneRun> runs() const override { return runs_; }
  void follow(const double* ux, const double* uy) override;
  using ZoneKernel::add_forces;
  void add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) override;
  void set_stress(std::size_t zone, const Stress& stress) override;
  void set_stress_zz(std::size_t zone, double zz) override;
  void remove(const std::vector<bool>& gone) override;
  void start_over() override;
  double strain_energy() const override;
  double dissipated() const override;
  Stress stress(std::size_t zone) const override;
  double field(std::size_t zone, ZoneField field) const override;

 private:
  struct Point {
    SolidStress stress{};
    double plastic_shear_strain = 0;
    unsigned yield = kElastic;
  };
  struct Turn {  // counter-clockwise
    double cosine, sine, angle;
  };

  void strain_zone(std::size_t zone, const SamplingShape& reference, const SamplingShape& during,
                   const CornerValues& dx, const CornerValues& dy);
  void turn_zone(std::size_t zone, const Turn& turn);
  void add_corner_forces(std::size_t zone, const SamplingShape& reference, const SamplingShape& now,
                         CornerValues& fx, CornerValues& fy) const;
  // Advances one point; returns the plastic work per volume.
  double strain_point(Point& point, std::span<double> memory, const Strain& strain, double turned);
  void average_mean_stress(std::size_t zone, const SamplingShape& shape);
  std::span<double> memory(std::size_t zone, std::size_t k);
  std::span<const double> memory(std::size_t zone, std::size_t k) const;

  ZoneKind kind_;
  Material material_;
  Elasticity elasticity_;
  PlaneLaw plane_law_;
  bool large_strain_;
  std::vector<ZoneRun> runs_;
  std::vector<Corners> corners_;         // of each shape; in large strain of each zone
  std::vector<SamplingShape> shapes_;    // undeformed
  std::vector<std::uint32_t> shape_of_;  // of each zone
  std::vector<ZonePoints> zone_points_;  // of each zone, in large strain
  const double *ux_ = nullptr, *uy_ = nullptr;
  std::vector<double> weights_;
  std::vector<Point> points_;       // four a zone
  std::vector<double> memory_;      // of the hysteretic law, values() a point
  std::vector<double> dissipated_;  // of each zone, unweighted
  std::vector<double> turned_;      // since the start, in large strain [rad]
  std::vector<double> stretch_;     // area over undeformed area, in large strain
};

}  // namespace adit::fdm
