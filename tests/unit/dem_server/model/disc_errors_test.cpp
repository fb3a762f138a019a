// Every scene of discs that cannot be computed: the error names the field and says what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "dem_server/model/reading/read_model.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::disc_errors_test {
namespace {

using Case = adit::test::Refusal<std::function<scene::Scene()>>;
class DiscErrors : public testing::TestWithParam<Case> {};

TEST_P(DiscErrors, NameTheFieldAndTheRemedy) {
  const scene::Scene scene = GetParam().input();
  adit::test::expect_refusal(
      [&] {
        protocol::check_rules(scene);
        read_model(scene);
      },
      GetParam().path, GetParam().message);
}

// Four by two discs of radius 0.5 m, spoilt.
auto square(std::function<void(scene::Scene&, scene::Particles&)> spoil) {
  return [spoil = std::move(spoil)] {
    auto scene = test::square_scene(4, 2);
    spoil(scene, *scene.mutable_particles());
    return scene;
  };
}

auto random(std::function<void(scene::RandomPacking&)> spoil) {
  return [spoil = std::move(spoil)] {
    auto scene = test::random_scene();
    spoil(*scene.mutable_particles()->mutable_random_packing());
    return scene;
  };
}

auto placed(const std::string& content) {
  return [content] { return test::placed_scene(content); };
}

scene::ParticleGroup& add_group(scene::Particles& p, const std::string& name) {
  auto& group = *p.add_groups();
  group.set_name(name);
  group.mutable_where()->set_x_max(2);
  return group;
}

scene::BondsBetween& add_between(scene::Particles& p, const std::string& first, const std::string& second) {
  auto& between = *p.add_between();
  between.set_first(first);
  between.set_second(second);
  return between;
}

scene::ParticleJoint& add_joint(scene::Particles& p, double x_1, double y_1, double x_2, double y_2) {
  auto& joint = *p.add_joints();
  test::set(*joint.mutable_from(), x_1, y_1);
  test::set(*joint.mutable_to(), x_2, y_2);
  return joint;
}

scene::ParticleSpring& add_spring(scene::Particles& p, double x_1, double y_1, double x_2, double y_2) {
  auto& spring = *p.add_springs();
  test::set(*spring.mutable_from(), x_1, y_1);
  test::set(*spring.mutable_to(), x_2, y_2);
  spring.set_stiffness(1e6);
  return spring;
}

scene::Wall& add_wall(scene::Particles& p, const std::string& name) {
  auto& wall = *p.add_walls();
  wall.set_name(name);
  test::set(*wall.mutable_from(), 0, 0);
  test::set(*wall.mutable_to(), 4, 0);
  return wall;
}

scene::SegmentRing& set_ring(scene::Particles& p, double inner, double outer) {
  auto& ring = *p.mutable_ring();
  test::set(*ring.mutable_centre(), 2, 1);
  ring.set_inner_radius(inner);
  ring.set_outer_radius(outer);
  ring.set_segments(2);
  return ring;
}

INSTANTIATE_TEST_SUITE_P(
    Packing, DiscErrors,
    testing::Values(
        Case{"NoParticles", "particles", "needs a scene with particles",
             square([](auto& s, auto&) { s.clear_particles(); })},
        Case{"NoPacking", "particles", "has no packings; give one of",
             square([](auto&, auto& p) { p.clear_square_packing(); })},
        Case{"TwoPackings", "particles", "has 2 packings; give one of",
             square([](auto&, auto& p) { p.mutable_placed()->set_path("discs.csv"); })},
        Case{"FlatBox", "particles.square_packing.y_max", "is 0 m, expected a length above `y_min` = 0 m",
             square([](auto&, auto& p) { p.mutable_square_packing()->set_y_max(0); })},
        Case{"NegativeRadius", "particles.square_packing.radius", "above 0",
             square([](auto&, auto& p) { p.mutable_square_packing()->set_radius(-1); })},
        Case{"TooLargeForItsBox", "particles.square_packing", "holds no particle; enlarge the box",
             square([](auto&, auto& p) { p.mutable_square_packing()->set_radius(3); })},
        Case{"TooMany", "particles.square_packing.radius", "enlarge it",
             square([](auto&, auto& p) { p.mutable_square_packing()->set_radius(1e-7); })},
        Case{"RandomTooMany", "particles.random_packing.radius_min", "enlarge it", random([](auto& r) {
               r.set_radius_min(1e-7);
               r.set_radius_max(2e-7);
             })},
        Case{"SizesExchanged", "particles.random_packing.radius_max",
             "is 0.01 m, expected a length of at least `radius_min` = 0.03 m",
             random([](auto& r) { r.set_radius_max(0.01); })},
        Case{"DiscsAsLargeAsTheBox", "particles.random_packing.radius_max", "at most a quarter",
             random([](auto& r) { r.set_radius_max(0.4); })},
        Case{"NoStress", "particles.random_packing.stress", "above 0",
             random([](auto& r) { r.set_stress(0); })},
        Case{"StressThatFlattens", "particles.random_packing.stress", "pressed flat; give at most",
             random([](auto& r) { r.set_stress(1e12); })},
        Case{"ImpossiblePorosity", "particles.random_packing.porosity", "choose one nearer to 0.16",
             random([](auto& r) { r.set_porosity(0.85); })},
        Case{"PorosityOfOne", "particles.random_packing.porosity", "above 0 and below 0.9",
             random([](auto& r) { r.set_porosity(1); })},
        Case{"WithinNothing", "particles.within", "selects no particles",
             square([](auto&, auto& p) { p.mutable_within()->set_x_min(9); })},
        Case{"RingOfNothing", "particles.ring", "leaves no particles",
             square([](auto&, auto& p) { set_ring(p, 30, 31); })},
        Case{"RingInsideOut", "particles.ring.outer_radius",
             "is 1 m, expected a length above `inner_radius` = 2 m",
             square([](auto&, auto& p) { set_ring(p, 2, 1); })},
        Case{"LiningThatSelectsItself", "particles.groups[0]", "are those of the ring; leave out `where`",
             square([](auto&, auto& p) {
               set_ring(p, 0.1, 1).set_within_ground(true);
               add_group(p, "lining");
             })},
        Case{"BoltBesideTheRing", "particles.ring.bolts", "within a diameter of (",
             square([](auto&, auto& p) {
               auto& bolts = *set_ring(p, 0.1, 4).mutable_bolts();
               bolts.set_length(50);
               bolts.set_stiffness(1);
             })},
        Case{"AllFloat", "particles.remove_floaters", "leaves no particles",
             square([](auto&, auto& p) { p.set_remove_floaters(true); })}),
    adit::test::kRefusalName);

INSTANTIATE_TEST_SUITE_P(
    Table, DiscErrors,
    testing::Values(
        Case{"Empty", "particles.placed.path", "is empty; give a heading", placed("\n \n")},
        Case{"HeadingOnly", "particles.placed.path", "holds no particles", placed("x_m,y_m,radius_m\n")},
        Case{"WrongHeading", "particles.placed.path", "line 1: `radius` is no column",
             placed("x_m,y_m,radius\n0,0,1\n")},
        Case{"NearHeading", "particles.placed.path", "did you mean `radius_m`?",
             placed("x_m,y_m,radiusm\n0,0,1\n")},
        Case{"NoRadius", "particles.placed.path", "line 2: the heading has no column `radius_m`",
             placed("\nx_m,y_m\n0,0\n")},
        Case{"TwiceX", "particles.placed.path", "two columns are named `x_m`",
             placed("x_m,x_m,radius_m\n0,0,1\n")},
        Case{"NoNumber", "particles.placed.path", "line 3: `1 m` is not a number",
             placed("x_m,y_m,radius_m\n0,0,1\n3,0,1 m\n")},
        Case{"NotFinite", "particles.placed.path", "line 2: `nan` is not a number",
             placed("x_m,y_m,radius_m\nnan,0,1\n")},
        Case{"RadiusBelowNothing", "particles.placed.path", "line 3: the radius is -1 m; give one above 0",
             placed("x_m,y_m,radius_m\n0,0,1\n3,0,-1\n")},
        Case{"RadiusBeyondAnyModel", "particles.placed.path",
             "line 3: the radius is 1e+300 m; give one from 1e-12 to 1e+09 m",
             placed("x_m,y_m,radius_m\n0,0,1\n3,0,1e300\n")},
        Case{"RadiusOfNothing", "particles.placed.path", "line 3: the radius is 1e-200 m",
             placed("x_m,y_m,radius_m\n0,0,1\n3,0,1e-200\n")},
        Case{"InfiniteRadius", "particles.placed.path", "line 2: `inf` is not a number",
             placed("x_m,y_m,radius_m\n0,0,inf\n")},
        Case{"PlaceBeyondAnyModel", "particles.placed.path",
             "line 2: the place is (1e+300, 0) m; give one within 1e+09 m of the origin",
             placed("x_m,y_m,radius_m\n1e300,0,1\n")},
        Case{"PointBeyondAnyModel", "particles.placed.path", "point 0: the radius is 1e+300 m; give one from",
             placed("<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1\"><PointData><DataArray "
                    "Name=\"radius_m\">1e300</DataArray></PointData><Points><DataArray>0 0 "
                    "0</DataArray></Points></Piece></PolyData></VTKFile>")},
        Case{"TooFewValues", "particles.placed.path", "line 2: has 2 values, the heading 3 columns",
             placed("x_m,y_m,radius_m\n0,0\n")},
        Case{"HalfAGroup", "particles.placed.path", "line 2: the group is 1.5; give a whole number",
             placed("x_m,y_m,radius_m,group\n0,0,1,1.5\n")},
        Case{"AtOnePoint", "particles.placed.path",
             "particles 0 and 2 (counted from 0) both lie at (1.5, 2) m",
             placed("x_m,y_m,radius_m\n1.5,2,1\n9,9,1\n1.5,2,0.5\n")},
        Case{"DeepOverlap", "particles.placed.path", "particles 0 and 1 (counted from 0) overlap by 0.3 m",
             placed("x_m,y_m,radius_m\n0,0,1\n1.2,0,0.5\n")},
        Case{"NoXml", "particles.placed.path", "is no XML", placed("<VTKFile type=\"PolyData\"><")},
        Case{"OtherXml", "particles.placed.path", "is no VTK file of type PolyData",
             placed("<VTKFile type=\"UnstructuredGrid\"/>")},
        Case{"CompressedVtp", "particles.placed.path", "compressed data, which are not read",
             placed("<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\"/>")},
        Case{"AppendedVtp", "particles.placed.path", "as `appended` data; save it as ASCII",
             placed("<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1\"><Points><DataArray "
                    "format=\"appended\"/></Points></Piece></PolyData></VTKFile>")},
        Case{"VtpWithoutRadius", "particles.placed.path", "has no point field `radius_m`",
             placed("<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1\"><Points><DataArray "
                    "format=\"ascii\">0 0 0</DataArray></Points></Piece></PolyData></VTKFile>")},
        Case{"ShortVtp", "particles.placed.path", "holds 2 values of the points, expected 3",
             placed("<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1\"><Points><DataArray "
                    "format=\"ascii\">0 0</DataArray></Points></Piece></PolyData></VTKFile>")},
        Case{"CutVtp", "particles.placed.path", "holds fewer data of the points than it says",
             placed("<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece "
                    "NumberOfPoints=\"1\"><Points>"
                    "<DataArray format=\"binary\" "
                    "type=\"Float64\">GAAAAA==</DataArray></Points></Piece></PolyData>"
                    "</VTKFile>")}),
    adit::test::kRefusalName);

INSTANTIATE_TEST_SUITE_P(
    Groups, DiscErrors,
    testing::Values(
        Case{"NoWhere", "particles.groups[0]", "give exactly one",
             square([](auto&, auto& p) { p.add_groups()->set_name("lining"); })},
        Case{"NoName", "particles.groups[0].name", "is missing; write for example",
             square([](auto&, auto& p) { add_group(p, ""); })},
        Case{"TwiceNamed", "particles.groups[1].name", "is `fault`, as that of an earlier group",
             square([](auto&, auto& p) {
               add_group(p, "fault");
               add_group(p, "fault");
             })},
        Case{"OwnName", "particles.groups[0].name", "outside all groups; choose another",
             square([](auto&, auto& p) { add_group(p, "particles"); })},
        Case{"SelectsNothing", "particles.groups[0].where", "selects no particles",
             square([](auto&, auto& p) { add_group(p, "fault").mutable_where()->set_x_min(9); })},
        Case{"NumberWithoutTable", "particles.groups[0].number", "have no column or field `group`",
             square([](auto&, auto& p) {
               auto& group = *p.add_groups();
               group.set_name("fault");
               group.set_number(1);
             })},
        Case{"NumberOfNone", "particles.groups[0].number", "is 2, which no particle has",
             [] {
               auto scene = test::placed_scene("x_m,y_m,radius_m,group\n0,0,1,1\n");
               auto& group = *scene.mutable_particles()->add_groups();
               group.set_name("fault");
               group.set_number(2);
               return scene;
             }},
        Case{"LawOfAGroup", "particles.groups[0].material", "beyond elasticity", square([](auto& s, auto& p) {
               auto& material = *add_group(p, "fault").mutable_material();
               material = s.material();
               material.mutable_mohr_coulomb()->set_cohesion(1);
             })},
        Case{"DensityOfAGroup", "particles.groups[0].material.density", "above 0",
             square([](auto& s, auto& p) {
               auto& material = *add_group(p, "fault").mutable_material();
               material = s.material();
               material.set_density(0);
             })},
        Case{"PoissonOfAGroup", "particles.groups[0].material.poisson_ratio",
             "from 0 to 0.3333 in plane stress", square([](auto& s, auto& p) {
               auto& material = *add_group(p, "fault").mutable_material();
               material = s.material();
               material.set_poisson_ratio(0.4);
             })},
        Case{"UnknownGroup", "particles.between[0].second", "`fualt` is no group", square([](auto&, auto& p) {
               add_group(p, "fault");
               add_between(p, "particles", "fualt");
             })},
        Case{"NearGroup", "particles.between[0].first", "did you mean `fault`?", square([](auto&, auto& p) {
               add_group(p, "fault");
               add_between(p, "faults", "particles");
             })},
        Case{"BetweenOne", "particles.between[0]", "names one group twice", square([](auto&, auto& p) {
               add_group(p, "fault");
               add_between(p, "fault", "fault");
             })},
        Case{"BetweenTwice", "particles.between[1]", "an earlier one names", square([](auto&, auto& p) {
               add_group(p, "fault");
               add_between(p, "fault", "particles");
               add_between(p, "particles", "fault");
             })},
        Case{"TwoKindsOfBonds", "particles.between", "`particles` and `fault`, which meet",
             square([](auto&, auto& p) {
               auto& parallel = *add_group(p, "fault").mutable_bonds()->mutable_parallel();
               parallel.set_normal_stiffness(1);
               parallel.set_shear_stiffness(1);
             })}),
    adit::test::kRefusalName);

INSTANTIATE_TEST_SUITE_P(
    Laws, DiscErrors,
    testing::Values(
        Case{"NoMaterial", "material", "is missing", square([](auto& s, auto&) { s.clear_material(); })},
        Case{"StrengthBesideCement", "particles.bonds.tensile_strength", "give the strengths there, in Pa",
             square([](auto&, auto& p) {
               p.mutable_bonds()->set_tensile_strength(1);
               p.mutable_bonds()->mutable_parallel()->set_normal_stiffness(1);
               p.mutable_bonds()->mutable_parallel()->set_shear_stiffness(1);
             })},
        Case{"SoftCement", "particles.bonds.parallel.normal_stiffness", "is 0 Pa/m, expected",
             square([](auto&, auto& p) { p.mutable_bonds()->mutable_parallel()->set_normal_stiffness(0); })},
        Case{"NegativeStrength", "particles.bonds.shear_strength", "is -1 N",
             square([](auto&, auto& p) { p.mutable_bonds()->set_shear_strength(-1); })},
        Case{"NegativeFriction", "particles.contacts.friction",
             "is -0.5, expected a pure number of at least 0",
             square([](auto&, auto& p) { p.mutable_contacts()->set_friction(-0.5); })},
        Case{"PoissonOfContacts", "material.poisson_ratio",
             "or give particles.contacts.normal_stiffness and shear", square([](auto& s, auto& p) {
               s.mutable_material()->set_poisson_ratio(0.45);
               p.mutable_contacts();
             })},
        Case{"PointlikeJoint", "particles.joints[0].to", "give a joint two ends",
             square([](auto&, auto& p) { add_joint(p, 1, 1, 1, 1).set_open(true); })},
        Case{"JointOfNothing", "particles.joints[0]", "give bonds, smooth or open: true",
             square([](auto&, auto& p) { add_joint(p, 0, 1, 4, 1); })},
        Case{"JointBeside", "particles.joints[0]", "parts no particles that are joined",
             square([](auto&, auto& p) { add_joint(p, 5, 0, 5, 2).set_open(true); })},
        Case{"JointWithoutStiffness", "particles.joints[0].smooth.shear_stiffness",
             "is missing; write for example", square([](auto&, auto& p) {
               add_joint(p, 0, 1, 4, 1).mutable_smooth()->set_normal_stiffness(1);
             })},
        Case{"SpringOnOneParticle", "particles.springs[0]", "finds at both ends the particle at (0.5, 0.5) m",
             square([](auto&, auto& p) { add_spring(p, 0, 0, 0.4, 0.4); })},
        Case{"SpringToNowhere", "particles.springs[0].to", "no particle within a diameter of (9, 0) m",
             square([](auto&, auto& p) { add_spring(p, 0, 0, 9, 0); })},
        Case{"WallWithoutLength", "particles.walls[0].to", "give a wall two ends",
             square([](auto&, auto& p) { test::set(*add_wall(p, "floor").mutable_to(), 0, 0); })},
        Case{"WallShorterThanAnyParticle", "particles.walls[0].to", "give a wall two ends",
             square([](auto&, auto& p) { test::set(*add_wall(p, "floor").mutable_to(), 1e-200, 0); })},
        Case{"WallsOfOneName", "particles.walls[1].name", "is `floor`, as that of an earlier wall",
             square([](auto&, auto& p) {
               add_wall(p, "floor");
               add_wall(p, "floor");
             })},
        Case{"WallTable", "particles.walls[0].velocity.time.table.value",
             "has 1 elements, expected 2, as many as `time`", square([](auto&, auto& p) {
               auto& table = *add_wall(p, "floor").mutable_velocity()->mutable_time()->mutable_table();
               table.add_time(1);
               table.add_time(2);
               table.add_value(1);
             })},
        Case{"QuietNowhere", "particles.quiet[0].where", "selects no particles", square([](auto&, auto& p) {
               p.add_quiet()->mutable_where()->set_x_min(9);
               p.mutable_quiet(0)->set_side(scene::QuietParticles::RIGHT);
             })},
        Case{"DampingOfOne", "particles.damping.local",
             "is 1, expected a pure number of at least 0 and below 1",
             square([](auto&, auto& p) { p.mutable_damping()->set_local(1); })},
        Case{"NegativeDamping", "particles.damping.viscous",
             "is -1 1/s, expected a frequency of at least 0 1/s",
             square([](auto&, auto& p) { p.mutable_damping()->set_viscous(-1); })}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::dem::disc_errors_test
