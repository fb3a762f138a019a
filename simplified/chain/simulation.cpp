#include "simplified/chain/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "protocol/errors.hpp"
#include "simplified/chain/flush_denormals.hpp"
#include "simplified/chain/joints/curved_hinges.hpp"
#include "simplified/chain/joints/joint_forces.hpp"
#include "simplified/chain/results.hpp"
#include "simplified/chain/riccati.hpp"

namespace adit::simplified::chain {
namespace {

constexpr std::size_t kBlock = 128;  // number of bodies whose data stay in the cache from pass to pass
constexpr int kBold = 8;             // iterations of Newton's method before tangents are taken half-way only

const char* direction_name(std::size_t direction) {
  return direction == 0 ? "axial" : direction == 1 ? "shear" : "rotation";
}

void check(const Settings& settings) {
  check(settings.newmark, settings.dt);
  if (!(settings.tolerance > 0 && settings.tolerance < 1))
    throw protocol::UserError("tolerance", fmt::format("{} is not between 0 and 1", settings.tolerance));
  if (settings.max_iterations < 1)
    throw protocol::UserError("max_iterations", fmt::format("{} is below 1", settings.max_iterations));
}

}  // namespace

class Simulation::Impl {
 public:
  Impl(const Chain& chain, const Settings& settings)
      : settings_(settings),
        model_(chain),
        curved_(chain),
        integrator_(settings.newmark, settings.dt),
        riccati_(model_),
        tracks_{Track(model_.bodies + 2), Track(model_.bodies + 2), Track(model_.bodies + 2)},
        zero_(model_.bodies, 0.0),
        results_(model_.bodies) {
    const std::size_t n = model_.bodies;
    for (Components* all : {&load_, &r_, &y_, &trial_}) *all = components(n + 2);
    hinge_forces_ = components(n + 1);
    factor(0);
    // Results can be read before the first step, also without start().
    results_.start(model_, curved_, tracks_);
  }

  void start(const InitialMotion& motion, const Excitation& at_start);
  void step(const Excitation& at_end);
  BodyMotion motion() const;
  Joints joints() const;

  Settings settings_;
  long steps_ = 0, iterations_ = 0;
  Model model_;
  CurvedHinges curved_;
  Integrator integrator_;
  RiccatiSweep riccati_;
  Tracks tracks_;
  const std::vector<double> zero_;
  Components load_;  // on the bodies at the end of the step, without the chain's own
  Components hinge_forces_, r_, y_, trial_;
  Results results_;

