// Requirements on meshes from Gmsh: what becomes of them, and what wrong ones are told.
#include "fdm_server/meshing/gmsh.hpp"

#include <gmock/gmock.h>

#include <random>

#include "fdm_server/model/grid/read_grid.hpp"
#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"

namespace adit::fdm::test::gmsh_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Two squares of 1 m side by side, the second one clockwise, with a node that belongs to nothing (6).
//   4---5---8
//   |   |   |
//   1---2---3
const std::string kFormat = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string kNames =
    "$PhysicalNames\n3\n1 1 \"base\"\n2 1 \"soft ground\"\n2 2 \"rock\"\n$EndPhysicalNames\n";
const std::string kEntities =
    "$Entities\n1 1 2 0\n7 0 0 0 0\n1 0 0 0 2 0 0 1 1 2 1 -2\n1 0 0 0 1 1 0 1 1 0\n2 1 0 0 2 1 0 2 2 9 "
    "0\n$EndEntities\n";
const std::string kNodes =
    "$Nodes\n2 7 1 8\n2 1 0 4\n1\n2\n5\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 1 3\n6\n3\n8\n5 5 5 0 0\n2 0 0 0 "
    "0\n2 1 0 0 0\n$EndNodes\n";
const std::string kElements =
    "$Elements\n4 5 1 9\n0 7 15 1\n1 1\n1 1 1 2\n2 1 2\n3 2 3\n2 1 3 1\n8 1 2 5 4\n2 2 3 1\n9 2 5 8 "
    "3\n$EndElements\n";

Grid grid_of(const std::string& text) {
  scene::Continuum continuum;
  continuum.mutable_mesh()->set_path("tunnel.msh");
  continuum.mutable_mesh()->set_content(text);
  return read_grid(continuum);
}

const Group& group(const Grid& grid, const std::string& name) {
  return *std::ranges::find(grid.groups, name, &Group::name);
}

// Requirement: quadrilaterals become counter-clockwise zones, physical surfaces and curves groups, with or
// without a name; nodes that no quadrilateral has are left out.
TEST(Gmsh, QuadrilateralsAndPhysicalGroups) {
  const Grid grid = grid_of(kFormat + "$Comments\nanything 4.1 $ here\n$EndComments\n" + kNames + kEntities +
                            kNodes + kElements);
  EXPECT_EQ(grid.x.size(), 6u);
  ASSERT_EQ(grid.zones.size(), 2u);
  for (std::size_t z = 0; z < 2; ++z) EXPECT_DOUBLE_EQ(area(corners(grid, z)), 1);
  EXPECT_EQ(grid.boundary.size(), 6u);
  EXPECT_THAT(group(grid, "soft ground").zones, ElementsAre(0));
  EXPECT_THAT(group(grid, "rock").zones, ElementsAre(1));
  EXPECT_THAT(group(grid, "9").zones, ElementsAre(1));
  const auto& base = group(grid, "base").edges;
  ASSERT_EQ(base.size(), 2u);
  EXPECT_THAT((std::array{base[0].zone, base[1].zone}), ElementsAre(0, 1));
  EXPECT_EQ(grid.y[base[0].from] + grid.y[base[1].to], 0);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the test's mesh has no " + from);
  return text.replace(at, from.size(), to);
}
const std::string kMesh = kFormat + kNames + kEntities + kNodes + kElements;

void expect_refused(const std::string& mesh, const std::string& message) {
  adit::test::expect_refusal([&] { grid_of(mesh); }, "continuum.mesh.path", message);
}

struct Case {
  std::string name, from, to, message;
};
class MeshError : public testing::TestWithParam<Case> {};

