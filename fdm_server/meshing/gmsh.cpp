#include "fdm_server/meshing/gmsh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/meshing/mesh_text.hpp"

namespace adit::fdm {
namespace {

constexpr int kCurve = 1, kSurface = 2;
using Entity = std::pair<int, std::int64_t>;  // dimension and number

struct Node {
  double x, y, z;
  std::int32_t point = -1;  // of the grid, where a quadrilateral has it
};

struct Line {
  std::int64_t element;
  std::array<std::int64_t, 2> nodes;
  std::vector<std::size_t> groups;
};

class Reader {
 public:
  Reader(MeshText text, std::size_t most_points) : text_(std::move(text)), most_points_(most_points) {}

  MeshGrid read() {
    text_.expect("$MeshFormat");
    read_format();
    while (!text_.at_end()) {
      const auto section = text_.word("a section");
      if (section == "$PhysicalNames")
        read_names();
      else if (section == "$Entities")
        read_entities();
      else if (section == "$Nodes")
        read_nodes();
      else if (section == "$Elements")
        read_elements();
      else if (section.starts_with("$"))
        // Sections such as periodic nodes or partitions do not matter for the grid.
        text_.skip_past("$End" + std::string(section.substr(1)));
      else
        text_.refuse("has text outside of its sections");
    }
    if (grid().zones.empty())
      text_.refuse("has no quadrilaterals; recombine the surfaces in Gmsh (`Mesh.RecombineAll = 1;`)");
    const auto edges = number_edges(grid());
    grid().boundary = boundary(edges);
    add_lines(edges);
    for (Group& group : grid().groups) {
      // Surfaces come in any order, and one may be in two groups of the same name.
      auto& zones = group.zones;
      std::ranges::sort(zones);
      zones.erase(std::unique(zones.begin(), zones.end()), zones.end());
    }
    std::erase_if(grid().groups,
                  [](const Group& group) { return group.zones.empty() && group.edges.empty(); });
    return std::move(result_);
  }

 private:
  Grid& grid() { return result_.grid; }

  void read_format() {
    const auto version = text_.word("a version");
    if (version != "4.1")
      text_.refuse(fmt::format("is in format {}; save it in format 4.1 (`gmsh -format msh41`)",
                               version.substr(0, 10)));
    if (text_.whole("0 for ASCII") != 0) text_.refuse("is binary; save it as ASCII (`Mesh.Binary = 0;`)");
    text_.whole("a size");
    text_.expect("$EndMeshFormat");
  }

  void read_names() {
    for (std::size_t left = text_.count("the number of names"); left > 0; --left) {
      const auto dimension = static_cast<int>(text_.whole("a dimension"));
      const auto number = text_.whole("a physical group");
      names_[{dimension, number}] = text_.quoted("its name");
    }
    text_.expect("$EndPhysicalNames");
  }

  void read_entities() {
    std::array<std::size_t, 4> counts{};
    for (auto& count : counts) count = text_.count("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (; counts[dimension] > 0; --counts[dimension]) {
        const Entity entity{dimension, text_.whole("an entity")};
        for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) text_.number("a bound of an entity");
        for (std::size_t left = text_.count("a number of physical groups"); left > 0; --left)
          groups_of_[entity].push_back(group_of({dimension, read_group_number()}));
        if (dimension == 0) continue;
        for (std::size_t left = text_.count("a number of bounding entities"); left > 0; --left)
          text_.whole("a bounding entity");
      }
    text_.expect("$EndEntities");
  }

  // Its sign tells the orientation of the entity, which does not matter here.
  std::int64_t read_group_number() {
    const std::int64_t number = text_.whole("a physical group");
    if (number != static_cast<std::int32_t>(number))
      text_.refuse(fmt::format("has a physical group {}; Gmsh numbers them by 32 bits", number));
    return std::abs(number);
  }

  std::size_t group_of(const Entity& physical) {
    const auto known = names_.find(physical);
    const std::string name = known == names_.end() ? std::to_string(physical.second) : known->second;
    auto& groups = grid().groups;
    const auto found = std::ranges::find(groups, name, &Group::name);
    if (found == groups.end()) groups.push_back({name, {}, {}});
    return static_cast<std::size_t>(std::ranges::find(groups, name, &Group::name) - groups.begin());
  }

  void read_nodes() {
    std::size_t blocks = text_.count("a number of blocks");
    if (const auto count = text_.count("a number of nodes"); count > most_points_)
      text_.refuse(
          fmt::format("has {} nodes; at most {} can be computed on this machine, use larger elements", count,
                      most_points_));
    text_.whole("the smallest node");
    text_.whole("the largest node");
    for (; blocks > 0; --blocks) {
      const auto dimension = text_.whole("a dimension");
      text_.whole("an entity");
      const bool parametric = text_.whole("0 or 1") != 0;
      std::vector<std::int64_t> numbers(text_.count("a number of nodes"));
      for (auto& number : numbers) number = text_.whole("a node");
      for (const auto number : numbers) {
        Node node{};
        node.x = text_.number("a coordinate");
        node.y = text_.number("a coordinate");
        node.z = text_.number("a coordinate");
        for (std::int64_t i = 0; parametric && i < dimension; ++i) text_.number("a parameter");
        if (!nodes_.emplace(number, node).second) text_.refuse(fmt::format("has node {} twice", number));
      }
    }
    text_.expect("$EndNodes");
  }

