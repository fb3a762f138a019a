#include "simplified/zoom/write.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "protocol/results/csv.hpp"
#include "protocol/scene/writer.hpp"
#include "simplified/zoom/places.hpp"
#include "simplified/zoom/site.hpp"
#include "simplified/zoom/window.hpp"

namespace adit::simplified {
namespace {

void write_motions(const std::filesystem::path& path, const Window& window) {
  const std::array<std::string, 5> columns = {"time_s", "begin_vx_m_per_s", "begin_vy_m_per_s",
                                              "end_vx_m_per_s", "end_vy_m_per_s"};
  results::CsvFile file(path, columns);
  for (std::size_t n = 0; n < window.time.size(); ++n)
    file.row(std::array{window.time[n], window.begin_axial[n], window.begin_lateral[n], window.end_axial[n],
                        window.end_lateral[n]});
}

void write_fragment(const std::filesystem::path& path, const Place& place, const Window& window,
                    double duration) {
  std::ofstream file(path);
  file << fmt::format(
              "# The tunnel from {} to {} m, around the largest {} of the run, {:.4g} {} at {:g} m: the "
              "motion of "
              "both edges, which do not turn.\n"
              "# Not yet a scene: write one with `extends: <this file>`, a material, and models over these "
              "chainages.\n",
              window.begin, window.end, place.name, place.value, place.unit, place.chainage)
       << protocol::to_yaml(fragment(window, duration));
}

}  // namespace

void write_zoom(const std::filesystem::path& directory, const Setup& setup, const GroundField& ground,
                const Response& response, double duration) {
  std::filesystem::create_directories(directory);
  for (const Place& place : largest_responses(response)) {
    const Window around = window(response.fields, place.chainage, setup.scene->zoom().width());
    write_motions(directory / (place.name + ".csv"), around);
    write_fragment(directory / (place.name + ".yaml"), place, around, duration);
    if (setup.scene->has_ground())
      write_site(directory, place.name, setup.scene->ground(),
                 site_motion(ground, setup.clock.dt, place.chainage), place.chainage);
  }
}

}  // namespace adit::simplified
