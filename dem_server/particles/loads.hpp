// Forces of the model's loads on particles: forces shared equally, accelerations by mass.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class Loads {
 public:
  Loads() = default;
  Loads(const Model& model, const Particles& particles);

  // Takes steady accelerations of all particles out, before the first step, and returns their sum.
  Acceleration take_gravity(const Particles& particles);
  // Takes the shares of the chosen particles out, before the first step.
  Loads take(const std::vector<bool>& chosen);

  // Sets the flags of the loaded particles.
  void mark(std::vector<bool>& flags) const;

  // Adds the forces of step n to the resultants and their work since n - 1, by the trapezoid
  // dt v(n-1/2) (f(n-1) + f(n)) / 2, to work().
  void apply(const protocol::Step& step, Particles& particles);

  // Work of forces and of accelerations since the start [J].
  struct Work {
    double forces = 0, accelerations = 0;
  };
  const Work& work() const { return work_; }
  void start_over() { work_ = {}; }
  void exchange(state::Archive& archive) {
    for (Shared& load : loads_) archive("load_factor", load.factor);
    archive("load_work", work_);
  }

 private:
  struct Shared {
    Load::Kind kind;
    std::vector<std::uint32_t> particles;
    std::vector<double> share;  // force = share * (x, y) * factor
    double x, y;
    TimeFactor time;
    bool steady;
    double factor = 0;  // at the last step
  };
  std::vector<Shared> loads_;
  Work work_;
};

}  // namespace adit::dem
