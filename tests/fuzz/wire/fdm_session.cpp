// A session of fdm_server: the requests of a client.
#include "fdm_server/participant/participant.hpp"
#include "tests/fuzz/session/script.hpp"
#include "tests/fuzz/session/serve.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kFdmSession(
    "fdm_session",
    [](std::string_view input) {
      fdm::FdmParticipant participant;
      serve(participant, frames_of(input));
    },
    kModelMemory);

}  // namespace
}  // namespace adit::fuzz
