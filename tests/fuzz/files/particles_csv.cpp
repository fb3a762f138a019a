// Particles as a table.
#include "dem_server/model/placement/placed_table.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kParticlesCsv("particles_csv", [](std::string_view input) {
  read_or_refuse([&] { dem::read_csv(std::string(input), "particles.placed.path"); });
});

}  // namespace
}  // namespace adit::fuzz
