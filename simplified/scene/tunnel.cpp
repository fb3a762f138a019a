#include "simplified/scene/tunnel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "simplified/scene/along_chainage.hpp"

namespace adit::simplified {
namespace {

using protocol::UserError;

// Places closer together than this count as one [m].
constexpr double kSamePlace = 1e-6;

// The longest tunnel has fewer rings; a scene with more pieces has an error in a unit.
constexpr double kMostPieces = 1e6;

void check_sections(const scene::Tunnel& tunnel) {
  for (int i = 0; i < tunnel.sections_size(); ++i) {
    const auto& section = tunnel.sections(i);
    const std::string path = fmt::format("simplified.tunnel.sections[{}]", i);
    if ((section.to() - section.from()) / section.element_length() > kMostPieces)
      throw UserError(path + ".element_length", fmt::format("is {:g} m, which makes more than {:g} pieces",
                                                            section.element_length(), kMostPieces));
    if (i == 0) continue;
    const double step = section.from() - tunnel.sections(i - 1).to();
    if (std::abs(step) > kSamePlace)
      throw UserError(
          path + ".from",
          fmt::format("is {:g} m, but the section before it ends at {:g} m: {} of {:g} m in the chainage; "
                      "let each section begin where the one before it ends",
                      section.from(), tunnel.sections(i - 1).to(), step > 0 ? "a gap" : "an overlap",
                      std::abs(step)));
  }
}

std::vector<double> places(const scene::Joints& group, const std::string& path) {
  std::vector<double> at(group.at().begin(), group.at().end());
  if (group.has_from() || group.has_to() || group.has_spacing()) {
    if (!group.has_from() || !group.has_to() || !group.has_spacing())
      throw UserError(path, "has only some of `from`, `to` and `spacing`; give all three, or `at` alone");
    const double count = (group.to() - group.from()) / group.spacing();
    if (!(count >= 0 && count <= kMostPieces))
      throw UserError(path + ".to",
                      fmt::format("is {:g} m, which makes no sensible number of joints from {:g} m "
                                  "every {:g} m",
                                  group.to(), group.from(), group.spacing()));
    // The last joint may miss `to` by a rounding error and still counts.
    for (int i = 0; i <= static_cast<int>(count + kSamePlace); ++i)
      at.push_back(group.from() + i * group.spacing());
  }
  if (at.empty()) throw UserError(path, "gives no place; give `from`, `to` and `spacing`, or `at`");
  return at;
}

std::vector<PlacedJoint> place_joints(const scene::Tunnel& tunnel, double begin, double end) {
  std::vector<PlacedJoint> joints;
  for (int g = 0; g < tunnel.joints_size(); ++g) {
    const std::string path = fmt::format("simplified.tunnel.joints[{}]", g);
    for (const double x : places(tunnel.joints(g), path)) {
      if (!(x > begin + kSamePlace && x < end - kSamePlace))
        throw UserError(
            path, fmt::format("puts a joint at {:g} m, which is not inside the tunnel from {:g} to {:g} m", x,
                              begin, end));
      joints.push_back({x, static_cast<std::size_t>(g)});
    }
  }
  // The first group that has a joint at a place keeps it; the stable sort leaves that group in front.
  std::stable_sort(joints.begin(), joints.end(), [](const PlacedJoint& a, const PlacedJoint& b) {
    return a.chainage < b.chainage - kSamePlace;
  });
  joints.erase(std::unique(joints.begin(), joints.end(),
                           [](const PlacedJoint& a, const PlacedJoint& b) {
                             return std::abs(a.chainage - b.chainage) <= kSamePlace;
                           }),
               joints.end());
  return joints;
}

}  // namespace

Line divide(const scene::Tunnel& tunnel) {
  check_sections(tunnel);
  const double begin = tunnel.sections(0).from(), end = tunnel.sections(tunnel.sections_size() - 1).to();
  Line line;
  line.joints = place_joints(tunnel, begin, end);
  line.nodes.push_back(begin);
  auto joint = line.joints.begin();
  for (int s = 0; s < tunnel.sections_size(); ++s) {
    const auto& section = tunnel.sections(s);
    // Pieces are cut up to the next joint or to the end of the section.
    while (line.nodes.back() < section.to() - kSamePlace) {
      const double from = line.nodes.back();
      // A joint at the end of a section cuts there, so that the section's end is not cut again beside it.
      const bool joint_first = joint != line.joints.end() && joint->chainage < section.to() + kSamePlace;
      const double stop = joint_first ? joint->chainage : section.to();
      const int pieces =
          std::max(1, static_cast<int>(std::ceil((stop - from) / section.element_length() - kSamePlace)));
      for (int i = 1; i <= pieces; ++i) {
        // The last node is the given place itself, without the rounding error of the division.
        line.nodes.push_back(i < pieces ? from + (stop - from) * i / pieces : stop);
        line.section.push_back(static_cast<std::size_t>(s));
      }
      if (joint_first) {
        line.joint_node.push_back(line.nodes.size() - 1);
        ++joint;
      }
    }
  }
  return line;
}

double axis_depth(const scene::Tunnel& tunnel, double chainage) {
  if (tunnel.axis().empty()) return 0;
  const Bracket at = bracket(tunnel.axis(), chainage);
  return at.blend(tunnel.axis(at.before).depth(), tunnel.axis(at.after).depth());
}

const scene::Section& section_at(const scene::Tunnel& tunnel, double chainage) {
  int s = 0;
  while (s + 1 < tunnel.sections_size() && tunnel.sections(s).to() < chainage) ++s;
  return tunnel.sections(s);
}

Heights heights(const scene::Tunnel& tunnel, double chainage, const scene::Section& section) {
  const double depth = axis_depth(tunnel, chainage), half = section.height() / 2;
  return {std::max(0.0, depth - half), depth + half};
}

}  // namespace adit::simplified
