#include "dem_server/engines/general/forces/joints.hpp"

#include <cmath>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/laws/spring.hpp"

namespace adit::dem {
namespace {

double stored(const Joints::Joint& joint) {
  return spring_energy(joint.normal, joint.law.normal_stiffness * joint.law.length) +
         spring_energy(joint.springs.shear, joint.law.shear_stiffness * joint.law.length);
}

}  // namespace

void Joints::add_forces(double dt, Particles& p) {
  for (Joint& joint : joints_) {
    const std::uint32_t i = joint.first, j = joint.second;
    const double dx = (p.x[j] - p.x[i]) + (p.ux[j] - p.ux[i]), dy = (p.y[j] - p.y[i]) + (p.uy[j] - p.uy[i]);
    const double length = std::hypot(dx, dy), ex = dx / length, ey = dy / length;
    const double arm_1 = length / 2 + joint.half_difference, arm_2 = length - arm_1;
    const double rolling = rolling_speed({arm_1, arm_2}, p.spin[i], p.spin[j]);
    const double rx = p.vx[j] - p.vx[i] + rolling * ey, ry = p.vy[j] - p.vy[i] - rolling * ex;
    const double open_rate = along(joint.nx, joint.ny, rx, ry),
                 slip_rate = across(joint.nx, joint.ny, rx, ry);

    const double before = stored(joint), normal = joint.normal, shear = joint.springs.shear;
    joint.displacement += dt * open_rate;
    joint.slip += dt * slip_rate;
    const JointForces f = joint_forces(joint.law, joint.displacement, slip_rate, dt, joint.springs);
    joint.normal = f.normal;
    // Work into the joint that it does not store.
    friction_ += joint.weight * (dt / 2 * ((normal + f.normal) * open_rate + (shear + f.shear) * slip_rate) -
                                 (stored(joint) - before));

    const PlaneVector force = vector_of(joint.nx, joint.ny, f.normal, f.shear);
    const double fx = joint.weight * force.x, fy = joint.weight * force.y;
    const double turning = across(ex, ey, fx, fy);
    p.fx[i] += fx;
    p.fy[i] += fy;
    p.moment[i] += arm_1 * turning;
    p.fx[j] -= fx;
    p.fy[j] -= fy;
    p.moment[j] += arm_2 * turning;
  }
}

double Joints::strain_energy() const {
  double sum = 0;
  for (const Joint& joint : joints_) sum += joint.weight * stored(joint);
  return sum;
}

}  // namespace adit::dem
