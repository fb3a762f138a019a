// Particles as points of a VTP file.
#include <stdexcept>

#include "dem_server/model/placement/placed_table.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kParticlesVtp("particles_vtp", [](std::string_view input) {
  read_or_refuse([&] {
    const auto placed = dem::read_vtp(std::string(input), "particles.placed.path");
    if (!placed.number.empty() && placed.number.size() != placed.discs.size())
      throw std::logic_error("not every particle has the number of a group");
  });
});

}  // namespace
}  // namespace adit::fuzz
