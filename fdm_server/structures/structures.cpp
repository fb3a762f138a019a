#include "fdm_server/structures/structures.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "protocol/participant/local_damping.hpp"

namespace adit::fdm {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::vector<std::uint32_t> installed(std::span<const std::uint32_t> stages, std::uint32_t stage) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < stages.size(); ++i)
    if (stages[i] <= stage) numbers.push_back(i);
  return numbers;
}

// Moves the numbers that pass out of a list; both keep their order.
template <class Test>
std::vector<std::uint32_t> take_if(std::vector<std::uint32_t>& list, Test&& passes) {
  std::vector<std::uint32_t> taken;
  std::ranges::copy_if(list, std::back_inserter(taken), passes);
  std::erase_if(list, passes);
  return taken;
}

template <class Element>
bool touches(const Element& element, const std::vector<bool>& chosen) {
  return std::ranges::any_of(element.points(), [&](auto point) { return chosen[point]; });
}

}  // namespace

std::uint32_t Structures::add_rotation(std::uint32_t point) {
  point_.push_back(point);
  held_from_.push_back(std::numeric_limits<std::uint32_t>::max());
  for (auto* column : {&angle_, &rate_, &rate_before_, &couple_, &inertia_}) column->push_back(0.0);
  return static_cast<std::uint32_t>(point_.size() - 1);
}

std::uint32_t Structures::shared_rotation(std::uint32_t point) {
  const auto found = shared_.find(point);
  return found != shared_.end() ? found->second : shared_[point] = add_rotation(point);
}

void Structures::hold(std::uint32_t rotation) {
  held_from_[rotation] = std::min(held_from_[rotation], adding_);
}

std::uint32_t Structures::add_beam(const Beam& beam, std::shared_ptr<const sections::FibreSection> fibres) {
  const bool has = fibres != nullptr;
  if (has) fibre_beams_.emplace_back(beam, std::move(fibres));
  return add(beam, has ? static_cast<std::uint32_t>(fibre_beams_.size() - 1) : kNone, kNone);
}

std::uint32_t Structures::add_member_beam(const Beam& beam,
                                          std::shared_ptr<const sections::FibreSection> fibres) {
  member_beams_.emplace_back(beam, std::move(fibres));
  return add(beam, kNone, static_cast<std::uint32_t>(member_beams_.size() - 1));
}

std::uint32_t Structures::add(const Beam& beam, std::uint32_t fibres, std::uint32_t member_beam) {
  beams_.push_back(beam);
  fibres_of_beam_.push_back(fibres);
  member_beam_of_beam_.push_back(member_beam);
  segment_joint_of_beam_.push_back(kNone);
  stage_of_beam_.push_back(adding_);
  const auto number = static_cast<std::uint32_t>(beams_.size() - 1);
  if (adding_ <= stage_) add_inertia_of_beam(number);
  return number;
}

std::uint32_t Structures::add_member(std::uint32_t first_beam, std::uint32_t beams,
                                     const MemberStrength& strength) {
  members_.emplace_back(first_beam, beams, strength);
  return static_cast<std::uint32_t>(members_.size() - 1);
}

const FibreBeam* Structures::fibres(std::size_t beam) const {
  if (member_beam_of_beam_[beam] != kNone) return member_beams_[member_beam_of_beam_[beam]].fibres();
  return fibres_of_beam_[beam] != kNone ? &fibre_beams_[fibres_of_beam_[beam]] : nullptr;
}

std::uint32_t Structures::add_bar(const Bar& bar) {
  bars_.push_back(bar);
  stage_of_bar_.push_back(adding_);
  return static_cast<std::uint32_t>(bars_.size() - 1);
}

std::uint32_t Structures::add_dowel(const Dowel& dowel) {
  dowels_.push_back(dowel);
  stage_of_dowel_.push_back(adding_);
  return static_cast<std::uint32_t>(dowels_.size() - 1);
}

void Structures::add_segment_joint(std::uint32_t beam, std::size_t end, std::shared_ptr<const JointLaw> law) {
  segment_joint_of_beam_[beam] = static_cast<std::uint32_t>(segment_joints_.size());
  segment_joints_.emplace_back(std::move(law), beams_[beam], end);
}

void Structures::add_joint(std::uint32_t first, std::uint32_t second, double stiffness, double yield,
                           double dt) {
  joints_.push_back({first, second, {stiffness, yield}, dt});
  if (adding_ <= stage_) add_inertia(joints_.back());
  stage_of_joint_.push_back(adding_);
}

double Structures::scale(double critical_step) const {
  return scaled_step_ > 0 ? (scaled_step_ / critical_step) * (scaled_step_ / critical_step) : 1;
}

double Structures::critical_step(std::size_t beam) const {
  return member_beam_of_beam_[beam] != kNone ? MemberBeam::critical_step(beams_[beam])
                                             : beams_[beam].critical_step();
}

