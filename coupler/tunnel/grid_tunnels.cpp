#include "coupler/tunnel/grid_tunnels.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "coupler/tunnel/contour.hpp"
#include "coupler/tunnel/host_block.hpp"
#include "coupler/tunnel/joints.hpp"
#include "coupler/tunnel/layers.hpp"
#include "coupler/tunnel/lining.hpp"
#include "coupler/tunnel/opening.hpp"
#include "coupler/tunnel/parts.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using geometry::BoundingBox;
using geometry::Point;
using protocol::require;

constexpr std::uint32_t kFewestZones = 3;  // of the block, over the width and the height of the fitted area

// The node of an outline that is nearest to a place.
std::size_t nearest(const std::vector<Point>& nodes, const Point& place) {
  const auto away = [&](const Point& node) { return std::hypot(node.x - place.x, node.y - place.y); };
  return static_cast<std::size_t>(std::ranges::min_element(nodes, {}, away) - nodes.begin());
}

// A tunnel in its grid.
class GridTunnel {
 public:
  GridTunnel(const scene::LinedTunnel& tunnel, std::string path)
      : tunnel_(tunnel), path_(std::move(path)), contour_(tunnel, path_), layers_(layers_of(tunnel, path_)) {
    for (const LiningLayer& layer : layers_) thickness_ += layer.thickness;
  }

  const std::string& path() const { return path_; }
  bool of_beams() const { return tunnel_.lining().as() == scene::TunnelLining::BEAM; }

  // The outline from which on the zones are ground.
  double ground_begins() const {
    return of_beams() ? thickness_ - layers_.front().thickness / 2 : thickness_;
  }
  BoundingBox extent() const { return contour_.box(ground_begins()); }

  // Takes the zones around it out of their block.
  Opening fit_into(HostBlock& host) const {
    const BoundingBox box = extent();
    const double around = tunnel_.zones().has_around()
                              ? tunnel_.zones().around()
                              : std::max(box.x_max - box.x_min, box.y_max - box.y_min) / 2;
    const ZoneRange zones = host.zones_around(contour_.box(ground_begins() + around));
    require_room(host, zones);
    host.take(zones, path_);
    return {tunnel_, contour_, host, zones};
  }

  std::vector<scene::GridBlock> blocks(const Opening& opening, const std::string& group) const {
    std::vector<scene::GridBlock> found;
    const auto add = [&found](std::vector<scene::GridBlock> blocks, const std::string& name) {
      for (scene::GridBlock& block : blocks) {
        if (!name.empty()) block.set_name(name);
        found.push_back(std::move(block));
      }
    };
    add(opening.surroundings(ground_begins()), group);
    if (tunnel_.stage() > 0) add(opening.inside(of_beams() ? ground_begins() : 0), opening_name());
    if (!of_beams())
      for_each_layer([&](const LiningLayer& layer, double inner, double outer) {
        add(opening.ring(inner, outer, zones_across(layer, opening.side(inner))), layer.name);
      });
    return found;
  }

  void add_to(scene::Continuum& continuum, const Opening& opening) const {
    if (tunnel_.stage() > 0) add_excavation(continuum, opening_name());
    if (of_beams())
      add_beams(continuum, opening);
    else
      add_zones(continuum, opening);
    add_convergence(continuum, opening);
  }

  std::string note(const Opening& opening) const {
    const auto [x_min, x_max, y_min, y_max] = opening.extent();
    return fmt::format(
        "{}: {} zones, {:.3g} m long, stand around its {}, {:.4g} m outside its inner side; the grid is "
        "fitted "
        "to it within x = {:.6g} to {:.6g} m, y = {:.6g} to {:.6g} m",
        tunnel_.name(), opening.size(), opening.side(ground_begins()), of_beams() ? "beams" : "lining",
        ground_begins(), x_min, x_max, y_min, y_max);
  }

 private:
  std::string opening_name() const { return tunnel_.name() + "_opening"; }

