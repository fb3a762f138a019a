#include "simplified/zoom/site.hpp"

#include <array>

#include "protocol/results/csv.hpp"
#include "simplified/scene/along_chainage.hpp"
#include "simplified/scene/ground.hpp"

namespace adit::simplified {
namespace {

using results::CsvFile;

std::vector<double> at(const GroundField& ground, const std::vector<double>& table, double chainage) {
  AlongChainage along(ground.chainage, {chainage});
  std::vector<double> values(table.size() / ground.chainage.size());
  for (std::size_t n = 0; n < values.size(); ++n)
    along.interpolate(table.data() + n * ground.chainage.size(), &values[n]);
  return values;
}

void write_profile(const std::filesystem::path& path, const scene::SoilProfile& profile) {
  const std::array<std::string, 5> columns = {"bottom_m", "shear_velocity_m_per_s", "density_kg_per_m3",
                                              "poisson_ratio", "damping_ratio"};
  CsvFile file(path, columns);
  double bottom = 0;
  for (const scene::Layer& layer : profile.layers())
    file.row(std::array{bottom += layer.thickness(), layer.shear_velocity(), layer.density(),
                        layer.poisson_ratio(), layer.damping_ratio()});
}

}  // namespace

SiteMotion site_motion(const GroundField& ground, double dt, double chainage) {
  const Shaking& lateral = ground.shaking[kLateral];
  if (lateral.rock.empty()) return {dt, {}, {}};
  return {dt, at(ground, lateral.rock, chainage), at(ground, lateral.velocity, chainage)};
}

void write_site(const std::filesystem::path& directory, const std::string& name, const scene::Ground& ground,
                const SiteMotion& motion, double chainage) {
  write_profile(directory / (name + "_profile.csv"), profile_at(ground, chainage));
  if (motion.base_acceleration.empty()) return;
  const std::array<std::string, 3> both = {"time_s", "base_acceleration_m_per_s2", "ground_velocity_m_per_s"};
  const std::array<std::string, 2> record = {"time_s", "acceleration_m/s^2"};
  CsvFile of_ground(directory / (name + "_ground.csv"), both),
      of_base(directory / (name + "_base.csv"), record);
  for (std::size_t n = 0; n < motion.base_acceleration.size(); ++n) {
    const double time = static_cast<double>(n) * motion.dt, acceleration = motion.base_acceleration[n];
    of_ground.row(std::array{time, acceleration, motion.tunnel_velocity[n]});
    of_base.row(std::array{time, acceleration});
  }
}

}  // namespace adit::simplified
