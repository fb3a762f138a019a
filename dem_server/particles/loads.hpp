// Forces on particles from the scene: loads shared equally by what a box selects, body loads by mass.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/particles/assembly.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/participant/step.hpp"

namespace adit::dem {

class Loads {
 public:
  // Resolves the boxes among the particles that exist, at rest. UserError at particles.loads[i] and
  // particles.body_loads[i].
  Loads(const scene::Particles& scene, const Particles& particles, double tolerance);
  Loads() = default;

  // Takes the shares of the chosen particles out, before the first step.
  Loads take(const std::vector<bool>& chosen);

  // Sets the flags of the loaded particles.
  void mark(std::vector<bool>& flags) const;

  // Adds the forces of step n to the resultants and their work since n - 1, by the trapezoid
  // dt v(n-1/2) (f(n-1) + f(n)) / 2, to work().
  void apply(const protocol::Step& step, Particles& particles);

  double work() const { return work_; }  // [J]
  void start_over() { work_ = 0; }

 private:
  struct Load {
    std::vector<std::uint32_t> particles;
    std::vector<double> share;  // force = share * (x, y) * factor
    double x, y;
    scene::TimeFunction time;
    double factor = 0;  // at the last step
  };
  std::vector<Load> loads_;
  double work_ = 0;
};

}  // namespace adit::dem