  void require_room(const HostBlock& host, const ZoneRange& zones) const {
    require(zones.right - zones.left >= kFewestZones && zones.upper - zones.lower >= kFewestZones, path_,
            fmt::format("has only {} by {} zones of its block in and around it; let the block have smaller "
                        "ones, or give a larger `zones.around`",
                        zones.right - zones.left, zones.upper - zones.lower));
    const BoundingBox box = extent();
    const double width = host.zone_width(), height = host.zone_height();
    const double least =
        std::min({(box.x_min - host.x(zones.left)) / width, (host.x(zones.right) - box.x_max) / width,
                  (box.y_min - host.y(zones.lower)) / height, (host.y(zones.upper) - box.y_max) / height});
    require(least >= 0.5, path_,
            fmt::format("has only {:.2g} of a zone's width between its lining and the edge of the zones "
                        "around it; let it lie deeper in its block, or give a larger `zones.around`",
                        least));
  }

  std::uint32_t zones_across(const LiningLayer& layer, double length) const {
    if (tunnel_.zones().has_across()) return tunnel_.zones().across();
    constexpr double kAboutAsLong = 1.1;
    return static_cast<std::uint32_t>(std::max(1.0, std::floor(kAboutAsLong * layer.thickness / length)));
  }

  // With the distances of its faces from the inner side of the lining.
  template <class Work>
  void for_each_layer(const Work& work) const {
    double outer = thickness_;
    for (const LiningLayer& layer : layers_) {
      work(layer, outer - layer.thickness, outer);
      outer -= layer.thickness;
    }
  }

  void add_excavation(scene::Continuum& continuum, const std::string& group) const {
    auto& excavation = *continuum.add_excavations();
    excavation.mutable_where()->set_group(group);
    excavation.set_stage(tunnel_.stage());
    if (tunnel_.has_released()) excavation.set_released(tunnel_.released());
  }

  void add_beams(scene::Continuum& continuum, const Opening& opening) const {
    const scene::TunnelLining& wanted = tunnel_.lining();
    for (std::size_t k = 0; k < layers_.size(); ++k) {
      const LiningLayer& layer = layers_[k];
      auto& lining = *continuum.add_linings();
      lining.set_name(layer.name);
      if (k == 0)
        *lining.mutable_along() = opening.path(ground_begins());
      else
        lining.set_on(layers_[k - 1].name);
      if (layer.section != nullptr) {
        *lining.mutable_section() = *layer.section;
      } else {
        lining.set_thickness(layer.thickness);
        lining.set_young_modulus(layer.material.young_modulus());
      }
      lining.set_poisson_ratio(layer.material.poisson_ratio());
      lining.set_density(layer.material.density());
      if (layer.interface != nullptr) *lining.mutable_interface() = *layer.interface;
      if (layer.stage > 0) lining.set_stage(layer.stage);
      if (wanted.has_second_ring()) add_second_ring(lining, layer, continuum, opening);
      add_joints_of_segments(joint_angles(wanted), layer.thickness, lining);
      add_histories_of(layer, layer.name, continuum, opening);
    }
  }

  // Like the first one but for its joints.
  void add_second_ring(const scene::Lining& first, const LiningLayer& layer, scene::Continuum& continuum,
                       const Opening& opening) const {
    const scene::SecondRing& wanted = tunnel_.lining().second_ring();
    scene::Lining ring = first;
    ring.set_name(first.name() + "_second");
    ring.clear_along();
    add_joints_of_segments(joint_angles(tunnel_.lining(), wanted), layer.thickness, ring);
    scene::RingBeside& beside = *ring.mutable_beside();
    beside.set_lining(first.name());
    beside.set_ring_width(wanted.width());
    for (std::uint32_t k = 0; k < wanted.dowels(); ++k) {
      scene::RingDowel& dowel = *beside.add_dowels();
      dowel.set_angle(wanted.first_dowel() + k * 2 * std::numbers::pi / wanted.dowels());
      dowel.set_stiffness(wanted.dowel_stiffness());
      if (wanted.has_dowel_strength()) dowel.set_strength(wanted.dowel_strength());
    }
    *continuum.add_linings() = ring;
    add_histories_of(layer, ring.name(), continuum, opening);
  }

