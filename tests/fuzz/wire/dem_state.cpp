// A state from which dem_server goes on.
#include "dem_server/participant/participant.hpp"
#include "tests/fuzz/session/restore.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kDemState(
    "dem_state",
    [](std::string_view input) {
      dem::DemParticipant participant;
      go_on_from(input, participant, kScenesOfParticles);
    },
    kModelMemory);

}  // namespace
}  // namespace adit::fuzz
