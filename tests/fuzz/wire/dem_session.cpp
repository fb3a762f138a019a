// A session of dem_server: the requests of a client.
#include "dem_server/participant/participant.hpp"
#include "tests/fuzz/session/script.hpp"
#include "tests/fuzz/session/serve.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kDemSession(
    "dem_session",
    [](std::string_view input) {
      dem::DemParticipant participant;
      serve(participant, frames_of(input));
    },
    kModelMemory);

}  // namespace
}  // namespace adit::fuzz