 private:
  std::span<const double> given(std::span<const double> values, const char* name) const;
  std::span<const double> of_bodies(const std::vector<double>& places) const {
    return std::span(places).subspan(1, model_.bodies);
  }
  void factor(std::size_t changed_hinge);
  void set_load(const Excitation& excitation);
  void move_abutments(const Excitation& excitation);
  void predict_abutments();
  void balance();
  void solve();
  void solve_to_curves();
  void check_finite();
  void sweep_forward();
  void sweep_back();
  void finish(std::size_t begin, std::size_t end);
  [[noreturn]] void report_unstable() const;
};

std::span<const double> Simulation::Impl::given(std::span<const double> values, const char* name) const {
  if (values.empty()) return zero_;
  if (values.size() != model_.bodies)
    throw std::invalid_argument(
        fmt::format("{} has {} value(s) for {} bodies", name, values.size(), model_.bodies));
  return values;
}

void Simulation::Impl::factor(std::size_t changed_hinge) {
  riccati_.factor(model_, integrator_.A(), integrator_.C(), changed_hinge);
}

// The load: outer forces, and the forces of ground springs and dashpots under the motion of the ground alone.
void Simulation::Impl::set_load(const Excitation& e) {
  const double *ux = given(e.ground_x, "ground_x").data(), *uy = given(e.ground_y, "ground_y").data(),
               *vx = given(e.ground_vx, "ground_vx").data(), *vy = given(e.ground_vy, "ground_vy").data(),
               *fx = given(e.load_x, "load_x").data(), *fy = given(e.load_y, "load_y").data();
  const PlaneSprings &k = model_.ground_stiffness, &c = model_.ground_dashpot;
  const double *kxx = k.xx.data() + 1, *kxy = k.xy.data() + 1, *kyy = k.yy.data() + 1, *cxx = c.xx.data() + 1,
               *cxy = c.xy.data() + 1, *cyy = c.yy.data() + 1;
  double *load_x = load_[0].data() + 1, *load_y = load_[1].data() + 1;
#pragma GCC ivdep
  for (std::size_t i = 0; i < model_.bodies; ++i) {
    load_x[i] = fx[i] + kxx[i] * ux[i] + kxy[i] * uy[i] + cxx[i] * vx[i] + cxy[i] * vy[i];
    load_y[i] = fy[i] + kxy[i] * ux[i] + kyy[i] * uy[i] + cxy[i] * vx[i] + cyy[i] * vy[i];
  }
  const auto moment = given(e.moment, "moment");
  std::copy(moment.begin(), moment.end(), load_[2].begin() + 1);
}

// The abutments' motion at the end of the step, or at the start.
void Simulation::Impl::move_abutments(const Excitation& e) {
  const std::array<std::span<const double>, 2> u{given(e.ground_x, "ground_x"),
                                                 given(e.ground_y, "ground_y")},
      v{given(e.ground_vx, "ground_vx"), given(e.ground_vy, "ground_vy")};
  for (std::size_t c = 0; c < 2; ++c) {
    tracks_[c].x.front() = u[c].front();
    tracks_[c].x.back() = u[c].back();
    tracks_[c].v.front() = v[c].front();
    tracks_[c].v.back() = v[c].back();
  }
}

// The motion of the abutments is known, so their prediction needs no correction.
void Simulation::Impl::predict_abutments() {
  for (Track& track : tracks_)
    for (const std::size_t i : {std::size_t{0}, model_.bodies + 1}) {
      track.p[i] = track.x[i];
      track.q[i] = track.v[i];
    }
}

// The prediction, its unbalanced forces, and the forward sweep, block by block. The unbalanced force of a
// body needs the hinge after it, and that hinge needs the prediction of the next body, so the later passes
// stay one body behind.
void Simulation::Impl::sweep_forward() {
  const std::size_t n = model_.bodies;
  const Field p = predicted_displacement(tracks_), q = predicted_velocity(tracks_);
  const auto complete = [&](std::size_t begin, std::size_t end) {
    hinge_forces(model_, p, q, begin, end, hinge_forces_);
    unbalanced(model_, p, q, load_, hinge_forces_, begin, end, r_);
    riccati_.forward(r_, begin, end);
  };
  std::size_t done = 1;
  for (std::size_t begin = 1; begin <= n; begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, n + 1);
    for (Track& track : tracks_) integrator_.predict(track, begin, end);
    if (begin == 1) hinge_forces(model_, p, q, 0, 1, hinge_forces_);
    complete(done, end - 1);
    done = end - 1;
  }
  complete(n, n + 1);
}

// The backward sweep and the state at the end of the step, block by block.
void Simulation::Impl::sweep_back() {
  for (std::size_t end = model_.bodies + 1; end > 1;) {
    const std::size_t begin = end > kBlock + 1 ? end - kBlock : 1;
    riccati_.back(y_, begin, end);
    finish(begin, end);
    end = begin;
  }
  ++iterations_;
  check_finite();
}

// The state at the end of the step, for bodies whose following bodies already have theirs.
void Simulation::Impl::finish(std::size_t begin, std::size_t end) {
  for (std::size_t c = 0; c < 3; ++c) integrator_.correct(tracks_[c], y_[c], begin, end);
  results_.take(model_, curved_, tracks_, begin, end);
}

// The unbalanced forces of the prediction, for all bodies at once.
void Simulation::Impl::balance() {
  const std::size_t n = model_.bodies;
  const Field p = predicted_displacement(tracks_), q = predicted_velocity(tracks_);
  hinge_forces(model_, p, q, 0, n + 1, hinge_forces_);
  unbalanced(model_, p, q, load_, hinge_forces_, 1, n + 1, r_);
}

// One solution of the linear equations with the present tangents.
void Simulation::Impl::solve() {
  const std::size_t n = model_.bodies;
  riccati_.forward(r_, 1, n + 1);
  riccati_.back(y_, 1, n + 1);
  ++iterations_;
  check_finite();
}

// Both sweeps together carry any value that is not finite to the first body, so only that one is checked.
void Simulation::Impl::check_finite() {
  if (!std::isfinite(y_[0][1] + y_[1][1] + y_[2][1])) report_unstable();
}