  void add_joints_of_segments(const std::vector<double>& angles, double thickness,
                              scene::Lining& lining) const {
    const scene::TunnelLining& wanted = tunnel_.lining();
    for (const double angle : angles) {
      scene::LiningJoint& joint = *lining.add_joints();
      joint.set_angle(angle);
      *joint.mutable_contact() = wanted.contact();
      if (!wanted.has_contact()) joint.mutable_contact()->set_height(thickness);
      if (wanted.has_gasket()) {
        *joint.mutable_gasket()->mutable_force() = wanted.gasket();
        joint.mutable_gasket()->set_position(0);
      }
      if (!wanted.has_bolts()) continue;
      scene::JointBolts& bolts = *joint.add_bolts();
      bolts.set_stiffness(wanted.bolts().stiffness());
      if (wanted.bolts().has_pretension()) bolts.set_pretension(wanted.bolts().pretension());
      if (wanted.bolts().has_strength()) bolts.set_yield_force(wanted.bolts().strength());
    }
  }

  void add_zones(scene::Continuum& continuum, const Opening& opening) const {
    for_each_layer([&](const LiningLayer& layer, double inner, double outer) {
      if (layer.stage > 0) add_excavation(continuum, layer.name);
      auto& area = *continuum.add_materials();
      area.mutable_where()->set_group(layer.name);
      *area.mutable_material() = layer.material;
      if (layer.stage > 0) area.set_stage(layer.stage);
      if (layer.interface != nullptr) {
        auto& interface = *continuum.add_interfaces();
        interface.set_name(layer.name);
        *interface.mutable_along() = opening.path(outer);
        *interface.mutable_law() = *layer.interface;
      }
      add_sections_of(layer, inner, outer, continuum, opening);
    });
  }

  // Places along the inner side of the lining, as those of particles (lining.cpp).
  template <class Work>
  void for_each_section(const Work& work) const {
    for (std::uint32_t k = 0; k < tunnel_.sections(); ++k)
      work(fmt::format("section_{}", k + 1), contour_.cut(static_cast<double>(k) / tunnel_.sections()));
  }

  void add_histories_of(const LiningLayer& layer, const std::string& lining, scene::Continuum& continuum,
                        const Opening& opening) const {
    const auto nodes = opening.nodes(ground_begins());
    for_each_section([&](const std::string& section, const Contour::Cut& cut) {
      for (const scene::Quantity quantity : quantities_of_sections(resists(layer.section))) {
        auto& history = add_history(continuum, lining + "_" + section, quantity);
        history.set_lining(lining);
        *history.mutable_at() = point(nodes[nearest(nodes, cut.at(ground_begins()))]);
      }
    });
  }

  void add_sections_of(const LiningLayer& layer, double inner, double outer, scene::Continuum& continuum,
                       const Opening& opening) const {
    const auto within = opening.nodes(inner), outside = opening.nodes(outer);
    for_each_section([&](const std::string& name, const Contour::Cut& cut) {
      const std::size_t node = nearest(within, cut.at(inner));
      auto& section = *continuum.add_sections();
      section.set_name(layer.name + "_" + name);
      *section.mutable_from() = point(within[node]);
      *section.mutable_to() = point(outside[node]);
      if (resists(layer.section)) *section.mutable_section() = *layer.section;
      for (const scene::Quantity quantity : quantities_of_sections(resists(layer.section)))
        add_history(continuum, section.name(), quantity).set_section(section.name());
    });
  }

  void add_convergence(scene::Continuum& continuum, const Opening& opening) const {
    const double offset = of_beams() ? ground_begins() : 0;
    const auto nodes = opening.nodes(offset);
    for (const auto& [part, place] : convergence_places(contour_, offset))
      for (const scene::Quantity quantity : {scene::DISPLACEMENT_X, scene::DISPLACEMENT_Y})
        *add_history(continuum, tunnel_.name() + "_" + part, quantity).mutable_at() =
            point(nodes[nearest(nodes, place)]);
  }

  const scene::LinedTunnel& tunnel_;
  std::string path_;
  Contour contour_;
  std::vector<LiningLayer> layers_;
  double thickness_ = 0;  // of all layers [m]
};

