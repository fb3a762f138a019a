#include "dem_server/participant/any_participant.hpp"

#include "dem_server/engines/general/observe/participant.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "dem_server/participant/participant.hpp"

namespace adit::dem {

void AnyParticipant::set_up(const wire::Setup& setup, wire::Model& model) {
  if (setup.scene().has_particles() && needs_discs(setup.scene().particles()))
    own_ = std::make_unique<DiscsParticipant>(threads_);
  else
    own_ = std::make_unique<DemParticipant>(threads_);
  own_->set_up(setup, model);
}

}  // namespace adit::dem
