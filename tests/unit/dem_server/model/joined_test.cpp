// Which pairs are joined must not hang on how finely a file writes its numbers; what is doubtful is told.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "dem_server/model/reading/read_model.hpp"
#include "protocol/participant/warnings.hpp"
#include "protocol/results/vtk.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::joined_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Rows of touching discs of radius 5 cm, far from the origin.
scene::Scene lattice() {
  auto scene = test::empty_scene();
  auto& packing = *scene.mutable_particles()->mutable_packing();
  test::set_box(packing, 12.4, 0.7);
  packing.set_x_min(10);
  packing.set_radius(0.05);
  return scene;
}

std::string table_of(const Discs& discs, const std::function<std::string(double)>& written) {
  std::string table = "x_m,y_m,radius_m\n";
  for (std::size_t i = 0; i < discs.size(); ++i)
    table += written(discs.x[i]) + "," + written(discs.y[i]) + "," + written(discs.radius[i]) + "\n";
  return table;
}

std::vector<std::string> warnings(const Model& model) {
  std::vector<std::string> warnings;
  for (const std::string& note : model.notes)
    if (note.starts_with(protocol::kWarning)) warnings.push_back(note);
  return warnings;
}

// Requirement: a table with six decimals, digits or more has the bonds of the packing that it was written
// from.
TEST(Joined, TablesOfRoundedNumbers) {
  const Model whole = read_model(lattice());
  const std::function<std::string(double)> formats[] = {
      [](double v) { return fmt::format("{:.6f}", v); },
      [](double v) { return fmt::format("{:.9f}", v); },
      [](double v) { return fmt::format("{:.7g}", v); },
      [](double v) { return fmt::format("{:.7e}", v); },
      [](double v) { return fmt::format("{}", v); },
      [](double v) { return v == 0.05 ? "0.05" : fmt::format("{:.6f}", v); }};
  for (const auto& format : formats) {
    const Model read = read_model(test::placed_scene(table_of(whole.discs, format)));
    EXPECT_EQ(read.bonds.size(), whole.bonds.size()) << format(whole.discs.y.back());
    EXPECT_THAT(warnings(read), IsEmpty());
  }
}

// Requirement: so have points in single precision.
TEST(Joined, PointsInSinglePrecision) {
  const Model whole = read_model(lattice());
  const auto words = [](const std::vector<double>& values) {
    std::string text;
    for (const double v : values) text += fmt::format("{:.9g} ", static_cast<double>(static_cast<float>(v)));
    return text;
  };
  std::vector<double> points;
  for (std::size_t i = 0; i < whole.discs.size(); ++i)
    points.insert(points.end(), {whole.discs.x[i], whole.discs.y[i], 0});
  const std::string vtp = fmt::format(
      "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"{}\"><PointData><DataArray "
      "type=\"Float32\" "
      "Name=\"radius_m\" format=\"ascii\">{}</DataArray></PointData><Points><DataArray type=\"Float32\" "
      "NumberOfComponents=\"3\" format=\"ascii\">{}</DataArray></Points></Piece></PolyData></VTKFile>",
      whole.discs.size(), words(whole.discs.radius), words(points));
  EXPECT_EQ(read_model(test::placed_scene(vtp)).bonds.size(), whole.bonds.size());
}

// Requirement: what a run writes of a packing has its bonds again.
TEST(Joined, ResultsOfARun) {
  const Model whole = read_model(test::random_scene());
  wire::Piece piece;
  piece.set_name("particles");
  piece.set_shape(wire::Piece::VERTICES);
  auto& radius = *piece.add_point_fields();
  radius.set_name("radius_m");
  radius.set_components(1);
  for (std::size_t i = 0; i < whole.discs.size(); ++i) {
    piece.add_points(whole.discs.x[i]);
    piece.add_points(whole.discs.y[i]);
    radius.add_values(whole.discs.radius[i]);
  }
  EXPECT_EQ(read_model(test::placed_scene(results::vtk_document(piece))).bonds.size(), whole.bonds.size());
}