TEST_P(MeshError, NamesTheFileTheLineAndTheRemedy) {
  expect_refused(replaced(kMesh, GetParam().from, GetParam().to), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, MeshError,
    testing::Values(
        Case{"version_2", "4.1 0 8", "2.2 0 8", "tunnel.msh:2: is in format 2.2; save it in format 4.1"},
        Case{"binary", "4.1 0 8", "4.1 1 8", "tunnel.msh:2: is binary; save it as ASCII"},
        Case{"no_mesh", "$MeshFormat", "scene: 1",
             "tunnel.msh:1: has `scene:` where $MeshFormat was expected"},
        Case{"triangles", "2 1 3 1\n8 1 2 5 4", "2 1 2 1\n8 1 2 5", "has triangles; recombine"},
        Case{"second_order", "2 1 3 1\n", "2 1 10 1\n", "of second order"},
        Case{"bricks", "2 1 3 1\n", "3 1 5 1\n", "elements of type 5"},
        Case{"no_quadrilaterals", "2 2 3 1\n9 2 5 8 3\n$EndElements\n",
             "2 2 3 0\n$EndElements\n$Elements\n0 0 0 0\n$EndElements\n", "is no side of a quadrilateral"},
        Case{"only_lines", "2 1 3 1\n8 1 2 5 4\n2 2 3 1\n9 2 5 8 3\n", "2 1 3 0\n2 2 3 0\n",
             "has no quadrilaterals; recombine"},
        Case{"no_such_node", "9 2 5 8 3", "9 2 5 8 33", "an element of node 33, which does not exist"},
        Case{"node_twice", "6\n3\n8\n", "6\n3\n1\n", "has node 1 twice"},
        Case{"out_of_plane", "2 1 0 0 0", "2 1 0.5 0 0", "has node 8 at z = 0.5 m"},
        Case{"not_a_number", "2 1 0 0 0", "2 nan 0 0 0",
             "tunnel.msh:34: has `nan` where a coordinate was expected"},
        Case{"huge_count", "2 7 1 8", "2 700000000000 1 8", "more than the file can hold"},
        Case{"negative_count", "2 7 1 8", "-2 7 1 8", "more than the file can hold"},
        Case{"lost_line", "3 2 3\n", "3 2 6\n", "the line 3 of the curve `base`, which is no side"},
        Case{"unquoted_name", "\"rock\"", "rock", "lacks its name in quotation marks"},
        Case{"unseen_name", "\"rock\"", "\"ro\u202eck\"",
             "has a character in its name that is not seen: `ro ck`; write it without"},
        Case{"long_word", "2 1 0 0 0", "2 1 " + std::string(99, 'x') + " 0 0",
             "has `" + std::string(37, 'x') + "...` where"},
        Case{"tangled", "9 2 5 8 3", "9 2 8 5 3", "has a tangled zone: element 9"},
        Case{"clockwise_alone", kElements,
             "$Elements\n1 2 1 9\n2 1 3 2\n8 1 2 5 4\n9 2 5 8 3\n$EndElements\n", "has a tangled zone"},
        Case{"point_twice", "9 2 5 8 3", "9 2 5 5 3", "has a tangled zone: element 9"}),
    adit::test::kRefusalName);

// Quadrilaterals between numbered nodes from 1, without groups.
std::string mesh_of(const std::vector<std::pair<double, double>>& nodes,
                    const std::vector<std::array<int, 4>>& zones) {
  const auto count = [](std::size_t n) { return std::to_string(n); };
  std::string text =
      kFormat + "$Nodes\n1 " + count(nodes.size()) + " 1 99\n2 1 0 " + count(nodes.size()) + "\n";
  for (std::size_t i = 1; i <= nodes.size(); ++i) text += count(i) + "\n";
  for (const auto& [x, y] : nodes) text += std::to_string(x) + " " + std::to_string(y) + " 0\n";
  text += "$EndNodes\n$Elements\n1 " + count(zones.size()) + " 1 99\n2 1 3 " + count(zones.size()) + "\n";
  for (std::size_t z = 0; z < zones.size(); ++z) {
    text += count(z + 11);
    for (const int node : zones[z]) text += " " + std::to_string(node);
    text += "\n";
  }
  return text + "$EndElements\n";
}

// Requirement: holes in the connectivity are named with their place: double nodes, hanging nodes, pieces
// apart.
TEST(Gmsh, HolesInTheConnectivityAreRefused) {
  const std::vector<std::pair<double, double>> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  auto nodes = square;
  nodes.insert(nodes.end(), {{1, 0}, {2, 0}, {2, 1}, {1, 1}});
  expect_refused(mesh_of(nodes, {{1, 2, 3, 4}, {5, 6, 7, 8}}),
                 "is not joined at (1, 0) m: element 11 and element 12 each have a point of their own there");
  nodes = square;
  nodes.insert(nodes.end(), {{2, 0}, {2, 0.5}, {1, 0.5}, {2, 1}});
  expect_refused(mesh_of(nodes, {{1, 2, 3, 4}, {2, 5, 6, 7}, {7, 6, 8, 3}}),
                 "is not joined at (1, 0.5) m: a point of element 12 lies on a side of element 11");
  nodes = square;
  nodes.insert(nodes.end(), {{5, 0}, {6, 0}, {6, 1}, {5, 1}});
  expect_refused(mesh_of(nodes, {{1, 2, 3, 4}, {5, 6, 7, 8}}),
                 "falls into pieces: element 12 at (5.5, 0.5) m");
}

// Requirement: zones on top of each other are named, which would be as stiff and as heavy as both.
TEST(Gmsh, ZonesOnTopOfEachOtherAreRefused) {
  const std::vector<std::pair<double, double>> nodes{{0, 0}, {1, 0}, {1, 1},    {0, 1},
                                                     {2, 0}, {2, 1}, {1.8, 0.9}};
  expect_refused(mesh_of(nodes, {{1, 2, 3, 4}, {2, 3, 4, 1}}),
                 "overlaps itself: element 11 and element 12 lie on the same side of their common edge from "
                 "(1, 0) m to (1, 1) m");
  expect_refused(mesh_of(nodes, {{1, 2, 3, 4}, {2, 5, 6, 3}, {2, 5, 7, 3}}),
                 "element 12 and element 13 lie on the same side");
}

// Requirement: whatever is cut off or changed in a file, it is read or refused in one sentence.
TEST(Gmsh, GarbageIsRefusedInOneSentence) {
  std::mt19937 random(7);
  const auto try_to_read = [](const std::string& text) {
    try {
      grid_of(text);
      return 1;
    } catch (const protocol::UserError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return 0;
    }
  };
  for (std::size_t length = 0; length + 2 < kMesh.size(); ++length)
    EXPECT_EQ(try_to_read(kMesh.substr(0, length)), 0) << length;
  int read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = kMesh;
    for (std::size_t left = 1 + random() % 3; left > 0; --left)
      text[random() % text.size()] = "0123456789-. \n$\"\x01\xff"[random() % 18];
    read += try_to_read(text);
  }
  EXPECT_GT(read, 100);
  EXPECT_LT(read, 19000);
}

}  // namespace
}  // namespace adit::fdm::test::gmsh_test
