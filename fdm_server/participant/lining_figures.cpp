#include "fdm_server/participant/lining_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "fdm_server/participant/figures.hpp"

namespace adit::fdm {
namespace {

using Instant = PeakForces::Instant;

struct Place {
  Instant instant;
  std::uint32_t point;
};

// The peaks of one lining, whose nodes begin at this row.
class LiningPeaks {
 public:
  LiningPeaks(const Lining& lining, std::size_t first) : points_(lining.path.points), first_(first) {}

  Place largest(const PeakForces::Extremes& of, double Instant::*force) const {
    const auto rows = std::span(of.largest).subspan(first_, points_.size());
    return at(rows, std::ranges::max_element(rows, {}, force));
  }
  Place least(const PeakForces::Extremes& of, double Instant::*force) const {
    const auto rows = std::span(of.least).subspan(first_, points_.size());
    return at(rows, std::ranges::min_element(rows, {}, force));
  }

 private:
  template <class Rows, class Row>
  Place at(const Rows& rows, Row row) const {
    return {*row, points_[static_cast<std::size_t>(row - rows.begin())]};
  }

  std::span<const std::uint32_t> points_;
  std::size_t first_;
};

// The peaks of a lining with a section, whose nodes begin at this row; `name`: what its figures begin with.
void add_use(const std::string& name, const Lining& lining, const PeakUse::Extremes& largest,
             std::size_t first, Figures& figures) {
  // Adds one of them with time and place; what there was then.
  const auto add_largest = [&](const std::vector<PeakUse::Instant>& of, double SectionUse::*member,
                               const std::string& which, const std::string& unit) {
    const auto rows = std::span(of).subspan(first, lining.path.points.size());
    const auto at = std::ranges::max_element(
        rows, {}, [member](const PeakUse::Instant& instant) { return std::abs(instant.use.*member); });
    const auto point = lining.path.points[static_cast<std::size_t>(at - rows.begin())];
    figures.add(name + which + unit, at->use.*member);
    figures.add_when_and_where(name + which, at->time, point);
    return at->use;
  };
  const LiningForces bent =
      add_largest(largest.utilisation, &SectionUse::utilisation, "largest_utilisation", "").forces;
  figures.add(name + "thrust_at_largest_utilisation_N", bent.thrust);
  figures.add(name + "moment_at_largest_utilisation_Nm", bent.moment);
  const LiningForces sheared =
      add_largest(largest.shear, &SectionUse::shear, "largest_shear_utilisation", "").forces;
  figures.add(name + "shear_at_largest_shear_utilisation_N", sheared.shear);
  figures.add(name + "thrust_at_largest_shear_utilisation_N", sheared.thrust);
  const double ratio =
      add_largest(largest.moment_ratio, &SectionUse::moment_ratio, "largest_moment_ratio", "").moment_ratio;
  figures.add(name + "damage_state",
              static_cast<double>(sections::damage_state(lining.section->strength, ratio)));
  if (lining.section->elastic) return;
  add_largest(largest.curvature, &SectionUse::curvature, "largest_curvature", "_per_m");
  add_largest(largest.steel_strain, &SectionUse::steel_strain, "largest_steel_strain", "");
  add_largest(largest.crack_width, &SectionUse::crack_width, "largest_crack_width", "_m");
  add_largest(largest.hinge_rotation, &SectionUse::hinge_rotation, "largest_hinge_rotation", "_rad");
}

}  // namespace

void add_figures(const Grid& grid, const std::string& kind, std::span<const Lining> chains,
                 const PeakForces& peaks, const PeakUse& use, wire::Bye& bye) {
  if (peaks.empty()) return;
  Figures figures(grid, bye);
  std::size_t row = 0;
  for (const Lining& lining : chains) {
    const std::string name = fmt::format("{}_{}_", kind, lining.name);
    const LiningPeaks of_lining(lining, row);
    if (lining.section) add_use(name, lining, use.largest(), row, figures);
    row += lining.path.points.size();
    const auto add_thrust = [&](const std::string& which, const Place& place) {
      figures.add(name + which + "_N", place.instant.thrust);
      figures.add_when_and_where(name + which, place.instant.time, place.point);
      figures.add(name + "moment_at_" + which + "_Nm", place.instant.moment);
    };
    add_thrust("largest_thrust", of_lining.largest(peaks.thrust(), &Instant::thrust));
    add_thrust("least_thrust", of_lining.least(peaks.thrust(), &Instant::thrust));
    const Place most = of_lining.largest(peaks.moment(), &Instant::moment),
                least = of_lining.least(peaks.moment(), &Instant::moment);
    const Place& bent = -least.instant.moment > most.instant.moment ? least : most;
    figures.add(name + "largest_moment_Nm", bent.instant.moment);
    figures.add_when_and_where(name + "largest_moment", bent.instant.time, bent.point);
    figures.add(name + "thrust_at_largest_moment_N", bent.instant.thrust);
  }
}

void add_figures(std::span<const Lining> linings, const PeakShapes& shapes, wire::Bye& bye) {
  for (std::size_t i = 0; i < linings.size(); ++i) {
    const auto peak = shapes.of(i);
    if (!peak) continue;
    const std::string name =
        fmt::format("lining_{}_largest_{}", linings[i].name, shapes.ovals(i) ? "ovaling" : "racking");
    add_figure(name + "_m", peak->size, bye);
    add_figure(name + "_time_s", peak->time, bye);
    if (shapes.ovals(i)) add_figure(name + "_angle_rad", peak->angle, bye);
  }
}

void add_failures(const Grid& grid, std::span<const Lining> members, const Structures& structures,
                  wire::Bye& bye) {
  Figures figures(grid, bye);
  for (const Lining& member : members) {
    if (!member.member) continue;
    const std::string name = "member_" + member.name + "_";
    const auto [shear, axial, crushed] = structures.members()[*member.member].failed();
    double first = -1;
    for (const auto& [which, time] :
         {std::pair{"shear_failed", shear}, {"axial_failed", axial}, {"crushed", crushed}}) {
      if (time < 0) continue;
      figures.add(name + which + "_time_s", time);
      if (first < 0 || time < first) first = time;
    }
    if (first >= 0) figures.add(name + "failed_time_s", first);
  }
}

}  // namespace adit::fdm