void Structures::add_inertia_of_beam(std::size_t beam) {
  for (const auto rotation : beams_[beam].rotations())
    inertia_[rotation] += scale(critical_step(beam)) * beams_[beam].end_inertia();
}

void Structures::add_inertia(const Joint& joint) {
  for (const auto rotation : {joint.first, joint.second})
    inertia_[rotation] += scale(joint.step) * (joint.spring.stiffness() * joint.step * joint.step / 2);
}

void Structures::scale_masses(double step) {
  scaled_step_ = step;
  find_inertias();
}

void Structures::install(std::uint32_t stage) {
  stage_ = stage;
  find_inertias();
}

void Structures::find_inertias() {
  std::ranges::fill(inertia_, 0.0);
  for (const auto i : installed(stage_of_beam_, stage_)) add_inertia_of_beam(i);
  for (const auto i : installed(stage_of_joint_, stage_)) add_inertia(joints_[i]);
}

void Structures::add_masses(std::span<double> of_points, std::uint32_t stage) const {
  for (const auto i : installed(stage_of_beam_, stage))
    for (const auto point : beams_[i].points())
      of_points[point] += scale(critical_step(i)) * beams_[i].end_mass();
  for (const auto i : installed(stage_of_bar_, stage))
    for (const auto point : bars_[i].points())
      of_points[point] += scale(bars_[i].critical_step()) * bars_[i].end_mass();
}

void Structures::add_masses_of_dowels(std::span<double> of_points, double step) const {
  for (const auto i : installed(stage_of_dowel_, stage_))
    for (const auto point : dowels_[i].points()) of_points[point] += dowels_[i].end_mass(step);
}

void Structures::mark_points(std::vector<bool>& touched) const {
  for (const auto& beam : beams_)
    for (const auto point : beam.points()) touched[point] = true;
  for (const auto& bar : bars_)
    for (const auto point : bar.points()) touched[point] = true;
}

std::optional<std::uint32_t> Structures::later_point(const std::vector<bool>& chosen) const {
  const auto search = [&chosen](const auto& elements, std::span<const std::uint32_t> stages) {
    std::optional<std::uint32_t> found;
    for (std::size_t i = 0; i < elements.size(); ++i)
      for (const auto point : elements[i].points())
        if (stages[i] > 0 && chosen[point]) found = point;
    return found;
  };
  const auto of_beams = search(beams_, stage_of_beam_);
  return of_beams ? of_beams : search(bars_, stage_of_bar_);
}

Structures::Critical Structures::critical_element() const {
  return smallest([](const auto&) { return true; });
}

Structures::Critical Structures::critical_element(const std::vector<bool>& chosen) const {
  return smallest([&](const auto& element) { return touches(element, chosen); });
}

template <class Test>
Structures::Critical Structures::smallest(Test&& counts) const {
  // All stages count, because the step of a run stays the same when more is installed.
  Critical smallest;
  const auto compare = [&](const auto& element, double step, const char* kind) {
    if (step < smallest.step && counts(element))
      smallest = {step, kind, {element.points()[0], element.points()[1]}};
  };
  for (std::size_t i = 0; i < beams_.size(); ++i) compare(beams_[i], critical_step(i), "beam");
  for (const Bar& bar : bars_) compare(bar, bar.critical_step(), "bolt");
  return smallest;
}

Structures::Part Structures::standing() const {
  Part part{installed(stage_of_beam_, stage_),
            installed(stage_of_bar_, stage_),
            installed(stage_of_joint_, stage_),
            {},
            {},
            installed(stage_of_dowel_, stage_)};
  for (std::uint32_t i = 0; i < members_.size(); ++i)
    if (stage_of_beam_[members_[i].first_beam()] <= stage_) part.members.push_back(i);
  for (std::uint32_t i = 0; i < inertia_.size(); ++i)
    if (inertia_[i] > 0) part.rotations.push_back(i);
  return part;
}

Structures::Part Structures::take(Part& part, const std::vector<bool>& chosen) const {
  return {take_if(part.beams, [&](auto i) { return touches(beams_[i], chosen); }),
          take_if(part.bars, [&](auto i) { return touches(bars_[i], chosen); }),
          take_if(part.joints, [&](auto i) { return chosen[point_[joints_[i].first]]; }),
          take_if(part.rotations, [&](auto i) { return chosen[point_[i]]; }),
          take_if(part.members,
                  [&](auto i) {
                    return touches(beams_[members_[i].first_beam() + members_[i].count() - 1], chosen);
                  }),
          take_if(part.dowels, [&](auto i) { return touches(dowels_[i], chosen); })};
}

std::vector<StrainForm> Structures::strains(const Part& part) const {
  std::vector<StrainForm> strains;
  for (const auto i : part.beams)
    if (member_beam_of_beam_[i] != kNone)
      std::ranges::move(MemberBeam::strains(beams_[i]), std::back_inserter(strains));
    else
      std::ranges::move(beams_[i].strains(), std::back_inserter(strains));
  for (const auto i : part.bars) strains.push_back(bars_[i].strain());
  for (const auto i : part.joints) {
    const auto& [first, second, spring, step] = joints_[i];
    strains.push_back(
        {spring.stiffness(), {{{Freedom::kRotation, first}, -1}, {{Freedom::kRotation, second}, 1}}});
  }
  for (const auto i : part.dowels) std::ranges::move(dowels_[i].strains(), std::back_inserter(strains));
  return strains;
}

