#include "coupler/output/capacities.hpp"

#include <string>
#include <vector>

#include "protocol/results/csv.hpp"
#include "protocol/sections/read_section.hpp"

namespace adit::coupler {
namespace {

struct Resisting {
  const char* kind;
  const std::string& name;
  const scene::ReinforcedSection& section;
  double width;  // [m]
};

std::vector<Resisting> resisting(const scene::Scene& scene) {
  std::vector<Resisting> found;
  const auto add = [&](const char* kind, const auto& all, const auto& width) {
    for (const auto& one : all)
      if (one.has_section()) found.push_back({kind, one.name(), one.section(), width(one)});
  };
  const auto metre = [](const auto&) { return 1.0; };
  add("lining", scene.continuum().linings(), metre);
  add("member", scene.continuum().members(),
      [](const scene::Member& member) { return member.has_width() ? member.width() : member.spacing(); });
  add("section", scene.continuum().sections(), metre);
  add("section", scene.particles().sections(), metre);
  for (const auto& region : scene.regions()) add("section", region.particles().sections(), metre);
  return found;
}

}  // namespace

void write_capacities(const scene::Scene& scene, const std::filesystem::path& path) {
  const std::vector<Resisting> all = resisting(scene);
  if (all.empty()) return;
  const std::vector<std::string> columns{"kind", "name", "thrust_N", "moment_Nm"};
  results::CsvFile file(path, columns);
  for (const auto& [kind, name, section, width] : all) {
    const sections::Strength strength = sections::strength_of(sections::read_section(section, width, name));
    for (const auto& [thrust, moment] : strength.capacity.diagram()) {
      file.cell(kind).cell(name).cell(thrust).cell(moment);
      file.end_row();
    }
  }
}

}  // namespace adit::coupler
