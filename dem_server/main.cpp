// Bonded particles on a socket: dem_server --help
#include <memory>

#include "dem_server/participant/participant.hpp"
#include "protocol/server/server.hpp"

int main(int argc, char** argv) {
  std::size_t threads = 0;
  return adit::protocol::server_main(
      argc, argv, "dem_server",
      {"name", "description", "plane", "material", "time", "initial_stress", "statics", "water", "particles"},
      [&] { return std::make_unique<adit::dem::DemParticipant>(threads); }, &threads);
}