// Solves until the force of every hinge lies on its curve; once is enough if no hinge leaves its straight
// piece.
void Simulation::Impl::solve_to_curves() {
  const Field x{trial_[0].data(), trial_[1].data(), trial_[2].data()};
  for (int iteration = 1;; ++iteration) {
    solve();
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < trial_[c].size(); ++i) trial_[c][i] = tracks_[c].p[i] + y_[c][i];
    const CurvedHinges::Check check = curved_.compare(model_, x);
    if (check.error <= settings_.tolerance) return;
    if (iteration == settings_.max_iterations)
      throw protocol::Unstable(fmt::format(
          "step {}, t = {} s: the {} force of joint {} deviates from its curve by {:.2g} of the curve's "
          "largest force after {} iterations: take a smaller dt or a smoother curve",
          steps_ + 1, (steps_ + 1) * settings_.dt, direction_name(check.direction), check.hinge, check.error,
          iteration));
    // The prediction stays the same, but new tangents give other hinge forces at it, so they are balanced
    // again.
    const std::size_t changed = curved_.relinearize(x, iteration > kBold, model_);
    factor(changed);
    balance();
  }
}

void Simulation::Impl::step(const Excitation& at_end) {
  const FlushDenormals fast;
  set_load(at_end);
  move_abutments(at_end);
  predict_abutments();
  // Linear hinges let each block pass through all stages while it is in the cache. Curves need the
  // deformations of the whole chain before their tangents are known.
  if (curved_.empty()) {
    sweep_forward();
    sweep_back();
  } else {
    for (Track& track : tracks_) integrator_.predict(track, 1, model_.bodies + 1);
    balance();
    solve_to_curves();
    finish(1, model_.bodies + 1);
  }
  ++steps_;
}

// Finds the accelerations from M a = r at t = 0, where the prediction is the initial motion itself.
void Simulation::Impl::start(const InitialMotion& motion, const Excitation& at_start) {
  if (steps_ > 0) throw std::logic_error("start() comes before the first step");
  const std::array<std::span<const double>, 3> x{given(motion.x, "x"), given(motion.y, "y"),
                                                 given(motion.rotation, "rotation")},
      v{given(motion.vx, "vx"), given(motion.vy, "vy"), given(motion.spin, "spin")};
  set_load(at_start);
  for (std::size_t c = 0; c < 3; ++c) {
    std::copy(x[c].begin(), x[c].end(), tracks_[c].x.begin() + 1);
    std::copy(v[c].begin(), v[c].end(), tracks_[c].v.begin() + 1);
  }
  move_abutments(at_start);
  for (Track& track : tracks_) {
    track.p = track.x;
    track.q = track.v;
  }
  // At the initial displacements themselves the tangents have the forces of the curves, so that the first
  // accelerations are exact.
  factor(curved_.relinearize(displacement(tracks_), false, model_));
  balance();
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<double>& mass = c < 2 ? model_.mass : model_.inertia;
    for (std::size_t i = 1; i <= model_.bodies; ++i) tracks_[c].a[i] = r_[c][i] / mass[i];
  }
  results_.start(model_, curved_, tracks_);
}

void Simulation::Impl::report_unstable() const {
  const std::string when = fmt::format("step {}, t = {} s", steps_ + 1, (steps_ + 1) * settings_.dt);
  for (std::size_t i = 1; i <= model_.bodies; ++i)
    if (!std::isfinite(r_[0][i] + r_[1][i] + r_[2][i]))
      throw protocol::Unstable(fmt::format("{}: the force on body {} is not finite", when, i - 1));
  throw protocol::Unstable(when + ": the motion is not finite");
}

BodyMotion Simulation::Impl::motion() const {
  const auto& [x, y, rotation] = tracks_;
  return {of_bodies(x.x),        of_bodies(y.x), of_bodies(rotation.x), of_bodies(x.v),       of_bodies(y.v),
          of_bodies(rotation.v), of_bodies(x.a), of_bodies(y.a),        of_bodies(rotation.a)};
}

Joints Simulation::Impl::joints() const {
  const auto& [opening, slip, turn] = results_.deformation;
  const auto& [axial, shear, moment] = results_.force;
  return {{opening, axial}, {slip, shear}, {turn, moment}};
}

Simulation::Simulation(const Chain& chain, const Settings& settings) {
  check(chain);
  check(settings);
  impl_ = std::make_unique<Impl>(chain, settings);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::start(const InitialMotion& motion, const Excitation& at_start) {
  impl_->start(motion, at_start);
}
void Simulation::step(const Excitation& at_end) {
  impl_->step(at_end);
}
long Simulation::steps() const {
  return impl_->steps_;
}
double Simulation::time() const {
  return impl_->steps_ * impl_->settings_.dt;
}
long Simulation::iterations() const {
  return impl_->iterations_;
}
BodyMotion Simulation::bodies() const {
  return impl_->motion();
}
Joints Simulation::joints() const {
  return impl_->joints();
}
const Envelopes& Simulation::envelopes() const {
  return impl_->results_.envelopes;
}

}  // namespace adit::simplified::chain
