#include "fdm_server/model/supports/rings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdm_server/model/supports/place_on_path.hpp"
#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"

namespace adit::fdm {
namespace {

using protocol::require;

// Both rings bear on the ground, by themselves.
void require_ring(const scene::Lining& ring, const SceneLinings& linings, const std::string& path) {
  require(ring.has_interface(), path,
          "joins rings of which `" + ring.name() +
              "` is tied to the ground, so that they cannot move apart; give both an `interface`");
  require(
      !ring.has_on(), path,
      "joins rings of which `" + ring.name() + "` lies on `" + ring.on() + "`; let both lie on the ground");
  for (const auto& layer : linings)
    require(!layer.has_on() || layer.on() != ring.name(), path,
            "joins rings on one of which, `" + ring.name() + "`, lies `" + layer.name() +
                "`; leave that out, or the second ring");
}

std::vector<RingDowel> read_dowels(const scene::RingBeside& beside, const scene::LiningPath& along,
                                   const Path& nodes, const Grid& grid, const std::string& path) {
  std::vector<RingDowel> dowels;
  for (int i = 0; i < beside.dowels_size(); ++i) {
    const auto& dowel = beside.dowels(i);
    const auto here = fmt::format("{}.dowels[{}]", path, i);
    const auto node = nearest_node(place_of(dowel, along, here), nodes, grid, here);
    for (std::size_t other = 0; other < dowels.size(); ++other)
      require(dowels[other].node != node, here,
              fmt::format("lies at the same node as dowels[{}]; leave one out, or use shorter zones", other));
    dowels.push_back({node, dowel.stiffness(), dowel.strength()});
  }
  return dowels;
}

}  // namespace

Rings::Rings(const SceneLinings& linings) : beside_(static_cast<std::size_t>(linings.size()), -1) {
  std::vector<std::string> names;
  for (const auto& lining : linings) names.push_back(lining.name());
  for (int i = 0; i < linings.size(); ++i) {
    const auto& ring = linings[i];
    if (!ring.has_beside()) continue;
    const auto path = fmt::format("continuum.linings[{}].beside", i);
    const std::string& name = ring.beside().lining();
    const auto found = std::ranges::find(names, name);
    const auto number = static_cast<int>(found - names.begin());
    require(found != names.end() && number != i, path + ".lining",
            fmt::format("is `{}`, which is no other lining{}; name the ring that this one lies beside", name,
                        protocol::did_you_mean(name, names)));
    const auto& first = linings[number];
    require(!first.has_beside() && std::ranges::find(beside_, number) == beside_.end(), path + ".lining",
            "is `" + name + "`, which is beside another ring already; two kinds of rings follow in turn");
    for (const auto* one : {&first, &ring}) require_ring(*one, linings, path);
    require(!ring.has_along(), fmt::format("continuum.linings[{}].along", i),
            "is given, but the ring follows `" + name + "`, beside which it lies; leave it out");
    require(ring.stage() == first.stage(), fmt::format("continuum.linings[{}].stage", i),
            fmt::format("is {}, but the ring beside this one is installed in stage {}; give both the same",
                        ring.stage(), first.stage()));
    beside_[static_cast<std::size_t>(i)] = number;
  }
}

bool Rings::is_ring(int lining) const {
  return is_second(lining) || std::ranges::find(beside_, lining) != beside_.end();
}

void Rings::require_free_of_members(std::span<const LiningPlan> linings,
                                    std::span<const LiningPlan> members) const {
  for (std::size_t k = 0; k < members.size(); ++k)
    for (std::size_t i = 0; i < linings.size(); ++i)
      for (const auto end : {members[k].path.points.front(), members[k].path.points.back()})
        require(!is_ring(static_cast<int>(i)) ||
                    std::ranges::find(linings[i].path.points, end) == linings[i].path.points.end(),
                fmt::format("continuum.members[{}]", k),
                "ends at `" + linings[i].name +
                    "`, beside which lies another ring; let it end at a lining that stands alone");
}

void Rings::add_dowels(const SceneLinings& linings, std::span<const LiningPlan> plans, const Grid& grid,
                       Supports& supports) const {
  for (int i = 0; i < linings.size(); ++i) {
    if (!is_second(i)) continue;
    const auto second = static_cast<std::size_t>(i), first = static_cast<std::size_t>(beside_[second]);
    const auto& beside = linings[i].beside();
    Lining& ring = supports.linings[second];
    ring.first_dowel = static_cast<std::uint32_t>(supports.structures.dowels().size());
    ring.ring_width = beside.ring_width();
    supports.structures.set_stage(linings[i].stage());
    for (const auto& [node, stiffness, strength] :
         read_dowels(beside, linings[beside_[second]].along(), plans[second].path, grid,
                     fmt::format("continuum.linings[{}].beside", i))) {
      ring.dowels.push_back(node);
      supports.structures.add_dowel({{plans[first].path.points[node], plans[second].path.points[node]},
                                     stiffness / ring.ring_width,
                                     strength / ring.ring_width});
    }
  }
}

}  // namespace adit::fdm
