// Zones of one material with a law beyond linear elasticity, or in large strain: strain increments at the
// sampling points, the law, corner forces. Of either kind (sampling_shape.hpp). A batch of zones at a time:
// consecutive numbers, up to a multiple of kBatch, of one run or several.
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
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/materials/material.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"
#include "fdm_server/zones/laws/zone_law.hpp"
#include "fdm_server/zones/water/pore_water.hpp"

namespace adit::fdm {

class NonlinearZones final : public ZoneKernel {
 public:
  // Plane strain. `strengths`: by which the strengths of the material are multiplied in each zone; empty: 1.
  NonlinearZones(ZoneKind kind, const Grid& grid, const Material& material, std::span<const double> weights,
                 bool large_strain, std::span<const double> strengths = {});

  // Water in the pores of the zones, which from now on follows their volume and pulls on their points with
  // them: forces are those of the total stress. What else the kernel is asked for is of the effective one.
  void hold(PoreWater* water) { water_ = water; }

  std::size_t count() const override { return weights_.size(); }
  std::span<const ZoneRun> runs() const override { return runs_; }
  void follow(const double* ux, const double* uy) override;
  using ZoneKernel::add_forces;
  void add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) override;
  void set_stress(std::size_t zone, const Stress& stress) override;
  // Not where the stress is a linear function of the displacements: it is in plane strain.
  void set_stress_zz(std::size_t zone, double zz) override {
    if (!linear_) set_across(zone, zz);
  }
  // In small strain.
  void set_borne(std::size_t zone, const BorneStress& borne) override;
  void remove(const std::vector<bool>& gone) override;
  void start_over() override;
  void begin_time() override { law_->begin_time(); }
  void set_time(double time) override { law_->set_time(time); }
  void exchange(state::Archive& archive) override;
  using ZoneKernel::strain_energy;
  double strain_energy(const protocol::IndexRange& zones) const override;
  double dissipated() const override;
  void find_stresses(const protocol::IndexRange& zones, PlaneStresses& stresses) const override;
  Stress stress(std::size_t zone) const override;
  ZoneForces forces(std::size_t zone) const override;
  // At the points where its law looks at the stress.
  double demand(std::size_t zone) const override;
  double field(std::size_t zone, ZoneField field) const override;

 private:
  struct Batch;
  void prefetch(std::size_t first) const;
  void take_up(const ZoneRun& run, std::uint32_t done, std::uint32_t count, double dt,
               const PointView& points, Batch& batch) const;
  void compute(Batch& batch);
  void compute_in_large_strain(Batch& batch);
  // The stress that pulls on the points, with the pressure of the batch.
  ConstStressView total(Batch& batch) const;
  void set_across(std::size_t zone, double zz);
  // Undeformed, of the points of zones.
  PointValues areas(std::size_t first, std::uint32_t count) const;
  PointStress stress_at(std::size_t zone, std::size_t point) const;
  // In large strain, where they are now.
  Corners corners_now(std::size_t zone) const;
  // In large strain: area over undeformed area.
  double stretch(std::size_t zone) const;

  ZoneKind kind_;
  Elasticity elasticity_;
  double poisson_;
  bool linear_;
  double bending_factor_;
  std::vector<ZoneRun> runs_;
  std::vector<SamplingShape> shapes_;      // undeformed
  std::vector<std::uint32_t> shape_of_;    // of each zone
  std::optional<FieldArrays<8>> corners_;  // in large strain: x, then y of each zone's corners
  std::vector<ZonePoints> zone_points_;    // likewise
  const double *ux_ = nullptr, *uy_ = nullptr;
  std::vector<double> weights_;
  StressFields stresses_;
  std::vector<double> dissipated_;  // of each zone, unweighted
  std::unique_ptr<ZoneLaw> law_;
  PoreWater* water_ = nullptr;
  std::optional<YieldCone> fracture_;  // of cells of its material
  std::vector<double> strengths_;      // factors
};

}  // namespace adit::fdm
