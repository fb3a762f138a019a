#include "simplified/output/results.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "protocol/results/csv.hpp"
#include "simplified/scene/ground.hpp"
#include "simplified/scene/tunnel.hpp"

namespace adit::simplified {
namespace {

using results::CsvFile;

void write_histories(const std::filesystem::path& path, const Table& table) {
  CsvFile file(path, table.columns);
  for (const auto& row : table.rows) file.row(row);
}

void write_envelopes(const std::filesystem::path& path, const Response& response) {
  std::vector<std::string> columns = {"chainage_m"};
  for (const Envelope& envelope : response.envelopes) {
    const std::string unit = envelope.unit.empty() ? "" : "_" + envelope.unit;
    columns.push_back(envelope.name + "_min" + unit);
    columns.push_back(envelope.name + "_max" + unit);
  }
  CsvFile file(path, columns);
  for (std::size_t i = 0; i < response.chainage.size(); ++i) {
    file.cell(response.chainage[i]);
    for (const Envelope& envelope : response.envelopes)
      file.cell(envelope.least[i]).cell(envelope.greatest[i]);
    file.end_row();
  }
}

void write_joints(const std::filesystem::path& path, const scene::Tunnel& tunnel, const Response& response) {
  const std::array<std::string, 5> columns = {"chainage_m", "group", "opening_max_m", "compression_max_m",
                                              "offset_max_m"};
  CsvFile file(path, columns);
  for (const JointResponse& joint : response.joints) {
    file.cell(joint.chainage).cell(tunnel.joints(static_cast<int>(joint.group)).name());
    file.cell(joint.opening).cell(joint.compression).cell(joint.offset).end_row();
  }
}

// Bottoms and wave velocities of the layers, at as many places as a picture can show.
void write_soil_profile(const std::filesystem::path& path, const scene::Simplified& scene, double begin,
                        double end) {
  constexpr int kPlaces = 200;
  // All profiles have the same number of layers (check in ground.hpp).
  const int layers = scene.ground().profiles(0).layers_size();
  std::vector<std::string> columns = {"chainage_m", "axis_depth_m"};
  for (int i = 1; i <= layers; ++i) columns.push_back("layer_" + std::to_string(i) + "_bottom_m");
  for (int i = 1; i <= layers; ++i)
    columns.push_back("layer_" + std::to_string(i) + "_shear_velocity_m_per_s");
  CsvFile file(path, columns);
  for (int i = 0; i <= kPlaces; ++i) {
    const double chainage = begin + (end - begin) * i / kPlaces;
    const scene::SoilProfile profile = profile_at(scene.ground(), chainage);
    file.cell(chainage).cell(axis_depth(scene.tunnel(), chainage));
    double bottom = 0;
    for (const scene::Layer& layer : profile.layers()) file.cell(bottom += layer.thickness());
    for (const scene::Layer& layer : profile.layers()) file.cell(layer.shear_velocity());
    file.end_row();
  }
}

// The fields, thinned to as many places and times as a picture can show.
void write_time_distance(const std::filesystem::path& path, const Fields& fields) {
  constexpr std::size_t kPlaces = 200, kTimes = 400;
  const std::array<std::string, 5> columns = {"time_s", "chainage_m", "axial_velocity_m_per_s",
                                              "lateral_velocity_m_per_s", "axial_force_N"};
  const std::size_t places = fields.chainage.size();
  const std::size_t every_place = (places + kPlaces - 1) / kPlaces;
  const std::size_t every_time = (fields.time.size() + kTimes - 1) / kTimes;
  CsvFile file(path, columns);
  for (std::size_t n = 0; n < fields.time.size(); n += every_time)
    for (std::size_t i = 0; i < places; i += every_place) {
      const std::size_t at = n * places + i;
      file.row(std::array{fields.time[n], fields.chainage[i], fields.axial_velocity[at],
                          fields.lateral_velocity[at], fields.axial_force[at]});
    }
}

}  // namespace

void write_tables(const std::filesystem::path& directory, const scene::Simplified& scene,
                  const Response& response) {
  write_histories(directory / "histories.csv", response.histories);
  write_envelopes(directory / "envelopes.csv", response);
  if (!response.joints.empty()) write_joints(directory / "joints.csv", scene.tunnel(), response);
  if (scene.has_ground())
    write_soil_profile(directory / "soil_profile.csv", scene, response.chainage.front(),
                       response.chainage.back());
  if (!response.fields.time.empty()) write_time_distance(directory / "time_distance.csv", response.fields);
}

void write_motion(const std::filesystem::path& directory, const motion::Motion& motion) {
  const std::array<std::string, 2> columns = {"time_s", "acceleration_m_per_s2"};
  CsvFile file(directory / "motion.csv", columns);
  for (std::size_t n = 0; n < motion.acceleration.size(); ++n)
    file.row(std::array{static_cast<double>(n) * motion.dt, motion.acceleration[n]});
}

}  // namespace adit::simplified