  void read_elements() {
    std::size_t blocks = text_.count("a number of blocks");
    text_.count("a number of elements");
    text_.whole("the smallest element");
    text_.whole("the largest element");
    for (; blocks > 0; --blocks) {
      const auto dimension = static_cast<int>(text_.whole("a dimension"));
      const Entity entity{dimension, text_.whole("an entity")};
      const auto type = text_.whole("an element type");
      const std::size_t count = text_.count("a number of elements");
      if (dimension == kSurface && type == 3)
        read_quadrilaterals(entity, count);
      else if (dimension == kCurve && type == 1)
        read_lines(entity, count);
      else if (type == 15)
        // A point element is its number and one node; the grid has the node already.
        for (std::size_t i = 0; i < 2 * count; ++i) text_.whole("a node");
      else
        refuse_type(type);
    }
    text_.expect("$EndElements");
  }

  [[noreturn]] void refuse_type(std::int64_t type) const {
    const bool triangle = type == 2 || type == 9;
    if (triangle)
      text_.refuse(
          "has triangles; recombine all surfaces to quadrilaterals in Gmsh (`Mesh.RecombineAll = 1;` and "
          "`Mesh.SubdivisionAlgorithm = 1;`)");
    if (type == 8 || type == 10 || type == 16)
      text_.refuse("has elements of second order; save the mesh with `Mesh.ElementOrder = 1;`");
    text_.refuse(fmt::format(
        "has elements of type {}; only plane quadrilaterals of four nodes, with lines and points, "
        "make a grid",
        type));
  }

  std::int32_t point_of(std::int64_t number) {
    const auto found = nodes_.find(number);
    if (found == nodes_.end())
      text_.refuse(fmt::format("has an element of node {}, which does not exist", number));
    Node& node = found->second;
    if (node.point >= 0) return node.point;
    if (node.z != 0)
      text_.refuse(
          fmt::format("has node {} at z = {:g} m; let the mesh lie in the plane z = 0", number, node.z));
    // Nodes become points when the first quadrilateral needs them, so that nodes without one are left out.
    node.point = static_cast<std::int32_t>(grid().x.size());
    grid().x.push_back(node.x);
    grid().y.push_back(node.y);
    return node.point;
  }

  void read_quadrilaterals(const Entity& entity, std::size_t count) {
    const std::size_t first = grid().zones.size();
    double whole = 0;
    for (; count > 0; --count) {
      result_.elements.push_back(text_.whole("an element"));
      ZonePoints zone{};
      for (auto& point : zone) point = point_of(text_.whole("a node"));
      grid().zones.push_back(zone);
      whole += area(corners(grid(), grid().zones.size() - 1));
    }
    for (std::size_t z = first; z < grid().zones.size(); ++z) {
      if (whole < 0) std::swap(grid().zones[z][1], grid().zones[z][3]);
      for (const auto group : groups_of_[entity])
        grid().groups[group].zones.push_back(static_cast<std::uint32_t>(z));
    }
  }

  // Kept until all quadrilaterals are known, whose sides they are.
  void read_lines(const Entity& entity, std::size_t count) {
    for (; count > 0; --count) {
      const auto element = text_.whole("an element");
      const std::array<std::int64_t, 2> nodes{text_.whole("a node"), text_.whole("a node")};
      const auto& groups = groups_of_[entity];
      if (!groups.empty()) lines_.push_back({element, nodes, groups});
    }
  }

  void add_lines(const Edges& edges) {
    if (lines_.empty()) return;
    std::map<std::pair<std::int32_t, std::int32_t>, Edge> by_points;
    // A line of a curve may run either way, so edges are known by their points in ascending order.
    for (const Edge& edge : edges.list) by_points.emplace(std::minmax(edge.from, edge.to), edge);
    for (const auto& [element, nodes, groups] : lines_) {
      const auto point = [&](std::int64_t node) {
        const auto found = nodes_.find(node);
        return found == nodes_.end() ? -1 : found->second.point;
      };
      const auto edge = by_points.find(std::minmax({point(nodes[0]), point(nodes[1])}));
      if (edge == by_points.end())
        text_.refuse(
            fmt::format("has the line {} of the curve `{}`, which is no side of a quadrilateral; mesh the "
                        "surfaces beside it, or take it out of its physical group",
                        element, grid().groups[groups.front()].name));
      for (const auto group : groups) grid().groups[group].edges.push_back(edge->second);
    }
  }

  MeshText text_;
  std::size_t most_points_;
  MeshGrid result_;
  std::map<Entity, std::string> names_;                   // of physical groups
  std::map<Entity, std::vector<std::size_t>> groups_of_;  // of geometrical entities
  std::unordered_map<std::int64_t, Node> nodes_;
  std::vector<Line> lines_;
};

}  // namespace

MeshGrid read_gmsh(std::string_view text, const std::string& name, const std::string& path,
                   std::size_t most_points) {
  return Reader(MeshText(text, name, path), most_points).read();
}

}  // namespace adit::fdm
