// What a stage of excavation changes in the solver.
#include "dem_server/engines/general/build_arrays.hpp"
#include "dem_server/engines/general/solver.hpp"
#include "dem_server/engines/general/stages/carry_over.hpp"

namespace adit::dem {

// A force on the first disc of a pair and its opposite on the second, with their moments, weighted.
struct Solver::PairLoad {
  std::uint32_t first, second;
  double x, y, moment_1, moment_2;
};

// Of the forces between a disc that vanishes and one that stays, the share that is held stays on the latter.
void Solver::hold(const PairLoad& load, const ParticleStage& stage) {
  const auto vanishes = [&](std::uint32_t i) { return particles_.is_there(i) && !stage.present[i]; };
  const bool first = vanishes(load.first), second = vanishes(load.second);
  if (first == second) return;
  const double share = stage.held[first ? load.first : load.second], sign = first ? -share : share;
  if (share == 0) return;
  held_.push_back({first ? load.second : load.first, sign * load.x, sign * load.y,
                   share * (first ? load.moment_2 : load.moment_1)});
}

void Solver::hold_what_vanishes(const ParticleStage& stage) {
  held_.clear();
  for (const Pairs* pairs : {&bonds_, &neighbours_.pairs()})
    for (std::uint32_t k = 0; k < pairs->size(); ++k) {
      const PairState s = state_of(k, laws_, particles_, *pairs);
      const double w = pairs->weight[k];
      const PlaneVector force = vector_of(s.nx, s.ny, s.bond_normal + s.contact_normal, s.shear);
      const Arms arms = arms_of(s.length, pairs->half_difference[k]);
      hold({pairs->first[k], pairs->second[k], w * force.x, w * force.y,
            w * (s.shear * arms.first + s.moment), w * (s.shear * arms.second - s.moment)},
           stage);
    }
  for (std::uint32_t k = 0; k < facets_.size(); ++k) {
    const auto [x, y, moment_1, moment_2] = facets_.action(k, particles_);
    hold({facets_.set().first[k], facets_.set().second[k], x, y, moment_1, moment_2}, stage);
  }
  for (const CellContacts::Contact& contact : cells_.contacts())
    if (const auto meets = cells_.encounter(contact, facets_.set(), particles_)) {
      const double w = cells_.weight(contact, particles_);
      const PlaneVector force =
          vector_of(meets->nx, meets->ny, w * contact.touch.normal, w * contact.touch.shear);
      const auto turning = [&force](const PlaneVector& arm) {
        return across(arm.x, arm.y, force.x, force.y);
      };
      hold({contact.first, contact.second, force.x, force.y, turning(meets->arm_1), -turning(meets->arm_2)},
           stage);
    }
  for (const Joints::Joint& j : joints_.joints()) {
    const PlaneVector force = vector_of(j.nx, j.ny, j.weight * j.normal, j.weight * j.springs.shear);
    hold({j.first, j.second, force.x, force.y, 0, 0}, stage);
  }
}

void Solver::begin_stage(std::uint32_t before, const ParticleStage& stage, const Model& model) {
  hold_what_vanishes(stage);
  set_masses(model, particles_);
  adit::dem::stop(particles_);
  Bonded bonded = bonds_of(model);
  carry_over({laws_, bonds_}, stage.fresh, bonded.laws, particles_, bonded.bonds);
  carry_over(joints_.joints(), stage.fresh, bonded.joints);
  take_laws(std::move(bonded.laws));
  bonds_ = std::move(bonded.bonds);
  bond_of_pair_ = std::move(bonded.bond_of_pair);
  joints_.replace(std::move(bonded.joints));
  facets_.begin_stage(model, stage.fresh, particles_);
  if (cells_.empty())
    neighbours_.begin_stage(particles_, pairs_of(model.bonds), model.group, bonded.first_contact_law,
                            stage.fresh);
  else
    cells_.begin_stage(model, stage.fresh, facets_.set(), particles_);
  walls_.list(particles_);
  springs_.begin_stage(before, stage.number, particles_);
  bars_.begin_stage(before, stage.number, particles_);
  renew_damping();
  planned_ = false;
}

}  // namespace adit::dem
