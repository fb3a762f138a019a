#include "simplified/beam/model/tunnel.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"

namespace adit::simplified::beam {
namespace {

using protocol::require;

void positive(double value, const std::string& path, const char* unit) {
  require(value > 0 && std::isfinite(value), path, fmt::format("must be positive, got {:g} {}", value, unit));
}

void not_negative(double value, const std::string& path, const char* unit) {
  require(value >= 0 && std::isfinite(value), path,
          fmt::format("must not be negative, got {:g} {}", value, unit));
}

void check_section(const Section& section, const std::string& path) {
  require(section.to > section.from, path + ".to",
          fmt::format("the section ends at {:g} m, not after its start at {:g} m", section.to, section.from));
  positive(section.youngs_modulus, path + ".youngs_modulus", "Pa");
  positive(section.area, path + ".area", "m^2");
  positive(section.inertia_lateral, path + ".inertia_lateral", "m^4");
  positive(section.inertia_vertical, path + ".inertia_vertical", "m^4");
  positive(section.mass, path + ".mass", "kg/m");
  not_negative(section.shear_area_lateral, path + ".shear_area_lateral", "m^2");
  not_negative(section.shear_area_vertical, path + ".shear_area_vertical", "m^2");
  // The shear modulus is used with a shear area only, so it may stay 0 otherwise.
  if (section.shear_area_lateral > 0 || section.shear_area_vertical > 0)
    positive(section.shear_modulus, path + ".shear_modulus", "Pa");
  not_negative(section.half_width, path + ".half_width", "m");
  not_negative(section.half_height, path + ".half_height", "m");
  for (const double load : section.load)
    require(std::isfinite(load), path + ".load", "a load must be finite");
}

void check_sections(const std::vector<Section>& sections) {
  require(!sections.empty(), "sections", "the tunnel has no section: give at least one");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::string path = fmt::format("sections[{}]", i);
    check_section(sections[i], path);
    if (i == 0) continue;
    const double gap = sections[i].from - sections[i - 1].to;
    // A micrometre is far below a tolerance of construction and far above the rounding errors of a chainage.
    require(std::abs(gap) < 1e-6, path + ".from",
            fmt::format(
                "{} in chainage: section {} ends at {:g} m and section {} starts at {:g} m; each must start "
                "where the one before it ends",
                gap > 0 ? "gap" : "overlap", i - 1, sections[i - 1].to, i, sections[i].from));
  }
}

void check_spring(const SoilSpring& spring, const std::string& path) {
  not_negative(spring.stiffness, path + ".stiffness", "N/m^2");
  not_negative(spring.dashpot, path + ".dashpot", "N s/m^2");
  require(spring.slip_force > 0, path + ".slip_force",
          fmt::format("must be positive, got {:g} N/m", spring.slip_force));
  // At 1 nothing would be left that slips, which an infinite slip force says already.
  require(spring.hardening >= 0 && spring.hardening < 1, path + ".hardening",
          fmt::format("must be in [0, 1), got {:g}", spring.hardening));
}

void check_soil(const Tunnel& tunnel) {
  const auto& soil = tunnel.soil;
  const double start = tunnel.sections.front().from, end = tunnel.sections.back().to;
  require(!soil.empty(), "soil", "the tunnel has no soil springs: give stations from portal to portal");
  for (std::size_t i = 0; i < soil.size(); ++i) {
    const std::string path = fmt::format("soil[{}]", i);
    for (int d = 0; d < 3; ++d) check_spring(soil[i].springs[d], fmt::format("{}.springs[{}]", path, d));
    require(soil[i].liquefied > 0 && soil[i].liquefied <= 1, path + ".liquefied",
            fmt::format("must be above 0 and at most 1, got {:g}", soil[i].liquefied));
    require(std::isfinite(soil[i].uplift), path + ".uplift", "a load must be finite");
    if (i > 0)
      require(soil[i].chainage >= soil[i - 1].chainage, path + ".chainage",
              fmt::format("stations must be in order: {:g} m follows {:g} m", soil[i].chainage,
                          soil[i - 1].chainage));
  }
  require(soil.front().chainage <= start + 1e-6 && soil.back().chainage >= end - 1e-6, "soil",
          fmt::format("gap in chainage: the soil is given from {:g} m to {:g} m and the tunnel runs from "
                      "{:g} m to {:g} m",
                      soil.front().chainage, soil.back().chainage, start, end));
}

void check_joint(const Joint& joint, const std::string& path) {
  not_negative(joint.hydrostatic_force, path + ".hydrostatic_force", "N");
  // Without gaskets no compression balances the water, and the search for it would never end.
  require(joint.hydrostatic_force == 0 || !joint.gaskets.empty(), path + ".hydrostatic_force",
          "no gasket to carry it: give gaskets or set it to 0");
  require(joint.omega_limit > 0, path + ".omega_limit", "must be positive");
  for (std::size_t i = 0; i < joint.gaskets.size(); ++i) {
    const std::string here = fmt::format("{}.gaskets[{}]", path, i);
    positive(joint.gaskets[i].length, here + ".length", "m");
    check_load_curve(joint.gaskets[i].compression, here + ".compression");
  }
  for (std::size_t i = 0; i < joint.springs.size(); ++i)
    check(joint.springs[i].curve, fmt::format("{}.springs[{}].curve", path, i));
  if (!joint.lateral.points.empty()) check(joint.lateral, path + ".lateral");
  if (!joint.vertical.points.empty()) check(joint.vertical, path + ".vertical");
}

}  // namespace

std::vector<Joint::Gasket> rectangular_gasket(double width, double height, int per_side,
                                              const std::vector<CurvePoint>& compression) {
  std::vector<Joint::Gasket> gaskets;
  for (int i = 0; i < per_side; ++i) {
    const double along = (i + 0.5) / per_side - 0.5;
    for (const double side : {-0.5, 0.5}) {
      gaskets.push_back({along * width, side * height, width / per_side, compression});
      gaskets.push_back({side * width, along * height, height / per_side, compression});
    }
  }
  return gaskets;
}

void check(const Tunnel& tunnel) {
  check_sections(tunnel.sections);
  check_soil(tunnel);
  positive(tunnel.element_length, "element_length", "m");
  const double start = tunnel.sections.front().from, end = tunnel.sections.back().to;
  double previous = start;
  for (std::size_t i = 0; i < tunnel.joints.size(); ++i) {
    const std::string path = fmt::format("joints[{}]", i);
    const double x = tunnel.joints[i].chainage;
    require(x > previous + 1e-6 && x < end - 1e-6, path + ".chainage",
            fmt::format("joints must be in order and inside the tunnel, between {:g} m and {:g} m; got {:g} "
                        "m after {:g} m",
                        start, end, x, previous));
    check_joint(tunnel.joints[i], path);
    previous = x;
  }
}

}  // namespace adit::simplified::beam
