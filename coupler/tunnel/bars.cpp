#include "coupler/tunnel/bars.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "coupler/tunnel/joints.hpp"
#include "coupler/tunnel/parts.hpp"
#include "protocol/sections/bars_area.hpp"
#include "protocol/sections/read_section.hpp"

namespace adit::coupler {
namespace {

using geometry::Point;
using std::numbers::pi;

// The parts of a closed line from one corner to the next, each longer by `beyond` at both ends [m].
std::vector<scene::LinePath> between_corners(const scene::LinePath& line, double beyond) {
  constexpr double kCorner = 0.766;  // cosine of the turn
  std::vector<Point> points;
  for (const auto& place : line.points()) points.push_back({place.x(), place.y()});
  points.pop_back();  // the first one again
  const std::size_t count = points.size();
  const auto way = [&](std::size_t from) {
    const Point &a = points[from % count], &b = points[(from + 1) % count];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return Point{(b.x - a.x) / length, (b.y - a.y) / length};
  };
  std::vector<std::size_t> corners;
  for (std::size_t k = 0; k < count; ++k) {
    const Point before = way(k + count - 1), after = way(k);
    if (before.x * after.x + before.y * after.y < kCorner) corners.push_back(k);
  }
  std::vector<scene::LinePath> pieces;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t first = corners[i], last = i + 1 < corners.size() ? corners[i + 1] : corners[0] + count;
    scene::LinePath& piece = pieces.emplace_back();
    for (std::size_t k = first; k <= last; ++k) {
      Point place = points[k % count];
      if (k == first) place = {place.x - beyond * way(first).x, place.y - beyond * way(first).y};
      if (k == last) place = {place.x + beyond * way(last - 1).x, place.y + beyond * way(last - 1).y};
      *piece.add_points() = point(place);
    }
  }
  return pieces;
}

class Reinforcement {
 public:
  // `concrete`: its compressive strength [Pa].
  Reinforcement(const scene::LinedTunnel& tunnel, const Contour& contour, double concrete,
                scene::Particles& particles)
      : tunnel_(tunnel),
        section_(tunnel.lining().section()),
        contour_(contour),
        joints_(joint_angles(tunnel.lining())),
        concrete_(concrete),
        particles_(particles) {
    if (!joints_.empty()) joints_.push_back(joints_.front() + 2 * pi);
  }

  // Along the lining, `offset` outside its inner side. Those of the inner face run straight through a corner
  // to the cover of the other side: bent around it they would pull the concrete off.
  void add_along(const sections::BarLayer& layer, double offset) {
    if (!joints_.empty()) return add_in_segments(layer, offset);
    const scene::BarPath whole = contour_.around(offset);
    if (whole.has_circle() || layer.position > 0) {
      *add(layer.diameter, layer.area).mutable_along() = whole;
      return;
    }
    for (const auto& piece : between_corners(whole.line(), section_.thickness() - offset - section_.cover()))
      *add(layer.diameter, layer.area).mutable_along()->mutable_line() = piece;
  }

  // Between the covers, evenly spread over the lining or each segment, at most `spacing` apart at its inner
  // side.
  void add_stirrups(const scene::SectionStirrups& stirrups) {
    const double one = sections::bar_area(stirrups.diameter());
    const auto places = [&](double length) {
      return static_cast<int>(std::ceil(length / stirrups.spacing()));
    };
    const auto add_at = [&](const Contour::Cut& cut) {
      auto& line = *add(stirrups.diameter(), one / stirrups.spacing_across()).mutable_along()->mutable_line();
      *line.add_points() = point(cut.at(section_.cover()));
      *line.add_points() = point(cut.at(section_.thickness() - section_.cover()));
    };
    const int around = places(contour_.length());
    for (int k = 0; joints_.empty() && k < around; ++k) add_at(contour_.cut((k + 0.5) / around));
    for (std::size_t joint = 0; joint + 1 < joints_.size(); ++joint) {
      const double turn = joints_[joint + 1] - joints_[joint];
      const int within = places(turn / (2 * pi) * contour_.length());
      for (int k = 0; k < within; ++k)
        add_at(contour_.cut_at_angle(joints_[joint] + turn * (k + 0.5) / within));
    }
  }

 private:
  void add_in_segments(const sections::BarLayer& layer, double offset) {
    for (std::size_t k = 0; k + 1 < joints_.size(); ++k) {
      scene::BarPath path = contour_.around(offset);
      const double end = section_.cover() / path.circle().radius();
      path.mutable_circle()->set_from(joints_[k] + end);
      path.mutable_circle()->set_to(joints_[k + 1] - end);
      *add(layer.diameter, layer.area).mutable_along() = path;
    }
  }

  scene::ParticleBar& add(double diameter, double area) {
    scene::ParticleBar& bar = *particles_.add_bars();
    bar.set_diameter(diameter);
    bar.set_area(area);
    *bar.mutable_steel() = section_.steel();
    bar.set_concrete_strength(concrete_);
    if (section_.has_values()) bar.set_values(section_.values());
    bar.set_stage(stage_of_lining(tunnel_));
    return bar;
  }

  const scene::LinedTunnel& tunnel_;
  const scene::ReinforcedSection& section_;
  const Contour& contour_;
  std::vector<double> joints_;  // of segments, the first one again at the end [rad]
  const double concrete_;
  scene::Particles& particles_;
};

}  // namespace

void add_bars(const scene::LinedTunnel& tunnel, const Contour& contour, const std::string& path,
              scene::Particles& particles) {
  if (!tunnel.lining().has_section()) return;
  const scene::ReinforcedSection& section = tunnel.lining().section();
  const auto read = sections::read_section(section, 1, path + ".lining.section");
  Reinforcement reinforcement(tunnel, contour, read.concrete.compressive, particles);
  for (const sections::BarLayer& layer : read.shape.bars)
    reinforcement.add_along(layer, read.shape.thickness / 2 + layer.position);
  if (section.has_stirrups()) reinforcement.add_stirrups(section.stirrups());
}

}  // namespace adit::coupler
