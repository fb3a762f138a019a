#include "dem_server/any_participant.hpp"

#include "dem_server/discs/participant.hpp"
#include "dem_server/model/read_model.hpp"
#include "dem_server/participant.hpp"

namespace adit::dem {

void AnyParticipant::set_up(const wire::Setup& setup, wire::Model& model) {
  if (setup.scene().has_particles() && needs_discs(setup.scene().particles()))
    own_ = std::make_unique<DiscsParticipant>(threads_);
  else
    own_ = std::make_unique<DemParticipant>(threads_);
  own_->set_up(setup, model);
}

}  // namespace adit::dem
