// A grid from Gmsh, and the checks that every grid meets.
#include "fdm_server/meshing/gmsh.hpp"
#include "fdm_server/grid/checks.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

constexpr std::size_t kMostPoints = 10'000;

const Target kGmsh("gmsh", [](std::string_view input) {
  read_or_refuse([&] {
    const auto mesh = fdm::read_gmsh(input, "x.msh", "continuum.mesh.path", kMostPoints);
    fdm::require_sound(mesh.grid, "continuum.mesh.path",
                       [](std::uint32_t zone) { return std::to_string(zone); });
  });
});

}  // namespace
}  // namespace adit::fuzz
