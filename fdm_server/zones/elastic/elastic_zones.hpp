// Elastic zones of both kinds: they differ in what resists the hourglass pattern (hourglass.hpp).
//
// Small strain makes stress a function of place: sigma = sigma_0 + D B u, with sigma_0 the stress where the
// displacements were 0. Nothing is stored a zone but sigma_0 where there is one: the kernel reads
// displacements and adds forces. The generalized stresses are
//   p = kappa (exx + eyy), t = mu (exx - eyy), s = mu gxy of the mean strain, Q = K q of the pattern,
// and the corner forces -w [A b.(p, t, s) + gamma Q], w the zone's weight.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/grid/field_arrays.hpp"
#include "fdm_server/materials/mohr_coulomb.hpp"
#include "fdm_server/zones/elastic/elastic_forces.hpp"
#include "fdm_server/zones/elastic/pattern_stress.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"

namespace adit::fdm {

struct ElasticShape {
  Coefficients coefficients;
  bool rectangle;  // upright
};
ElasticShape elastic_shape(ZoneKind kind, const Corners& corners, const PlaneLaw& law);

class ElasticZones final : public ZoneKernel {
 public:
  // `across`: the stress across the plane over sxx + syy, nu in plane strain. `strength`: that demand is
  // measured by, times the factor of each zone if `factors` are given.
  ElasticZones(ZoneKind kind, const Grid& grid, const PlaneLaw& law, std::span<const double> weights,
               double across = 0, const std::optional<YieldCone>& strength = {},
               std::span<const double> factors = {});
  std::size_t count() const override { return weights_.size(); }
  std::span<const ZoneRun> runs() const override { return runs_; }
  void follow(const double* ux, const double* uy) override;
  using ZoneKernel::add_forces;
  void add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) override;
  void set_stress(std::size_t zone, const Stress& stress) override;
  // Across the plane it keeps the stress of its law.
  void set_borne(std::size_t zone, const BorneStress& borne) override;
  void remove(const std::vector<bool>& gone) override;
  void start_over() override;
  void exchange(state::Archive& archive) override {
    archive("initial_stress", initial_, [this] { return FieldArrays<kComponents>(count()); });
  }
  using ZoneKernel::strain_energy;
  double strain_energy(const protocol::IndexRange& zones) const override;
  Stress stress(std::size_t zone) const override;
  ZoneForces forces(std::size_t zone) const override;
  void find_stresses(const protocol::IndexRange& zones, PlaneStresses& stresses) const override;
  // Of the largest stress in the zone (pattern_stress.hpp).
  double demand(std::size_t zone) const override;
  double field(std::size_t zone, ZoneField field) const override;

 private:
  using State = std::array<double, kComponents>;
  // Makes one run of a row of zones that differ in shape, as in graded and mapped grids.
  void join_short_runs();
  Coefficients coefficients(const ZoneRun& run, std::uint32_t k) const;
  ElasticBatch batch(const ZoneRun& run, std::uint32_t done, std::uint32_t count) const;
  // Calls visit(batch, first) for the zones from `first` on, in batches.
  void for_each_batch(const protocol::IndexRange& zones, const auto& visit) const;
  const ZoneRun& run_of(std::size_t zone) const;
  // The state of zone k of a run.
  State state(const ZoneRun& run, std::uint32_t k) const;
  FieldArrays<kComponents>& initial();

  struct Strength {
    YieldCone cone;
    std::vector<double> factors;                         // of each zone; empty: all 1
    std::vector<std::array<PatternStress, 4>> patterns;  // of each shape of the grid
    std::vector<std::uint32_t> pattern_of;               // of each zone
  };

  std::vector<ElasticShape> shapes_;
  std::optional<FieldArrays<kCoefficients>> own_;  // of the zones in runs of many shapes
  std::vector<ZoneRun> runs_;
  std::vector<double> weights_;
  bool weighted_;                                    // any weight is not 1
  std::optional<FieldArrays<kComponents>> initial_;  // stresses at displacement 0
  double across_;
  std::optional<Strength> strength_;
  const double *ux_ = nullptr, *uy_ = nullptr;
};

}  // namespace adit::fdm
