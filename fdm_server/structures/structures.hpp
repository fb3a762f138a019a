// Linings and bolts of a grid: beams and bars between its points, the beams' rotations, joints between them,
// dowels from one ring to the next.
//
// Translations are the points', rotations move here, by the same central differences (continuum.hpp).
// Beams that are joined rigidly at a point share one rotation there. Its inertia is that of the beams and
// joints which stand; what is installed later goes on from the angle that it finds, free of stress.
// A joint is a spring between the rotations of two beams at one point; without a spring they are hinged.
// It brings rotary inertia of its own, J = k dt^2/2 on either side, so that its frequency 2k/J is that of the
// lining's beams, 4/dt^2: stiff joints do not shorten the step. The faces of segments are in the beams
// instead (segment_joint.hpp).
//
// Critical step: where it is shorter than the run's, mean_acceleration.hpp makes up for it; else all beams,
// bars, joints and zones bring their own masses to the points and rotations, hence M = sum M_e as K = sum
// K_e, and u.Ku/u.Mu is a mean of the elements' quotients with weights u.M_e u >= 0
// (zones/critical_step.hpp): no frequency of ground and lining together exceeds the largest of one element.
//
// Statics may scale all masses and inertias of an element so that any step is its critical one, as for zones.
//
// Beams of members follow their chords and may fail (member_beam.hpp, member.hpp).
//
// No energy weights: where an overlap thins the ground, the lining stays whole.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/structures/bar.hpp"
#include "fdm_server/structures/beam.hpp"
#include "fdm_server/structures/dowel.hpp"
#include "fdm_server/structures/fibre_beam.hpp"
#include "fdm_server/structures/member.hpp"
#include "fdm_server/structures/member_beam.hpp"
#include "fdm_server/structures/segment_joint.hpp"
#include "fdm_server/structures/yielding_spring.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class Structures {
 public:
  // A rotation of one beam's end alone at a point. Returns its number.
  std::uint32_t add_rotation(std::uint32_t point);
  // The one rotation of all that is joined rigidly at a point, added where it is asked for first.
  std::uint32_t shared_rotation(std::uint32_t point);
  // It stays as it is, as on a plane of symmetry, from the stage on that is being added.
  void hold(std::uint32_t rotation);
  // What is added from now on is installed in this stage, free of stress; 0: it was always there.
  void set_stage(std::uint32_t stage) { adding_ = stage; }
  // Return the number of the beam, of the bar or dowel. A beam with `fibres` follows these, from its elastic
  // section on.
  std::uint32_t add_beam(const Beam& beam, std::shared_ptr<const sections::FibreSection> fibres = nullptr);
  // One that follows its chord.
  std::uint32_t add_member_beam(const Beam& beam,
                                std::shared_ptr<const sections::FibreSection> fibres = nullptr);
  // Lets so many of them, which have fibres, fail together, from the first on; returns the number of the
  // member.
  std::uint32_t add_member(std::uint32_t first_beam, std::uint32_t beams, const MemberStrength& strength);
  std::uint32_t add_bar(const Bar& bar);
  // Half of a joint of segments in this end of a beam, which has none in the other; it is installed with it.
  void add_segment_joint(std::uint32_t beam, std::size_t end, std::shared_ptr<const JointLaw> law);
  // `dt`: a critical step of the lining's beams. Stiffness > 0 [N m/rad], yield moment [N m].
  void add_joint(std::uint32_t first, std::uint32_t second, double stiffness, double yield, double dt);
  std::uint32_t add_dowel(const Dowel& dowel);
  // From now on masses and inertias are those that make this step [s] the critical one of every element; 0:
  // the true ones.
  void scale_masses(double step);

  // Masses of the structures that stand in this stage.
  void add_masses(std::span<double> of_points, std::uint32_t stage = 0) const;
  // Those that make this step [s] the critical one of every dowel that stands, for statics.
  void add_masses_of_dowels(std::span<double> of_points, double step) const;
  void mark_points(std::vector<bool>& touched) const;
  // A chosen point to which something is attached after stage 0, if any.
  std::optional<std::uint32_t> later_point(const std::vector<bool>& chosen) const;
  // The beam or bar with the smallest critical step [s], by its points; infinite where there is none. Of
  // all, or only of those that touch a chosen point.
  struct Critical {
    double step = std::numeric_limits<double>::infinity();
    const char* kind = "";
    std::array<std::uint32_t, 2> points{};
  };
  Critical critical_element() const;
  Critical critical_element(const std::vector<bool>& chosen) const;
  double critical_step() const { return critical_element().step; }

  // Activates the structures of the stages up to this one.
  void install(std::uint32_t stage);

  // Numbers of the elements that are computed together.
  struct Part {
    std::vector<std::uint32_t> beams, bars, joints, rotations, members, dowels;
  };
  Part standing() const;  // all that is installed
  // Moves out of a part what touches a chosen point; of the rotations those at chosen points. Members that
  // may fail are one with their last beam.
  Part take(Part& part, const std::vector<bool>& chosen) const;

  // Of beams, bars, joints and dowels, as if nothing yielded.
  std::vector<StrainForm> strains(const Part& part) const;

  void add_forces(const Part& part, double dt, const PointView& points);
  // Members fail in time, not in statics.
  void move_and_predict(const Part& part, const protocol::Step& step);
  void slow(double factor);  // multiplies the rates
  void start_over();         // rates and rotations become 0, and what was dissipated

  void exchange(state::Archive& archive) {
    for (Beam& beam : beams_) beam.exchange(archive);
    for (FibreBeam& beam : fibre_beams_) beam.exchange(archive);
    for (MemberBeam& beam : member_beams_) beam.exchange(archive);
    for (Member& member : members_) member.exchange(archive);
    for (SegmentJoint& joint : segment_joints_) joint.exchange(archive);
    for (Bar& bar : bars_) bar.exchange(archive);
    for (Joint& joint : joints_) joint.spring.exchange(archive);
    for (Dowel& dowel : dowels_) dowel.exchange(archive);
    archive("rotations_angle", std::span(angle_));
    archive("rotations_rate", std::span(rate_));
    archive("rotations_rate_before", std::span(rate_before_));
    archive("rotations_couple", std::span(couple_));
    archive("structures_dissipated", dissipated_);
  }

  // Twice the kinetic energy of the rotations at the last step, in the form of the leap-frog scheme [J].
  double twice_kinetic_energy(const protocol::Step& step) const;
  double rotational_energy() const;  // of the present rates [J]
  double strain_energy() const;      // [J]
  double dissipated() const;         // by yield, fibres and members, since the start [J]

  std::span<const Beam> beams() const { return beams_; }
  // Those of a beam, if it has any.
  const FibreBeam* fibres(std::size_t beam) const;
  std::span<const Member> members() const { return members_; }
  // That in an end of a beam, if there is one.
  const SegmentJoint* segment_joint(std::size_t beam) const {
    return segment_joint_of_beam_[beam] < segment_joints_.size()
               ? &segment_joints_[segment_joint_of_beam_[beam]]
               : nullptr;
  }
  std::span<const Bar> bars() const { return bars_; }
  std::span<const Dowel> dowels() const { return dowels_; }
  std::span<const double> rotations() const { return angle_; }  // since the start [rad]
  // One value a rotation, for mean_acceleration.hpp: rates before and after the last step, couples of this
  // one, 1/inertia or 0 where held.
  std::span<const double> rates_before() const { return rate_before_; }
  std::span<const double> rates() const { return rate_; }
  std::span<double> couples() { return couple_; }
  double inverse_inertia(std::uint32_t rotation) const { return held(rotation) ? 0 : 1 / inertia_[rotation]; }

 private:
  struct Joint {
    std::uint32_t first, second;  // rotations
    YieldingSpring spring;
    double step;  // critical [s]
  };
  template <class Test>
  Critical smallest(Test&& counts) const;
  // Of a mass, for an element of this critical step.
  double scale(double critical_step) const;
  // Of a beam, as it may be.
  double critical_step(std::size_t beam) const;
  std::uint32_t add(const Beam& beam, std::uint32_t fibres, std::uint32_t member_beam);
  void add_inertia_of_beam(std::size_t beam);
  void add_inertia(const Joint& joint);
  void find_inertias();  // of what stands
  void add_forces_of_beam(std::uint32_t number, double dt, const PointView& points);
  bool held(std::uint32_t rotation) const { return held_from_[rotation] <= stage_; }

  std::vector<Beam> beams_;
  std::vector<FibreBeam> fibre_beams_;
  std::vector<MemberBeam> member_beams_;
  std::vector<Member> members_;
  std::vector<SegmentJoint> segment_joints_;
  // Of each beam, of fibre_beams_, of member_beams_, of segment_joints_; beyond them: it has none.
  std::vector<std::uint32_t> fibres_of_beam_, member_beam_of_beam_, segment_joint_of_beam_;
  std::vector<Bar> bars_;
  std::vector<Joint> joints_;
  std::vector<Dowel> dowels_;
  std::vector<std::uint32_t> stage_of_beam_, stage_of_bar_, stage_of_joint_, stage_of_dowel_;
  std::map<std::uint32_t, std::uint32_t> shared_;  // rotations, by their points
  // one a rotation
  std::vector<std::uint32_t> point_, held_from_;                       // the stage from which it is held
  std::vector<double> angle_, rate_, rate_before_, couple_, inertia_;  // no inertia: nothing turns it yet
  std::uint32_t adding_ = 0, stage_ = 0;
  double scaled_step_ = 0;  // [s]; 0: masses are true
  double dissipated_ = 0;
};

}  // namespace adit::fdm