// Requirement: a gap that the numbers state is a gap: whole numbers are exact.
TEST(Joined, GapsThatATableStates) {
  EXPECT_THAT(read_model(test::placed_scene("x_m,y_m,radius_m\n0,0,1\n2.01,0,1\n")).bonds, IsEmpty());
  EXPECT_THAT(read_model(test::placed_scene("x_m,y_m,radius_m\n0,0,5\n11,0,5\n")).bonds, IsEmpty());
  EXPECT_THAT(read_model(test::placed_scene("x_m,y_m,radius_m\n0,0,0.05\n0.100100,0,0.05\n")).bonds,
              IsEmpty());
}

// Requirement: a reach that the scene states holds; where many pairs only just miss it, a warning says so.
TEST(Joined, NearPairsWithoutABondAreTold) {
  const Discs discs = read_model(lattice()).discs;
  auto scene = test::placed_scene(table_of(discs, [](double v) { return fmt::format("{:.6f}", v); }));
  scene.mutable_particles()->mutable_bonds()->set_reach(1e-6);
  const Model stated = read_model(scene);
  EXPECT_LT(stated.bonds.size(), read_model(lattice()).bonds.size());
  EXPECT_THAT(warnings(stated),
              ElementsAre(AllOf(HasSubstr(fmt::format("have {} bonds", stated.bonds.size())),
                                HasSubstr("give bonds.reach: 0.001"))));
  const Model coarse = read_model(test::placed_scene(
      table_of(discs, [](double v) { return v == 0.05 ? "0.05" : fmt::format("{:.3f}", v); })));
  EXPECT_THAT(warnings(coarse), ElementsAre(HasSubstr("more pairs only touch")));
  EXPECT_THAT(warnings(read_model(test::random_scene())), IsEmpty());
}

// Requirement: an open joint through many rows interlocks, which a warning says; short ones and smooth ones
// pass.
TEST(Joined, OpenJointsThroughRows) {
  const auto with_joint = [](double x_1, double y_1, double x_2, double y_2, bool open) {
    auto scene = lattice();
    auto& joint = *scene.mutable_particles()->add_joints();
    test::set(*joint.mutable_from(), x_1, y_1);
    test::set(*joint.mutable_to(), x_2, y_2);
    if (open) {
      joint.set_open(true);
    } else {
      joint.mutable_smooth()->set_normal_stiffness(1e9);
      joint.mutable_smooth()->set_shear_stiffness(1e9);
    }
    return warnings(read_model(scene));
  };
  EXPECT_THAT(
      with_joint(9, 0.3, 13, 0.36, true),
      ElementsAre(AllOf(HasSubstr("particles.joints[0] is open across"), HasSubstr("a `smooth` joint"))));
  EXPECT_THAT(with_joint(9, 0.3, 13, 0.36, false), IsEmpty());
  EXPECT_THAT(with_joint(11, -1, 11.2, 1, true), IsEmpty());
}

// Requirement: a warning says that discs which spin freely roll at a smooth joint, whose forces they do not
// bear: those of a lattice without shear stiffness, unless other bonds hold them.
TEST(Joined, SmoothJointsBetweenDiscsThatRoll) {
  const auto with_ratio = [](double poisson_ratio, bool parallel) {
    auto scene = lattice();
    scene.set_plane(scene::PLANE_STRAIN);
    scene.mutable_material()->set_poisson_ratio(poisson_ratio);
    if (parallel) {
      auto& bonds = *scene.mutable_particles()->mutable_bonds()->mutable_parallel();
      bonds.set_normal_stiffness(1e12);
      bonds.set_shear_stiffness(1e11);
    }
    auto& joint = *scene.mutable_particles()->add_joints();
    test::set(*joint.mutable_from(), 9, 0.3);
    test::set(*joint.mutable_to(), 13, 0.36);
    joint.mutable_smooth()->set_normal_stiffness(1e9);
    joint.mutable_smooth()->set_shear_stiffness(1e9);
    return warnings(read_model(scene));
  };
  EXPECT_THAT(with_ratio(0.25, false), ElementsAre(HasSubstr("roll on one another")));
  EXPECT_THAT(with_ratio(0.2, false), IsEmpty());
  EXPECT_THAT(with_ratio(0.25, true), IsEmpty());
}

}  // namespace
}  // namespace adit::dem::joined_test
