#include "fdm_server/structures/member_beam.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace adit::fdm {
namespace {

constexpr double kReserve = 1.25, kTurn = 0.075;  // 1 + r
constexpr double kAcross = (1 + 1 / (kReserve - 1)) * kTurn * kTurn + 2e-3;

}  // namespace

MemberBeam::MemberBeam(const Beam& beam, std::shared_ptr<const sections::FibreSection> section)
    : length_(beam.chord().length),
      share_(std::pow(1 + beam.shear_flexibility(), -2)),
      chord_(beam.chord()),
      strength_(std::numeric_limits<double>::infinity()) {
  if (section) fibres_.emplace(beam, std::move(section));
}

std::vector<StrainForm> MemberBeam::strains(const Beam& beam) {
  const auto of_beam = beam.strains();
  std::vector<StrainForm> strains(of_beam.begin(), of_beam.end());
  for (StrainForm& strain : strains) strain.stiffness *= kReserve;
  const auto [p, q] = beam.points();
  const auto [x, y, length] = beam.chord();
  using enum Freedom::Kind;
  strains.push_back(
      {kAcross * of_beam[0].stiffness, {{{kX, p}, y}, {{kY, p}, -x}, {{kX, q}, -y}, {{kY, q}, x}}});
  return strains;
}

// The gradient of w is orthogonal to that of e, but not to that of a: no eigenvalue of a sum is above the sum
// of the largest ones (Weyl), and that of w, 2 kAcross EA/(l m), is kAcross times that of e.
double MemberBeam::critical_step(const Beam& beam) {
  return beam.critical_step() / std::sqrt(kReserve + kAcross);
}

void MemberBeam::add_forces(Beam& beam, double dt, const PointView& points, const RotationView& rotations) {
  const auto [p, q] = beam.points();
  const auto [i, j] = beam.rotations();
  const double dx = dt * (points.vx[q] - points.vx[p]), dy = dt * (points.vy[q] - points.vy[p]),
               first = dt * rotations.rate[i], second = dt * rotations.rate[j];
  const Chord before = chord_;
  chord_ = fdm::chord(0, 0, before.x * before.length + dx, before.y * before.length + dy);
  const double turn =
      std::atan2(before.x * chord_.y - before.y * chord_.x, before.x * chord_.x + before.y * chord_.y);
  const double stretch = ((before.x * before.length + chord_.x * chord_.length) * dx +
                          (before.y * before.length + chord_.y * chord_.length) * dy) /
                         (before.length + chord_.length);
  const double b = second - first, a = first + second - 2 * turn;
  const double bowing = length_ * (share_ * (a_ + a / 2) * a / 20 + (b_ + b / 2) * b / 12);
  b_ += b;
  a_ += a;

  BeamResultants forces{};
  if (!lost_) {
    forces = slide(beam, respond(beam, {stretch + bowing, b, a - std::exchange(pending_, 0.0)}));
  }
  const double across = -2 / chord_.length * forces.s;
  const Ends now{chord_.x * forces.n - chord_.y * across, chord_.y * forces.n + chord_.x * across, forces.b,
                 forces.s};
  work_ += ((ends_.x + now.x) * dx + (ends_.y + now.y) * dy + (ends_.b + now.b) * b +
            (ends_.s + now.s) * (first + second)) /
           2;
  ends_ = now;
  beam.add_forces(forces, chord_, points, rotations);
}

BeamResultants MemberBeam::respond(const Beam& beam, const BeamStrains& step) {
  if (fibres_) {
    within_ = fibres_->strain(step);
  } else {
    within_ = within_ + beam.resists(step);
    elastic_energy_ = beam.elastic_energy(within_);
  }
  const auto& [n, b, s] = within_;
  return {n, b + n * length_ * b_ / 12, s + n * length_ * share_ * a_ / 20};
}

BeamResultants MemberBeam::slide(const Beam& beam, BeamResultants forces) {
  const double most = strength_ * length_ / 2;
  if (std::abs(forces.s) <= most) return forces;
  const double passes = std::copysign(most, forces.s);
  pending_ = (forces.s - passes) / beam.resists({0, 0, 1}).s;
  slip_ += std::abs(pending_) * length_ / 2;
  forces.s = passes;
  return forces;
}

double MemberBeam::stored() const {
  if (lost_) return 0;
  return fibres_ ? fibres_->stored() : elastic_energy_;
}

void MemberBeam::exchange(state::Archive& archive) {
  if (fibres_) fibres_->exchange(archive);
  archive("member_chord", chord_);
  archive("member_b", b_);
  archive("member_a", a_);
  archive("member_within", within_);
  archive("member_elastic_energy", elastic_energy_);
  archive("member_strength", strength_);
  archive("member_pending", pending_);
  archive("member_slip", slip_);
  archive("member_lost", lost_);
  archive("member_ends", ends_);
  archive("member_work", work_);
}

}  // namespace adit::fdm
