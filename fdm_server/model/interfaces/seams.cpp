#include "fdm_server/model/interfaces/seams.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "fdm_server/model/interfaces/law.hpp"

namespace adit::fdm {
namespace {

constexpr double kStiffer = 10;  // than the zones beside, so that the faces do not soften the ground

double dot(const Contacts::Half& a, const Contacts::Half& b) {
  return (a.nx * b.nx + a.ny * b.ny) / (std::hypot(a.nx, a.ny) * std::hypot(b.nx, b.ny));
}

}  // namespace

Seams::Seams(std::span<const Seam> seams, const std::vector<bool>& kept, const Ground& ground,
             std::span<const double> weights, Grid& grid)
    : ground_(ground), weights_(weights), grid_(grid) {
  std::vector<Side> cuts;
  std::set<std::pair<std::uint32_t, std::uint32_t>> wanted;
  for (const auto& [path, cuts_here] : seams)
    for (std::size_t k = 0; k < path.sides(); ++k) {
      const auto [a, b] = path.side(k);
      wanted.insert({{a, b}, {b, a}});
      if (cuts_here) cuts.push_back({a, b});
    }
  if (wanted.empty()) return;
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
    for (std::size_t c = 0; c < 4; ++c) {
      const std::pair<std::uint32_t, std::uint32_t> directed(grid.zones[z][c], grid.zones[z][(c + 1) % 4]);
      if (wanted.contains(directed)) on_left_[directed] = z;
    }
  cut(grid, cuts, kept);
}

std::array<std::uint32_t, 2> Seams::beside(const Path& path, std::size_t k) const {
  const auto [a, b] = path.side(k);
  const auto zone = [this](std::uint32_t from, std::uint32_t to) {
    const auto found = on_left_.find({from, to});
    return found == on_left_.end() ? kNoZone : found->second;
  };
  return {zone(a, b), zone(b, a)};
}

std::uint32_t Seams::copy(std::uint32_t point, std::uint32_t zone) const {
  for (const auto corner : grid_.zones[zone])
    if (grid_.place(static_cast<std::uint32_t>(corner)) == point) return static_cast<std::uint32_t>(corner);
  return point;
}

double Seams::stiffness_of(std::uint32_t zone, double side) const {
  const PlaneLaw law = ground_.plane_law(zone);
  return (law.bulk + law.shear) / (area(corners(grid_, zone)) / side);
}

Seams::End Seams::end(const Path& path, std::size_t k, const std::array<std::uint32_t, 2>& points,
                      const std::array<std::uint32_t, 2>& zones, double sense) const {
  const auto [a, b] = path.side(k);
  const double w = zones[0] == kNoZone ? weight(zones[1]) : (weight(zones[0]) + weight(zones[1])) / 2;
  const double dx = grid_.x[b] - grid_.x[a], dy = grid_.y[b] - grid_.y[a], half = sense * w / 2;
  return {points, {zones[0], zones[1], -half * dy, half * dx, std::hypot(dx, dy)}};
}

std::vector<Side> Seams::face(const Path& path, std::size_t on) const {
  std::vector<Side> sides;
  for (std::size_t k = 0; k < path.sides(); ++k) {
    const auto zone = beside(path, k)[on];
    if (zone == kNoZone) continue;
    const auto [a, b] = path.side(k);
    sides.push_back({copy(a, zone), copy(b, zone)});
  }
  return sides;
}

Interface Seams::join(const Path& path, const ContactLaw& law, bool large_strain, Contacts& contacts) const {
  std::vector<End> ends;
  for (std::size_t k = 0; k < path.sides(); ++k) {
    const auto [left, right] = beside(path, k);
    if (left == kNoZone || right == kNoZone) continue;
    for (const auto point : path.side(k))
      ends.push_back(end(path, k, {copy(point, left), copy(point, right)}, {left, right}, 1));
  }
  const Interface joined = add(std::move(ends), path.closed, law, 0, contacts);
  if (large_strain && joined.count > 0) {
    auto left = face(path, 0), right = face(path, 1);
    const bool of_left = left.size() <= right.size();
    contacts.slide(joined.first, joined.count, of_left,
                   Face(of_left ? std::move(right) : std::move(left), kCorner), grid_.x, grid_.y);
  }
  return joined;
}

Interface Seams::join(const Path& path, std::span<const std::uint32_t> own, const ContactLaw& law,
                      double share, std::uint32_t stage, Contacts& contacts) const {
  Interface joined{{}, 0, 0, path.closed};
  for (const std::size_t on : {0, 1}) {
    std::vector<End> ends;
    for (std::size_t k = 0; k < path.sides(); ++k) {
      const auto zone = beside(path, k)[on];
      if (zone == kNoZone) continue;
      for (const std::size_t node : {k, (k + 1) % path.points.size()})
        ends.push_back(end(path, k, {own[node], copy(path.points[node], zone)}, {kNoZone, zone},
                           on == 0 ? -share : share));
    }
    const Interface one = add(std::move(ends), path.closed, law, stage, contacts);
    if (joined.count == 0) joined.first = one.first;
    joined.count += one.count;
  }
  return joined;
}

Interface Seams::join(const Path& path, std::span<const std::uint32_t> below,
                      std::span<const std::uint32_t> layer, const ContactLaw& law, std::uint32_t stage,
                      Contacts& contacts) const {
  std::vector<End> ends;
  double stiffness = 0;
  for (std::size_t k = 0; k < path.sides(); ++k) {
    End between = end(path, k, {}, {kNoZone, kNoZone}, 1);
    for (const auto zone : beside(path, k))
      if (zone != kNoZone) stiffness = std::max(stiffness, kStiffer * stiffness_of(zone, between.half.side));
    for (const std::size_t node : {k, (k + 1) % path.points.size()}) {
      between.points = {layer[node], below[node]};
      ends.push_back(between);
    }
  }
  return add(std::move(ends), path.closed, with_stiffness(law, stiffness), stage, contacts);
}

// Ends at one place that join the same points make one contact, unless the path has a corner there.
Interface Seams::add(std::vector<End> ends, bool closed, const ContactLaw& law, std::uint32_t stage,
                     Contacts& contacts) const {
  const auto belong = [](const End& a, const End& b) {
    return a.points == b.points && dot(a.half, b.half) > kCorner;
  };
  std::erase_if(ends, [](const End& end) { return end.points[0] == end.points[1]; });
  if (closed && ends.size() > 2 && belong(ends.front(), ends.back()))
    std::rotate(ends.begin(), ends.end() - 1, ends.end());
  Interface joined{{}, 0, 0, closed};
  for (std::size_t i = 0; i < ends.size();) {
    const std::size_t next = i + 1 < ends.size() && belong(ends[i], ends[i + 1]) ? i + 2 : i + 1;
    std::vector<Contacts::Half> halves;
    double stiffness = 0;
    for (; i < next; ++i) {
      const auto& half = halves.emplace_back(ends[i].half);
      for (const auto zone : {half.first_zone, half.second_zone})
        if (zone != kNoZone) stiffness = std::max(stiffness, stiffness_of(zone, half.side));
    }
    const auto number =
        contacts.add(ends[i - 1].points, halves, with_stiffness(law, kStiffer * stiffness), stage);
    if (joined.count++ == 0) joined.first = number;
  }
  return joined;
}

}  // namespace adit::fdm
