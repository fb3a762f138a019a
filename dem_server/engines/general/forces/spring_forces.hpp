// Springs between the centres of two discs, such as bolts: N = N0 + k (L - L0), where wanted at least 0. One
// whose force exceeds its strength is gone.
#pragma once

#include <span>
#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"

namespace adit::dem {

class SpringForces {
 public:
  SpringForces() = default;
  explicit SpringForces(std::vector<Spring> springs);

  // Installs those of the stages after `before` up to `stage`, with their pretension, at their present
  // length; those whose discs were taken away are gone.
  void begin_stage(std::uint32_t before, std::uint32_t stage, const Particles& particles);

  // Adds their forces to the resultants; `dt` is 0 where the step starts from rest.
  void add_forces(double dt, Particles& particles);

  double strain_energy() const;
  double released() const { return released_; }  // stored in those that broke, since the start [J]
  void start_over() { released_ = 0; }
  std::span<const Spring> springs() const { return springs_; }
  std::span<const double> forces() const { return forces_; }  // [N]
  std::size_t broken() const { return broken_; }

 private:
  std::vector<Spring> springs_;
  std::vector<double> forces_;
  std::vector<bool> whole_;           // installed, and not broken
  std::vector<double> installed_at_;  // elongation with which it bears the pretension alone [m]
  std::size_t broken_ = 0;
  double released_ = 0;
};

}  // namespace adit::dem
