#include "fdm_server/structures/fibre_beam.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace adit::fdm {
namespace {

using std::numbers::inv_sqrt3;
using std::numbers::sqrt3;

}  // namespace

Section elastic_section(const sections::FibreSection& section, double shear_modulus, double density,
                        bool shear_flexible) {
  const auto& [thickness, width, bars] = section.shape();
  Section elastic = make_section({0, shear_modulus, density}, thickness * width,
                                 width * thickness * thickness * thickness / 12, shear_flexible);
  elastic.axial = section.axial();
  elastic.bending = section.bending();
  elastic.eccentricity = section.centroid();
  return elastic;
}

FibreBeam::FibreBeam(const Beam& beam, std::shared_ptr<const sections::FibreSection> section)
    : section_(std::move(section)),
      length_(beam.chord().length),
      phi_(beam.shear_flexibility()),
      states_{sections::FibreStates(*section_), sections::FibreStates(*section_)} {}

BeamResultants FibreBeam::strain(const BeamStrains& step) {
  const double bending = 3 * section_->bending() / length_;  // dS_b/da_b of the elastic beam
  const double shear = phi_ > 0 ? bending / phi_ : 0;        // k_s
  const double correction = phi_ > 0 ? mismatch_ / (bending + shear) : 0;
  elongation_ += step.e + section_->centroid() * step.b;
  turn_ += step.b;
  bent_ += step.a / (1 + phi_) + correction;
  sheared_ += step.a * phi_ / (1 + phi_) - correction;
  difference_ -= thrusts_ / (2 * section_->axial());

  std::array<sections::SectionForces, 2> at{};  // about the centroid
  for (std::size_t k = 0; k < 2; ++k) {
    const double side = k == 0 ? -1 : 1, curvature = turn_ / length_ + side * inv_sqrt3 * 3 * bent_ / length_,
                 strain = elongation_ / length_ + side * difference_;
    at[k] = states_[k].strain_to(*section_, strain - curvature * section_->centroid(), curvature);
    at[k].moment -= at[k].thrust * section_->centroid();
  }
  const double bent = sqrt3 / 2 * (at[1].moment - at[0].moment), sheared = shear * sheared_;
  thrusts_ = at[1].thrust - at[0].thrust;
  mismatch_ = phi_ > 0 ? sheared - bent : 0;
  const double thrust = (at[0].thrust + at[1].thrust) / 2;
  const BeamResultants now{thrust, (at[0].moment + at[1].moment) / 2 + thrust * section_->centroid(),
                           (bent + phi_ * sheared) / (1 + phi_)};
  work_ += ((forces_.n + now.n) * step.e + (forces_.b + now.b) * step.b + (forces_.s + now.s) * step.a) / 2;
  forces_ = now;
  return now;
}

double FibreBeam::stored() const {
  const double shear = phi_ > 0 ? 3 * section_->bending() / length_ / phi_ : 0;
  return length_ / 2 * (states_[0].stored(*section_) + states_[1].stored(*section_)) +
         shear * sheared_ * sheared_ / 2;
}

double FibreBeam::curvature(std::size_t end) const {
  return (turn_ + (end == 0 ? -3 : 3) * bent_) / length_;
}

void FibreBeam::exchange(state::Archive& archive) {
  for (sections::FibreStates& states : states_) states.exchange(archive);
  archive("fibre_beam_elongation", elongation_);
  archive("fibre_beam_turn", turn_);
  archive("fibre_beam_bent", bent_);
  archive("fibre_beam_sheared", sheared_);
  archive("fibre_beam_difference", difference_);
  archive("fibre_beam_forces", forces_);
  archive("fibre_beam_thrusts", thrusts_);
  archive("fibre_beam_mismatch", mismatch_);
  archive("fibre_beam_work", work_);
}

}  // namespace adit::fdm