void Structures::add_forces_of_beam(std::uint32_t number, double dt, const PointView& points) {
  const RotationView rotations{rate_.data(), couple_.data()};
  Beam& beam = beams_[number];
  const std::uint32_t member = member_beam_of_beam_[number], fibres = fibres_of_beam_[number],
                      joint = segment_joint_of_beam_[number];
  if (member != kNone) {
    member_beams_[member].add_forces(beam, dt, points, rotations);
    return;
  }
  if (fibres == kNone && joint == kNone) {
    beam.add_forces(dt, points, rotations);
    return;
  }
  const auto [e, b, a] = beam.rates(points, rotations);
  BeamStrains step{dt * e, dt * b, dt * a};
  if (joint != kNone) step = segment_joints_[joint].strain(beam, step);
  beam.add_forces(
      fibres != kNone ? fibre_beams_[fibres].strain(step) : beam.resultants() + beam.resists(step), points,
      rotations);
  if (joint != kNone) segment_joints_[joint].book(beam);
}

void Structures::add_forces(const Part& part, double dt, const PointView& points) {
  for (const auto i : part.beams) add_forces_of_beam(i, dt, points);
  for (const auto i : part.bars) dissipated_ += bars_[i].add_forces(dt, points);
  for (const auto i : part.dowels) dissipated_ += dowels_[i].add_forces(dt, points);
  for (const auto i : part.joints) {
    auto& [first, second, spring, step] = joints_[i];
    dissipated_ += spring.strain(dt * (rate_[second] - rate_[first]));
    couple_[first] += spring.force();
    couple_[second] -= spring.force();
  }
}

void Structures::move_and_predict(const Part& part, const protocol::Step& step) {
  for (const auto i : part.rotations) {
    angle_[i] += step.dt * rate_[i];
    rate_before_[i] = rate_[i];
    if (step.local_damping > 0) couple_[i] = protocol::damped(couple_[i], 0, rate_[i], step.local_damping);
    if (!held(i)) rate_[i] += step.kick() * (couple_[i] / inertia_[i]);
    // Ready for the next step, whose forces are added one by one.
    couple_[i] = 0;
  }
  if (step.relax) return;
  for (const auto i : part.members) {
    const auto first = members_[i].first_beam(), count = members_[i].count();
    members_[i].look(std::span(beams_).subspan(first, count),
                     std::span(member_beams_).subspan(member_beam_of_beam_[first], count), step.time());
  }
}

void Structures::slow(double factor) {
  for (double& rate : rate_) rate *= factor;
}

void Structures::start_over() {
  slow(0);
  std::ranges::fill(angle_, 0.0);
  dissipated_ = 0;
  for (FibreBeam& beam : fibre_beams_) beam.forget_dissipation();
  for (MemberBeam& beam : member_beams_) beam.forget_dissipation();
  for (SegmentJoint& joint : segment_joints_) joint.forget_dissipation();
}

double Structures::twice_kinetic_energy(const protocol::Step& step) const {
  double sum = 0;
  for (std::size_t i = 0; i < rate_.size(); ++i)
    // From rest the half step before the start mirrors the one after it, as for the points.
    sum += inertia_[i] * (step.from_rest() ? -rate_[i] : rate_before_[i]) * rate_[i];
  return sum;
}

double Structures::rotational_energy() const {
  double twice = 0;
  for (std::size_t i = 0; i < rate_.size(); ++i) twice += inertia_[i] * rate_[i] * rate_[i];
  return twice / 2;
}

double Structures::strain_energy() const {
  double sum = 0;
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    if (member_beam_of_beam_[i] != kNone)
      sum += member_beams_[member_beam_of_beam_[i]].stored();
    else if (fibres_of_beam_[i] != kNone)
      sum += fibre_beams_[fibres_of_beam_[i]].stored();
    else
      sum += beams_[i].strain_energy();
  }
  for (const auto& bar : bars_) sum += bar.strain_energy();
  for (const auto& joint : joints_) sum += joint.spring.strain_energy();
  for (const auto& dowel : dowels_) sum += dowel.strain_energy();
  for (const SegmentJoint& joint : segment_joints_) sum += joint.stored();
  return sum;
}

double Structures::dissipated() const {
  double sum = dissipated_;
  for (const FibreBeam& beam : fibre_beams_) sum += beam.dissipated();
  for (const MemberBeam& beam : member_beams_) sum += beam.dissipated();
  for (const SegmentJoint& joint : segment_joints_) sum += joint.dissipated();
  return sum;
}

}  // namespace adit::fdm
