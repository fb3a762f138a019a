// The zones of a grid of several materials: one set of zones for each material; linear
// ones in small strain by the fast kernels, others by LawZones. Runs carry the number of their part.
#pragma once

#include <memory>
#include <vector>

#include "fdm_server/materials/material.hpp"
#include "fdm_server/zones/zones.hpp"

namespace adit::fdm {

class MaterialZones final : public Zones {
 public:
  // One weight a zone.
  MaterialZones(ZoneKind kind, const Grid& grid, const Ground& ground, std::span<const double> weights);

  std::size_t count() const override { return places_.size(); }
  std::span<const ZoneRun> runs() const override { return runs_; }
  void follow(const double* ux, const double* uy) override;
  using Zones::add_forces;
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
  struct Place {
    std::uint32_t part, zone;  // number in the part
  };
  struct Part {
    std::unique_ptr<Zones> zones;
    double poisson_zz;  // of zones without a law: szz over sxx + syy
    bool linear;
    std::vector<std::uint32_t> numbers;  // of its zones in the grid
  };
  void collect_runs();

  std::vector<Part> parts_;
  std::vector<Place> places_;  // of each zone
  std::vector<ZoneRun> runs_;
};

// Density of each zone [kg/m^3].
std::vector<double> zone_densities(const Ground& ground);

// critical_step.hpp, over the materials: their elastic stiffness bounds every law's.
double critical_step(ZoneKind kind, const Grid& grid, const Ground& ground);

}  // namespace adit::fdm
