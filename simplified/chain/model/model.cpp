#include "simplified/chain/model/model.hpp"

#include <cmath>

namespace adit::simplified::chain {
namespace {

// R diag(axial, lateral, rotation) R^T for an axis along (c, s).
Matrix3 turned(double c, double s, double axial, double lateral, double rotation) {
  Matrix3 turned = Matrix3::Zero();
  turned(0, 0) = axial * c * c + lateral * s * s;
  turned(1, 1) = axial * s * s + lateral * c * c;
  turned(0, 1) = turned(1, 0) = (axial - lateral) * c * s;
  turned(2, 2) = rotation;
  return turned;
}

PlaneSprings plane_springs(std::size_t size) {
  const std::vector<double> zero(size, 0.0);
  return {zero, zero, zero, zero};
}

void set(PlaneSprings& springs, std::size_t i, double angle, const Directions& local) {
  const Matrix3 k = turned(std::cos(angle), std::sin(angle), local.axial, local.lateral, local.rotation);
  springs.xx[i] = k(0, 0);
  springs.xy[i] = k(0, 1);
  springs.yy[i] = k(1, 1);
  springs.rr[i] = k(2, 2);
}

Matrix3 port(double rx, double ry) {
  Matrix3 port = Matrix3::Identity();
  port(0, 2) = -ry;
  port(1, 2) = rx;
  return port;
}

void set(Model& model, std::size_t j, const Hinge& hinge) {
  const std::array<const HingeDirection*, 3> directions{&hinge.axial, &hinge.shear, &hinge.rotation};
  for (std::size_t d = 0; d < 3; ++d) {
    const HingeDirection& given = *directions[d];
    model.dashpot[d][j] = given.dashpot;
    model.stiffness[d][j] = given.stiffness;
    if (given.curve.empty()) continue;
    // The chain begins at rest, so the first tangent is taken at zero deformation. There the curve's force is
    // the force at rest, which outer forces balance, so the offset without it is zero.
    const Line line = line_at(given.curve, 0);
    model.stiffness[d][j] = line.slope;
    model.at_rest[d][j] = line.offset;
  }
}

}  // namespace

Components components(std::size_t size) {
  const std::vector<double> zero(size, 0.0);
  return {zero, zero, zero};
}

Matrix3 PlaneSprings::at(std::size_t i) const {
  Matrix3 k = Matrix3::Zero();
  k(0, 0) = xx[i];
  k(0, 1) = k(1, 0) = xy[i];
  k(1, 1) = yy[i];
  k(2, 2) = rr[i];
  return k;
}

Model::Model(const Chain& chain)
    : bodies(chain.bodies.size()),
      mass(bodies + 2),
      inertia(bodies + 2),
      half_x(bodies + 2),
      half_y(bodies + 2),
      ground_stiffness(plane_springs(bodies + 2)),
      ground_dashpot(plane_springs(bodies + 2)),
      cos(bodies + 1),
      sin(bodies + 1),
      stiffness(components(bodies + 1)),
      dashpot(components(bodies + 1)),
      offset(components(bodies + 1)),
      at_rest(components(bodies + 1)) {
  for (std::size_t i = 1; i <= bodies; ++i) {
    const Body& body = chain.bodies[i - 1];
    mass[i] = body.mass;
    inertia[i] = body.inertia;
    half_x[i] = 0.5 * body.length * std::cos(body.angle);
    half_y[i] = 0.5 * body.length * std::sin(body.angle);
    set(ground_stiffness, i, body.angle, body.ground_stiffness);
    set(ground_dashpot, i, body.angle, body.ground_dashpot);
  }
  for (std::size_t j = 0; j <= bodies; ++j) {
    const double before = chain.bodies[j == 0 ? 0 : j - 1].angle,
                 after = chain.bodies[j == bodies ? j - 1 : j].angle;
    // The remainder is the turn by the shorter way, also where one angle lies just below pi and the other
    // just above -pi.
    const double angle = before + 0.5 * std::remainder(after - before, 2 * M_PI);
    cos[j] = std::cos(angle);
    sin[j] = std::sin(angle);
  }
  if (chain.start) set(*this, 0, *chain.start);
  for (std::size_t j = 1; j < bodies; ++j) set(*this, j, chain.hinges[j - 1]);
  if (chain.finish) set(*this, bodies, *chain.finish);
}

Matrix3 Model::dynamic_stiffness(std::size_t i, double A, double C) const {
  const Vector3 inertial(mass[i] * A, mass[i] * A, inertia[i] * A);
  return ground_stiffness.at(i) + C * ground_dashpot.at(i) + Matrix3(inertial.asDiagonal());
}

Matrix3 Model::hinge_stiffness(std::size_t j, double C) const {
  std::array<double, 3> k;
  for (std::size_t d = 0; d < 3; ++d) k[d] = stiffness[d][j] + C * dashpot[d][j];
  return turned(cos[j], sin[j], k[0], k[1], k[2]);
}

Matrix3 Model::outgoing_port(std::size_t i) const {
  return port(half_x[i], half_y[i]);
}

Matrix3 Model::ingoing_port(std::size_t i) const {
  return port(-half_x[i], -half_y[i]);
}

}  // namespace adit::simplified::chain
