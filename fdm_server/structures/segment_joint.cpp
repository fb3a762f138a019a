#include "fdm_server/structures/segment_joint.hpp"

#include <algorithm>
#include <utility>

namespace adit::fdm {

SegmentJoint::SegmentJoint(std::shared_ptr<const JointLaw> law, const Beam& beam, std::size_t end)
    : law_(std::move(law)), side_(end == 0 ? -1 : 1), opening_(law_->installed().value()) {
  stiff_.col(0) = at_end(beam.resists({1, 0, 0})) / 2;
  stiff_.col(1) = at_end(beam.resists({0, 1, side_})) / 2;
  for (const JointBolts& row : law_->bolts)
    slack_.push_back(opening_at(opening_, row.position) - row.pretension / row.stiffness);
  work_ = stored();
}

JointForces SegmentJoint::at_end(const BeamResultants& forces) const {
  return {forces.n, forces.b + side_ * forces.s};
}

BeamStrains SegmentJoint::strain(const Beam& beam, const BeamStrains& step) {
  const JointForces trial = at_end(beam.resultants() + beam.resists(step));
  const double spare = std::max(0.0, dissipated() - by_bolts_), before = stored();
  const auto gives = [&](const JointOpening& way) {
    const auto slack = slack_at(opening_ + way);
    const double taken = (forces_ + trial - stiff_ * way).dot(way) / 4;
    return law_->stored(opening_ + way, slack) / 2 + yielded(slack) - before > taken + spare;
  };
  step_ = law_->solve(opening_, slack_, stiff_, trial);
  if (gives(step_)) {
    constexpr int kHalvings = 50;
    double least = 0, most = 1;  // 1/(1 + c)
    step_.setZero();
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (least + most) / 2;
      const JointOpening slower = law_->solve(opening_, slack_, stiff_ / middle, trial);
      if (gives(slower)) {
        most = middle;
      } else {
        least = middle;
        step_ = slower;
      }
    }
  }
  opening_ += step_;
  const auto slack = slack_at(opening_);
  by_bolts_ += yielded(slack);
  slack_ = slack;
  return {step.e - step_[0] / 2, step.b - step_[1] / 2, step.a - side_ * step_[1] / 2};
}

void SegmentJoint::book(const Beam& beam) {
  const JointForces now = at_end(beam.resultants());
  work_ += (forces_ + now).dot(step_) / 4;
  forces_ = now;
}

std::vector<double> SegmentJoint::slack_at(const JointOpening& opening) const {
  std::vector<double> slack = slack_;
  for (std::size_t k = 0; k < slack.size(); ++k) {
    const JointBolts& row = law_->bolts[k];
    slack[k] = std::max(slack[k], opening_at(opening, row.position) - row.yield / row.stiffness);
  }
  return slack;
}

double SegmentJoint::yielded(std::span<const double> slack) const {
  double sum = 0;
  for (std::size_t k = 0; k < slack.size(); ++k)
    if (slack[k] > slack_[k]) sum += law_->bolts[k].yield * (slack[k] - slack_[k]) / 2;
  return sum;
}

void SegmentJoint::exchange(state::Archive& archive) {
  archive("segment_joint_opening", std::span(opening_.data(), 2));
  archive("segment_joint_slack", std::span(slack_));
  archive("segment_joint_forces", std::span(forces_.data(), 2));
  archive("segment_joint_work", work_);
  archive("segment_joint_by_bolts", by_bolts_);
}

}  // namespace adit::fdm
