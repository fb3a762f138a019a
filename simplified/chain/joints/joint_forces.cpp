#include "simplified/chain/joints/joint_forces.hpp"

namespace adit::simplified::chain {
namespace {

// The positions of the ports and the directions of the hinges.
struct Geometry {
  const double *half_x, *half_y, *cos, *sin;
  explicit Geometry(const Model& m)
      : half_x(m.half_x.data()), half_y(m.half_y.data()), cos(m.cos.data()), sin(m.sin.data()) {}
};

struct Local {
  double axial, shear, rotation;
};

// The motion of the ingoing port of place j + 1 relative to the outgoing port of place j, in the axes of
// hinge j.
// A port at the arm r from its centre moves by u + rotation (-r_y, r_x). The arm of an ingoing port is minus
// the half-length, that of an outgoing port plus the half-length: hence the sums.
inline Local relative(const Geometry& g, const Field& f, std::size_t j) {
  const double dx =
      (f.x[j + 1] - f.x[j]) + (g.half_y[j + 1] * f.rotation[j + 1] + g.half_y[j] * f.rotation[j]);
  const double dy =
      (f.y[j + 1] - f.y[j]) - (g.half_x[j + 1] * f.rotation[j + 1] + g.half_x[j] * f.rotation[j]);
  return {g.cos[j] * dx + g.sin[j] * dy, g.cos[j] * dy - g.sin[j] * dx, f.rotation[j + 1] - f.rotation[j]};
}

struct Law {
  const double *k, *c, *offset;
  Law(const Model& m, std::size_t d)
      : k(m.stiffness[d].data()), c(m.dashpot[d].data()), offset(m.offset[d].data()) {}
  double force(std::size_t j, double deformation, double rate) const {
    return offset[j] + k[j] * deformation + c[j] * rate;
  }
};

}  // namespace

Field predicted_displacement(const Tracks& t) {
  return {t[0].p.data(), t[1].p.data(), t[2].p.data()};
}
Field predicted_velocity(const Tracks& t) {
  return {t[0].q.data(), t[1].q.data(), t[2].q.data()};
}
Field displacement(const Tracks& t) {
  return {t[0].x.data(), t[1].x.data(), t[2].x.data()};
}
Field velocity(const Tracks& t) {
  return {t[0].v.data(), t[1].v.data(), t[2].v.data()};
}

void hinge_forces(const Model& model, const Field& x, const Field& v, std::size_t begin, std::size_t end,
                  Components& forces) {
  const Geometry g(model);
  const Law axial(model, 0), shear(model, 1), rotation(model, 2);
  double *fx = forces[0].data(), *fy = forces[1].data(), *moment = forces[2].data();
#pragma GCC ivdep
  for (std::size_t j = begin; j < end; ++j) {
    const Local d = relative(g, x, j), rate = relative(g, v, j);
    const double n = axial.force(j, d.axial, rate.axial), s = shear.force(j, d.shear, rate.shear);
    fx[j] = g.cos[j] * n - g.sin[j] * s;
    fy[j] = g.sin[j] * n + g.cos[j] * s;
    moment[j] = rotation.force(j, d.rotation, rate.rotation);
  }
}

void unbalanced(const Model& model, const Field& x, const Field& v, const Components& load,
                const Components& hinge_forces, std::size_t begin, std::size_t end, Components& r) {
  // Plain pointers to the arrays, of which none overlaps another, let the compiler vectorize the loop; it
  // cannot see through the vectors that writing r changes nothing that is read.
  const PlaneSprings &k = model.ground_stiffness, &c = model.ground_dashpot;
  const double *kxx = k.xx.data(), *kxy = k.xy.data(), *kyy = k.yy.data(), *krr = k.rr.data(),
               *cxx = c.xx.data(), *cxy = c.xy.data(), *cyy = c.yy.data(), *crr = c.rr.data(),
               *hx = model.half_x.data(), *hy = model.half_y.data(), *fx = hinge_forces[0].data(),
               *fy = hinge_forces[1].data(), *moment = hinge_forces[2].data(), *load_x = load[0].data(),
               *load_y = load[1].data(), *load_r = load[2].data();
  double *rx = r[0].data(), *ry = r[1].data(), *rr = r[2].data();
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    rx[i] = load_x[i] - kxx[i] * x.x[i] - kxy[i] * x.y[i] - cxx[i] * v.x[i] - cxy[i] * v.y[i] +
            (fx[i] - fx[i - 1]);
    ry[i] = load_y[i] - kxy[i] * x.x[i] - kyy[i] * x.y[i] - cxy[i] * v.x[i] - cyy[i] * v.y[i] +
            (fy[i] - fy[i - 1]);
    // The hinge before the body acts with the opposite force on the opposite arm, so its moment has the same
    // sign as that of the hinge after it.
    rr[i] = load_r[i] - krr[i] * x.rotation[i] - crr[i] * v.rotation[i] + (moment[i] - moment[i - 1]) +
            hx[i] * (fy[i] + fy[i - 1]) - hy[i] * (fx[i] + fx[i - 1]);
  }
}

void measure(const Model& model, const Field& x, const Field& v, std::size_t begin, std::size_t end,
             Components& deformation, Components& force) {
  const Geometry g(model);
  const Law axial(model, 0), shear(model, 1), rotation(model, 2);
  double *opening = deformation[0].data(), *slip = deformation[1].data(), *turn = deformation[2].data();
  double *n = force[0].data(), *s = force[1].data(), *m = force[2].data();
  const double *n0 = model.at_rest[0].data(), *s0 = model.at_rest[1].data(), *m0 = model.at_rest[2].data();
#pragma GCC ivdep
  for (std::size_t j = begin; j < end; ++j) {
    const Local d = relative(g, x, j), rate = relative(g, v, j);
    opening[j] = d.axial;
    slip[j] = d.shear;
    turn[j] = d.rotation;
    n[j] = n0[j] + axial.force(j, d.axial, rate.axial);
    s[j] = s0[j] + shear.force(j, d.shear, rate.shear);
    m[j] = m0[j] + rotation.force(j, d.rotation, rate.rotation);
  }
}

double deformation(const Model& model, const Field& x, std::size_t hinge, std::size_t direction) {
  const Local d = relative(Geometry(model), x, hinge);
  return direction == 0 ? d.axial : direction == 1 ? d.shear : d.rotation;
}

}  // namespace adit::simplified::chain