// Of each list of a continuum that tunnels add to, how long it is.
constexpr std::pair<const char*, int (scene::Continuum::*)() const> kLists[] = {
    {"excavations", &scene::Continuum::excavations_size}, {"linings", &scene::Continuum::linings_size},
    {"materials", &scene::Continuum::materials_size},     {"interfaces", &scene::Continuum::interfaces_size},
    {"sections", &scene::Continuum::sections_size},       {"histories", &scene::Continuum::histories_size}};

std::vector<int> lengths(const scene::Continuum& continuum) {
  std::vector<int> found;
  for (const auto& [list, size] : kLists) found.push_back((continuum.*size)());
  return found;
}

// The entries that the lists got since then.
void note_origins(const std::vector<int>& before, const std::string& tunnel, Expansion& expansion) {
  const std::vector<int> after = lengths(expansion.scene.continuum());
  for (std::size_t list = 0; list < before.size(); ++list)
    for (int k = before[list]; k < after[list]; ++k)
      expansion.origins.push_back({fmt::format("continuum.{}[{}]", kLists[list].first, k), tunnel});
}

// The blocks in which tunnels lie, each once.
class Hosts {
 public:
  explicit Hosts(const scene::Continuum& continuum) : continuum_(continuum) {}

  struct Host {
    HostBlock block;
    std::vector<scene::GridBlock> fitted = {};
    std::vector<std::string> tunnels = {};  // paths, one for each fitted block
  };

  Host& around(const BoundingBox& box, const std::string& path) {
    HostBlock block = HostBlock::around(box, continuum_, path);
    const auto known =
        std::ranges::find(hosts_, block.number(), [](const Host& host) { return host.block.number(); });
    return known != hosts_.end() ? *known : hosts_.emplace_back(Host{std::move(block)});
  }

  const std::vector<Host>& all() const { return hosts_; }

 private:
  const scene::Continuum& continuum_;
  std::vector<Host> hosts_;
};

// The grid of the scene with what hosts became. Blocks without tunnels keep their numbers.
void replace_blocks(const std::vector<Hosts::Host>& hosts, Expansion& expansion) {
  scene::Continuum& continuum = *expansion.scene.mutable_continuum();
  for (const auto& [host, fitted, tunnels] : hosts) {
    std::vector<scene::GridBlock> blocks = host.remains();
    const std::size_t remaining = blocks.size();
    blocks.insert(blocks.end(), fitted.begin(), fitted.end());
    if (continuum.blocks().empty()) continuum.clear_block();
    int number = host.number();
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      if (number < 0) {
        number = continuum.blocks_size();
        continuum.add_blocks();
      }
      *continuum.mutable_blocks(number) = blocks[k];
      if (k >= remaining)
        expansion.origins.push_back({fmt::format("continuum.blocks[{}]", number), tunnels[k - remaining]});
      number = -1;
    }
  }
}

}  // namespace

void add_grid_tunnels(const scene::Scene& given, Expansion& expansion) {
  Hosts hosts(given.continuum());
  scene::Continuum& continuum = *expansion.scene.mutable_continuum();
  for (int k = 0; k < given.tunnels_size(); ++k) {
    if (given.tunnels(k).lining().as() == scene::TunnelLining::PARTICLES) continue;
    const GridTunnel tunnel(given.tunnels(k), fmt::format("tunnels[{}]", k));
    auto& [host, fitted, tunnels] = hosts.around(tunnel.extent(), tunnel.path());
    const Opening opening = tunnel.fit_into(host);
    for (scene::GridBlock& block : tunnel.blocks(opening, host.group())) {
      fitted.push_back(std::move(block));
      tunnels.push_back(tunnel.path());
    }
    const std::vector<int> before = lengths(continuum);
    tunnel.add_to(continuum, opening);
    note_origins(before, tunnel.path(), expansion);
    expansion.notes.push_back(tunnel.note(opening));
  }
  replace_blocks(hosts.all(), expansion);
}

}  // namespace adit::coupler
