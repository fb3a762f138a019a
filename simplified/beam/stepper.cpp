#include "simplified/beam/stepper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "protocol/errors.hpp"

namespace adit::simplified::beam {
namespace {

// Newton's method stops if the residual is this small relative to the largest first residual of any step so
// far,
constexpr double kTolerance = 1e-8;
// or if it is only rounding error: this small relative to stiffness times displacement, or to the forces of
// water and gaskets that balance each other.
constexpr double kRounding = 1e-14;
// If an iteration reduces the residual to less than this share, its matrix also serves for the next
// iteration.
constexpr double kFast = 1e-3;
constexpr int kIterations = 60;
constexpr int kLineSteps = 12;

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double energy_of(const BlockTridiagonal& matrix, std::span<const double> x, std::span<double> product) {
  matrix.multiply(x, product);
  return 0.5 * dot(x, product);
}

Scheme usable(const Scheme& scheme, const Tunnel& tunnel) {
  return scheme.mean_force && !tunnel.inertia ? newmark() : scheme;
}

}  // namespace

Stepper::Stepper(const Tunnel& tunnel, const GroundMotion& motion, const Scheme& scheme, double dt)
    : structure_((check(tunnel), tunnel)),
      motion_(motion),
      scheme_(usable(scheme, tunnel)),
      dt_(dt),
      soil_(tunnel, structure_.mesh, structure_.elements),
      joints_(tunnel, structure_.mesh) {
  supports_.push_back(structure_.mesh.nodes.front());
  supports_.insert(supports_.end(), soil_.chainages().begin(), soil_.chainages().end());
  supports_.push_back(structure_.mesh.nodes.back());
  for (auto* kind : {&ground_.displacement, &ground_.velocity})
    for (auto& values : *kind) values.resize(supports_.size());
  ground_.pressure_ratio.resize(supports_.size());
  for (auto* vector : {&u0_, &v0_, &a0_, &u1_, &v1_, &a1_, &blended_, &product_, &residual_, &correction_,
                       &reaction0_, &reaction1_, &scaling_})
    vector->resize(structure_.dofs());
  read_ground(0);
  settle();
  start_accelerations();
}

void Stepper::step() {
  ++steps_;
  read_ground(time());
  // Newton starts with the increment of the last step, from which it mostly needs one iteration. u1_ still
  // holds the displacement before that increment.
  for (std::size_t i = 0; i < u1_.size(); ++i) u1_[i] = 2 * u0_[i] - u1_[i];
  prescribe_portals(u1_, ground_.displacement);
  newton();
  commit();
}

void Stepper::read_ground(double time) {
  motion_(time, supports_, ground_);
}

// Finds the static state: the same equation without M and c, starting from the installed state u = 0.
void Stepper::settle() {
  const Scheme dynamic = scheme_;
  scheme_ = newmark();
  constant_ = structure_.stiffness;
  GroundState moving = ground_;
  for (auto& values : ground_.velocity) std::fill(values.begin(), values.end(), 0.0);
  prescribe_portals(u1_, ground_.displacement);
  newton();
  soil_.commit(scheme_);
  joints_.commit();
  u0_ = u1_;
  ground_ = std::move(moving);
  scheme_ = dynamic;
}

// Finds the initial accelerations from M a = −(unbalanced forces), which in the static state are the forces
// of the dashpots. Prescribed nodes start with the motion of their ground.
void Stepper::start_accelerations() {
  prescribe_portals(v0_, ground_.velocity);
  v1_ = v0_;
  evaluate();
  soil_.commit(scheme_);
  joints_.commit();
  if (structure_.tunnel.inertia) {
    BlockTridiagonal mass = structure_.mass;
    structure_.fix(mass);
    BlockCholesky factor;
    if (factor.factor(mass)) throw std::logic_error("the mass of the tube is not positive definite");
    for (std::size_t i = 0; i < a0_.size(); ++i) a0_[i] = -residual_[i];
    factor.solve(a0_);
  }
  moving_ = true;
  factored_ = false;
  residual_scale_ = 0;
  a1_ = a0_;
  evaluate();
  reaction0_ = reaction1_;
  constant_ = BlockTridiagonal(structure_.mesh.nodes.size());
  constant_.add_scaled(structure_.mass, (1 - scheme_.alpha_m) / (scheme_.beta * dt_ * dt_));
  constant_.add_scaled(structure_.stiffness, 1 - scheme_.alpha_f);
  soil_.add_dashpots(constant_, (1 - scheme_.alpha_f) * scheme_.gamma / (scheme_.beta * dt_));
  kinetic_start_ = energy_of(structure_.mass, v0_, product_);
  strain_start_ = energy_of(structure_.stiffness, u0_, product_);
  energy_ = {};
}

void Stepper::prescribe_portals(std::vector<double>& u,
                                const std::array<std::vector<double>, 3>& ground) const {
  for (const std::size_t node : structure_.fixed_nodes)
    for (int i = 0; i < kDofs; ++i)
      u[kDofs * node + i] = i < 3 ? (node == 0 ? ground[i].front() : ground[i].back()) : 0;
}

void Stepper::derive_motion() {
  const double b = 1 / (scheme_.beta * dt_ * dt_), c = (0.5 - scheme_.beta) / scheme_.beta,
               gamma = scheme_.gamma;
  for (std::size_t i = 0; i < u1_.size(); ++i) {
    a1_[i] = b * (u1_[i] - u0_[i] - dt_ * v0_[i]) - c * a0_[i];
    v1_[i] = v0_[i] + dt_ * ((1 - gamma) * a0_[i] + gamma * a1_[i]);
  }
}

void Stepper::evaluate() {
  for (std::size_t i = 0; i < u1_.size(); ++i)
    blended_[i] = (1 - scheme_.alpha_f) * u1_[i] + scheme_.alpha_f * u0_[i];
  structure_.stiffness.multiply(blended_, residual_);
  for (std::size_t i = 0; i < residual_.size(); ++i) residual_[i] -= structure_.load[i];
  if (moving_ && structure_.tunnel.inertia) {
    for (std::size_t i = 0; i < a1_.size(); ++i)
      blended_[i] = (1 - scheme_.alpha_m) * a1_[i] + scheme_.alpha_m * a0_[i];
    structure_.mass.multiply(blended_, product_);
    for (std::size_t i = 0; i < residual_.size(); ++i) residual_[i] += product_[i];
  }
  soil_.evaluate(scheme_, u1_, v1_, ground_, residual_);
  joints_.evaluate(scheme_, u1_, residual_);
  for (const std::size_t node : structure_.fixed_nodes)
    std::copy_n(&residual_[kDofs * node], kDofs, &reaction1_[kDofs * node]);
  structure_.clear_fixed(residual_);
}

void Stepper::refactor() {
  if (!factored_) {
    tangent_ = constant_;
    soil_.forget_tangents();
    joints_.forget_tangents();
  }
  std::size_t changed = std::min(soil_.update_tangents(tangent_), joints_.update_tangents(tangent_));
  if (!factored_) changed = 0;
  if (changed >= structure_.mesh.links.size()) return;
  structure_.fix(tangent_);
  if (const auto failed = factor_.factor(tangent_, changed)) {
    static constexpr const char* kNames[] = {"along the axis", "sideways", "vertically", "turning sideways",
                                             "turning upward"};
    throw protocol::UserError(
        "soil",
        fmt::format("the tube is free to move {} at chainage {:g} m (time {:g} s): give the soil springs a "
                    "stiffness or some hardening there, or fix a portal",
                    kNames[*failed % kDofs], structure_.mesh.nodes[*failed / kDofs], time()));
  }
  if (!factored_)
    // Forces and moments have different units. Residuals are weighted with the flexibility of their degree of
    // freedom, so that the norm is the root of an energy; the weights stay those of the first matrix, so that
    // norms of different steps can be compared.
    for (std::size_t i = 0; i < scaling_.size(); ++i)
      scaling_[i] = 1 / tangent_.diagonal[i / kDofs](i % kDofs, i % kDofs);
  factored_ = true;
  ++factorizations_;
}

void Stepper::newton() {
  if (moving_) derive_motion();
  evaluate();
  refactor();
  double norm = scaled_norm(), before = norm;
  residual_scale_ = std::max(residual_scale_, norm);
  for (int iteration = 0; norm > kTolerance * residual_scale_ + kRounding * rounding(); ++iteration) {
    if (iteration == kIterations || !std::isfinite(norm))
      throw protocol::Unstable(
          fmt::format("mass-spring-beam: Newton did not converge at time {:g} s (residual {:g} of {:g}): "
                      "take a smaller step",
                      time(), norm, residual_scale_));
    if (norm > kFast * before) refactor();
    before = norm;
    for (std::size_t i = 0; i < residual_.size(); ++i) correction_[i] = -residual_[i];
    factor_.solve(correction_);
    ++newton_iterations_;
    search_line(dot(correction_, residual_));
    norm = scaled_norm();
  }
}

// Finds the minimum of the convex function along the correction, where its slope vanishes, by the secant
// method.
void Stepper::search_line(double slope) {
  double share = 0, target = 1;
  for (int k = 0; k < kLineSteps; ++k) {
    for (std::size_t i = 0; i < u1_.size(); ++i) u1_[i] += (target - share) * correction_[i];
    share = target;
    if (moving_) derive_motion();
    evaluate();
    const double slope_here = dot(correction_, residual_);
    // The minimum need not be exact: the next correction of Newton's method does the rest.
    if (slope_here <= 0.5 * std::abs(slope)) return;
    target = share * std::max(0.1, slope / (slope - slope_here));
  }
}

double Stepper::scaled_norm() const {
  double sum = 0;
  for (std::size_t i = 0; i < residual_.size(); ++i) sum += residual_[i] * residual_[i] * scaling_[i];
  return std::sqrt(sum);
}

double Stepper::rounding() const {
  double sum = 0, softest = 0, pressed = 0;
  for (std::size_t i = 0; i < u1_.size(); ++i) {
    sum += u1_[i] * u1_[i] / scaling_[i];
    softest = std::max(softest, scaling_[i]);
  }
  for (const Joint& joint : structure_.tunnel.joints) pressed = std::max(pressed, joint.hydrostatic_force);
  return std::sqrt(sum) + pressed * std::sqrt(softest);
}

void Stepper::commit() {
  const SoilWork soil = soil_.commit(scheme_);
  energy_.soil += soil.stored;
  energy_.slip += soil.slip;
  energy_.weakening += soil.weakening;
  energy_.dashpots += soil.dashpots;
  energy_.input += soil.input;
  energy_.loads += soil.uplift;
  energy_.joints += joints_.commit();
  for (const std::size_t node : structure_.fixed_nodes)
    for (std::size_t i = kDofs * node; i < kDofs * (node + 1); ++i)
      energy_.input +=
          (scheme_.mean_force ? reaction1_[i] : 0.5 * (reaction0_[i] + reaction1_[i])) * (u1_[i] - u0_[i]);
  for (std::size_t i = 0; i < u1_.size(); ++i) energy_.loads += structure_.load[i] * (u1_[i] - u0_[i]);
  energy_.kinetic = energy_of(structure_.mass, v1_, product_) - kinetic_start_;
  energy_.strain = energy_of(structure_.stiffness, u1_, product_) - strain_start_;
  u0_.swap(u1_);
  v0_.swap(v1_);
  a0_.swap(a1_);
  reaction0_.swap(reaction1_);
}

}  // namespace adit::simplified::beam
