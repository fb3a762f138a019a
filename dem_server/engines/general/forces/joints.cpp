#include "dem_server/engines/general/forces/joints.hpp"

#include <cmath>

namespace adit::dem {
namespace {

double stored(const Joints::Joint& joint) {
  const double kn = joint.law.normal_stiffness * joint.law.length,
               ks = joint.law.shear_stiffness * joint.law.length;
  return 0.5 * (joint.normal * joint.normal / kn + joint.springs.shear * joint.springs.shear / ks);
}

}  // namespace

void Joints::pull(double dt, Particles& p) {
  for (Joint& joint : joints_) {
    const std::uint32_t i = joint.first, j = joint.second;
    const double dx = (p.x[j] - p.x[i]) + (p.ux[j] - p.ux[i]), dy = (p.y[j] - p.y[i]) + (p.uy[j] - p.uy[i]);
    const double length = std::hypot(dx, dy), ex = dx / length, ey = dy / length;
    const double arm_1 = length / 2 + joint.half_difference, arm_2 = length - arm_1;
    const double turning = arm_1 * p.spin[i] + arm_2 * p.spin[j];
    const double rx = p.vx[j] - p.vx[i] + turning * ey, ry = p.vy[j] - p.vy[i] - turning * ex;
    const double open_rate = rx * joint.nx + ry * joint.ny, slip_rate = ry * joint.nx - rx * joint.ny;

    const double before = stored(joint), normal = joint.normal, shear = joint.springs.shear;
    joint.displacement += dt * open_rate;
    const JointPull f = adit::dem::pull(joint.law, joint.displacement, slip_rate, dt, joint.springs);
    joint.normal = f.normal;
    // Work into the joint that it does not store.
    friction_ += joint.weight * (dt / 2 * ((normal + f.normal) * open_rate + (shear + f.shear) * slip_rate) -
                                 (stored(joint) - before));

    const double fx = joint.weight * (f.normal * joint.nx - f.shear * joint.ny);
    const double fy = joint.weight * (f.normal * joint.ny + f.shear * joint.nx);
    const double across = ex * fy - ey * fx;
    p.fx[i] += fx;
    p.fy[i] += fy;
    p.moment[i] += arm_1 * across;
    p.fx[j] -= fx;
    p.fy[j] -= fy;
    p.moment[j] += arm_2 * across;
  }
}

double Joints::strain_energy() const {
  double sum = 0;
  for (const Joint& joint : joints_) sum += joint.weight * stored(joint);
  return sum;
}

}  // namespace adit::dem
