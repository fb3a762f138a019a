// What takes energy out of the discs' motion, and the kick that it enters.
//
// Local damping (Cundall 1987): a force -share |f| sign(v-) on every component, f its resultant, spin
// included; in statics, their own share takes its place. Tied discs are left out: what moves them are the
// ties, and their own forces are not what they lack of balance. Drag, of viscous damping c = rate m and of
// quiet edges: -c v at n, where v is the mean of the velocities half a step before and after; that is stable
// for any c: v+ = [(m/dt - c/2) v- + f] / (m/dt + c/2). What ties a disc is not among the forces that are
// known, and balances them at rest: drag of a tied disc takes the velocity before.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::dem {

class Damping {
 public:
  struct Loss {
    double local = 0, viscous = 0, edges = 0;  // [J]
  };

  Damping() = default;
  // `tied`: discs whose motion is that of another model.
  Damping(double local_share, double viscous_rate, std::span<const EdgeDashpot> edges,
          const Particles& particles, std::span<const std::uint32_t> tied = {});

  // Whether it acts on other discs than those of quiet edges, too.
  bool acts_everywhere(const protocol::Step& step) const {
    return local_share_ > 0 || viscous_ || step.local_damping > 0;
  }
  // Velocities of n + 1/2 of some discs from resultants and velocities of n - 1/2; the resultants then hold
  // the damping forces too. Returns what these took since n - 1, by the trapezoid of energy.hpp.
  Loss kick(const protocol::Step& step, std::span<const protocol::IndexRange> some, Particles& particles);

  void exchange(state::Archive& archive) {
    for (Component* component : {&x_, &y_, &spin_}) {
      archive("damping_local", std::span(component->local_force));
      archive("damping_middle", std::span(component->middle));
    }
  }

 private:
  // A component of the motion: the share of local damping and its force at the last step; the coefficients of
  // drag and the mean velocity that it acted against then.
  struct Component {
    std::vector<double> local, local_force;     // of each disc, [1], [N] or [N m]; empty: none
    std::vector<double> edge, viscous, middle;  // [N s/m] or [N m s], and [m/s] or [rad/s]; empty: none
    std::vector<double> free;                   // 0 where the disc is tied, else 1
  };
  struct Motion;
  Loss kick(const protocol::Step& step, std::uint32_t begin, std::uint32_t end, const Motion& motion,
            Component& component) const;

  double local_share_ = 0;
  bool viscous_ = false, drags_ = false;
  Component x_, y_, spin_;
};

}  // namespace adit::dem
