// A state from which fdm_server goes on.
#include "fdm_server/participant/participant.hpp"
#include "tests/fuzz/session/restore.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kFdmState(
    "fdm_state",
    [](std::string_view input) {
      fdm::FdmParticipant participant;
      go_on_from(input, participant, kScenesOfGround);
    },
    kModelMemory);

}  // namespace
}  // namespace adit::fuzz
