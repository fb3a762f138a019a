// Half of a joint of two segments (joint_law.hpp), in series with the end of a beam; the other half is in the
// beam that meets it, so that nothing tells one side from the other. The grid point and its rotation are the
// middle of the joint. At an end that cannot rotate, in a plane of symmetry, half a joint is all.
//
// Of the strains of beam.hpp the half takes d/2, d = (delta, phi) the growth of the joint's opening as it
// sees it:
//   e' = e - delta/2,   b' = b - phi/2,   a' = a + phi/2 at the first end, a - phi/2 at the second
// are left to the beam, whose forces there are N and M = B - S, M = B + S. Faces do not slide on one another.
// d is what makes the forces of the joint equal to those of the beam, were it elastic in this step: with K
// its stiffness against delta and phi, and F_0 what it would bear without d,
//   F_joint(u + d) + K d/2 = F_0.
// An elastic beam is then in equilibrium with its joint. What a beam of fibres misses, the next step finds,
// because F_0 goes on from the forces that the beam has. In series a joint only makes a beam softer: the
// critical step and mean_acceleration.hpp are those of the beam alone. A joint has no mass.
//
// Energy: the ledger of continuum.hpp books the mean of the forces of two steps over d. Where the law bends
// this misses the growth of the stored energy by a little, to either side; faces that meet at the pace of the
// step would make energy of it and heat the lining. What a half took up beyond what it stores and its bolts
// dissipate is its spare, and no step may bring it below 0. Where one would, the half creeps instead, with
//   F_joint(u + d) + (1 + c) K d/2 = F_0,
// the least c with which it does not; it may rest. So a half in an elastic beam never gives more than it got,
// whatever the step; and the beam's own energy bounds its forces: motion is stable up to the critical step of
// the beam. Smooth motion hardly notices, because its misses are small and come back.
// Dissipated since the start: the work on the half less what it stores.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fdm_server/structures/beam.hpp"
#include "fdm_server/structures/joint_law.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class SegmentJoint {
 public:
  // At the first or the second end. The law has an installed() opening.
  SegmentJoint(std::shared_ptr<const JointLaw> law, const Beam& beam, std::size_t end);

  // Takes its part of a step's strains, and returns those of the beam.
  BeamStrains strain(const Beam& beam, const BeamStrains& step);
  // Books the work of the same step, once the beam has its forces.
  void book(const Beam& beam);

  const JointLaw& law() const { return *law_; }
  const JointOpening& opening() const { return opening_; }  // of the whole joint, as this half sees it
  const JointForces& forces() const { return forces_; }     // of the beam's end
  std::span<const double> slack() const { return slack_; }  // of the rows of bolts [m]

  double stored() const { return law_->stored(opening_, slack_) / 2; }  // [J]
  double dissipated() const { return work_ - stored(); }
  void forget_dissipation() {
    work_ = stored();
    by_bolts_ = 0;
  }

  void exchange(state::Archive& archive);

 private:
  JointForces at_end(const BeamResultants& forces) const;
  std::vector<double> slack_at(const JointOpening& opening) const;  // once bolts yielded on the way there
  double yielded(std::span<const double> slack) const;  // what they dissipate until this is theirs [J]

  std::shared_ptr<const JointLaw> law_;
  double side_;            // of S in M
  Eigen::Matrix2d stiff_;  // K/2
  JointOpening opening_;
  std::vector<double> slack_;
  JointForces forces_ = JointForces::Zero();
  double work_;
  double by_bolts_ = 0;                       // dissipated [J]
  JointOpening step_ = JointOpening::Zero();  // d, from strain() to book()
};

}  // namespace adit::fdm
