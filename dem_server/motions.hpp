// Prescribed velocities and spins of particles, and the work of the reactions that they need.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dem_server/assembly.hpp"
#include "protocol/scene.pb.h"

namespace adit::dem {

class Motions {
 public:
  // Resolves the boxes among the particles that exist, at rest. UserError at particles.motions[i]: nothing
  // prescribed, nothing selected, or a component that another motion prescribes too.
  Motions(const scene::Particles& scene, const Particles& particles, double tolerance);

  // After the kick of step n: overwrites the prescribed velocities with those of time (n + 1/2) dt and adds
  // the reactions' work since n - 1 to work(). `particles` still holds the resultants at n. The reaction is
  // what the resultant lacks, R(n) = m (v(n+1/2) - v(n-1/2)) / dt - f(n), with v(-1/2) = -v(1/2) from rest;
  // its work the trapezoid dt v(n-1/2) (R(n-1) + R(n)) / 2.
  void impose(double half_time, double dt, bool start, Particles& particles);

  double work() const { return work_; }  // [J]

  // Whether a particle's velocity along x or y is prescribed.
  bool prescribes_x(std::uint32_t particle) const { return prescribed_[kX][particle]; }
  bool prescribes_y(std::uint32_t particle) const { return prescribed_[kY][particle]; }

 private:
  enum Component { kX, kY, kSpin };
  // One component of one motion: all its particles share the velocity.
  struct Motion {
    Component component;
    std::vector<std::uint32_t> particles;
    double amplitude;
    scene::TimeFunction time;
    double inertia;       // sum of the particles' masses or moments of inertia
    double velocity = 0;  // at n - 1/2
    double reaction = 0;  // sum at n - 1
  };
  void add(Component component, const std::vector<std::uint32_t>& chosen, double amplitude,
           const scene::TimeFunction& time, const std::string& path, const Particles& particles);

  std::vector<Motion> motions_;
  std::vector<bool> prescribed_[3];
  double work_ = 0;
};

}  // namespace adit::dem
