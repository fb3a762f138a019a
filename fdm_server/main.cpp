// fdm_server: computes the continuum of a run for the coupler.
#include <memory>

#include "fdm_server/participant/participant.hpp"
#include "protocol/server/server.hpp"

int main(int argc, char** argv) {
  std::size_t threads = 0;
  return adit::protocol::server_main(
      argc, argv, "fdm_server",
      {"name", "description", "plane", "material", "time", "initial_stress", "statics", "continuum", "water"},
      [&] { return std::make_unique<adit::fdm::FdmParticipant>(threads); }, &threads);
}
