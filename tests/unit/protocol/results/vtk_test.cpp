#include "protocol/results/vtk.hpp"

#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <cstdio>
#include <functional>
#include <iomanip>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>

#include "tests/unit/protocol/results/results_fixture.hpp"

namespace adit::results::vtk_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// What VTK, another program, reads from the file: one line of text a point array, field and cell.
std::string read_by_vtk(const std::filesystem::path& path) {
  const std::string command = std::string(ADIT_READ_BACK) + " " + path.string() + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start " + command);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  if (pclose(pipe) != 0) throw std::runtime_error(command + " failed:\n" + text);
  return text;
}

void add_bits(std::ostringstream& out, double value) {
  out << ' ' << std::hex << std::setw(16) << std::setfill('0') << std::bit_cast<std::uint64_t>(value)
      << std::dec;
}

// The line that read_back.py prints for values of `components` each; two components have a zero third.
void add_line(std::ostringstream& out, const std::string& label, std::uint32_t components,
              const google::protobuf::RepeatedField<double>& values) {
  out << label << ' ' << (components == 2 ? 3 : components);
  for (int i = 0; i < values.size(); ++i) {
    add_bits(out, values[i]);
    if (components == 2 && i % 2 == 1) add_bits(out, 0.0);
  }
  out << '\n';
}

std::string expected_of(const wire::Piece& piece, int vtk_cell, int points_per_cell) {
  std::ostringstream out;
  add_line(out, "points", 2, piece.points());
  for (const auto& f : piece.point_fields())
    add_line(out, "point_field " + f.name(), f.components(), f.values());
  for (const auto& f : piece.cell_fields())
    add_line(out, "cell_field " + f.name(), f.components(), f.values());
  for (int i = 0; i < piece.connectivity_size(); ++i) {
    if (i % points_per_cell == 0) out << (i > 0 ? "\n" : "") << "cell " << vtk_cell;
    out << ' ' << piece.connectivity(i);
  }
  out << '\n';
  return out.str();
}

// Random bits over the whole range of doubles, among them the values that text formats lose.
class Values {
 public:
  double next() {
    constexpr std::array<double, 7> special{0.0, -0.0, kInf, -kInf, kNan, 5e-324, 0.1};
    if (count_++ % 5 == 0) return special[count_ / 5 % special.size()];
    const double value = std::bit_cast<double>(random_());
    return value == value ? value : 1.0;
  }

 private:
  std::mt19937_64 random_{20260101};
  std::size_t count_ = 0;
};

void add_field(google::protobuf::RepeatedPtrField<wire::Field>& fields, const std::string& name,
               std::uint32_t components, std::size_t count, Values& values) {
  wire::Field& field = *fields.Add();
  field.set_name(name);
  field.set_components(components);
  for (std::size_t i = 0; i < components * count; ++i) field.add_values(values.next());
}

wire::Piece make_piece(wire::Piece::Shape shape, std::uint32_t points_per_cell, std::uint32_t points,
                       std::uint32_t cells) {
  Values values;
  wire::Piece piece;
  piece.set_name("some-piece_1");
  piece.set_shape(shape);
  for (std::uint32_t i = 0; i < 2 * points; ++i) piece.add_points(0.1 * i - 1.0 / 3.0);
  for (std::uint32_t i = 0; i < points_per_cell * cells; ++i) piece.add_connectivity((7 * i + 3) % points);
  add_field(*piece.mutable_point_fields(), "velocity_m_per_s", 2, points, values);
  add_field(*piece.mutable_point_fields(), "radius_m", 1, points, values);
  add_field(*piece.mutable_cell_fields(), "stress_Pa", 3, cells, values);
  add_field(*piece.mutable_cell_fields(), "weight", 1, cells, values);
  return piece;
}

wire::Piece make_polygons() {
  wire::Piece piece = make_piece(wire::Piece::POLYGONS, 4, 23, 12);
  for (std::uint32_t i = 0; i < 12; ++i) piece.add_corners(3 + i % 3);
  return piece;
}

TEST(Vtk, ReadsBackZonesToTheBit) {
  const ScratchFolder folder;
  const wire::Piece piece = make_piece(wire::Piece::QUADS, 4, 23, 11);
  write_piece(folder / "a.vtu", piece);
  EXPECT_EQ(read_by_vtk(folder / "a.vtu"), expected_of(piece, 9, 4));
}

TEST(Vtk, ReadsBackParticlesToTheBit) {
  const ScratchFolder folder;
  const wire::Piece piece = make_piece(wire::Piece::VERTICES, 1, 17, 17);
  write_piece(folder / "a.vtp", piece);
  EXPECT_EQ(read_by_vtk(folder / "a.vtp"), expected_of(piece, 1, 1));
}

TEST(Vtk, ReadsBackBondsToTheBit) {
  const ScratchFolder folder;
  const wire::Piece piece = make_piece(wire::Piece::LINES, 2, 19, 30);
  write_piece(folder / "a.vtp", piece);
  EXPECT_EQ(read_by_vtk(folder / "a.vtp"), expected_of(piece, 3, 2));
}

// Of 3, 4, 5, 3 … corners, which VTK tells as triangles, quads and polygons.
TEST(Vtk, ReadsBackCellsToTheBit) {
  const ScratchFolder folder;
  wire::Piece piece = make_polygons();
  write_piece(folder / "a.vtp", piece);
  std::ostringstream cells;
  int next = 0;
  for (const std::uint32_t corners : piece.corners()) {
    cells << "cell " << (corners == 3 ? 5 : corners == 4 ? 9 : 7);
    for (std::uint32_t k = 0; k < corners; ++k) cells << ' ' << piece.connectivity(next++);
    cells << '\n';
  }
  piece.clear_connectivity();  // the cells are told here
  std::string expected = expected_of(piece, 7, 1);
  expected.pop_back();
  EXPECT_EQ(read_by_vtk(folder / "a.vtp"), expected + cells.str());
}

// A particle region whose bonds have all vanished still gives a file that a viewer opens.
TEST(Vtk, ReadsAPieceWithoutCells) {
  const ScratchFolder folder;
  wire::Piece piece = make_piece(wire::Piece::LINES, 2, 4, 0);
  write_piece(folder / "a.vtp", piece);
  EXPECT_THAT(read_by_vtk(folder / "a.vtp"), ::testing::StartsWith("points 3 "));
}

// One PVD leads a viewer to all pieces of both participants at every time.
TEST(Vtk, CollectionNamesEveryPieceOfEveryTime) {
  const ScratchFolder folder;
  Collection collection(folder / "fields");
  wire::Snapshot continuum;
  *continuum.add_pieces() = make_piece(wire::Piece::QUADS, 4, 23, 11);
  continuum.mutable_pieces(0)->set_name("grid");
  wire::Snapshot particles;
  *particles.add_pieces() = make_piece(wire::Piece::VERTICES, 1, 17, 17);
  particles.mutable_pieces(0)->set_name("particles");
  for (const std::uint64_t step : {7, 1200}) {
    write_snapshot(step, 1e-3 * static_cast<double>(step), continuum, collection);
    write_snapshot(step, 1e-3 * static_cast<double>(step), particles, collection);
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "fields/grid_00000007.vtu"));
  EXPECT_TRUE(std::filesystem::exists(folder / "fields/particles_00001200.vtp"));
  EXPECT_EQ(read_by_vtk(folder / "fields/fields.pvd"),
            "time 0.007 part 0 grid 11 cells\ntime 0.007 part 1 particles 17 cells\n"
            "time 1.2 part 0 grid 11 cells\ntime 1.2 part 1 particles 17 cells\n");
}

// A run killed after any snapshot leaves a PVD that names only whole files.
TEST(Vtk, CollectionIsReadableAfterEverySnapshot) {
  const ScratchFolder folder;
  Collection collection(folder / "fields");
  wire::Snapshot snapshot;
  *snapshot.add_pieces() = make_piece(wire::Piece::VERTICES, 1, 5, 5);
  write_snapshot(0, 0.0, snapshot, collection);
  EXPECT_EQ(read_by_vtk(folder / "fields/fields.pvd"), "time 0 part 0 some-piece_1 5 cells\n");
  for (const auto& entry : std::filesystem::directory_iterator(folder / "fields")) {
    EXPECT_NE(entry.path().extension(), ".part");
  }
}

// Two pieces of one name in one snapshot would overwrite each other's file.
TEST(Vtk, RefusesTwoPiecesOfOneName) {
  const ScratchFolder folder;
  Collection collection(folder / "fields");
  wire::Snapshot snapshot;
  *snapshot.add_pieces() = make_piece(wire::Piece::VERTICES, 1, 5, 5);
  *snapshot.add_pieces() = make_piece(wire::Piece::VERTICES, 1, 5, 5);
  EXPECT_THROW(write_snapshot(0, 0.0, snapshot, collection), std::runtime_error);
}

struct Malformed {
  const char* name;
  std::function<void(wire::Piece&)> spoil;
  const char* message;
};

void PrintTo(const Malformed& malformed, std::ostream* out) {
  *out << malformed.name;
}

class MalformedPiece : public ::testing::TestWithParam<Malformed> {};

// Whatever another program sends, the answer is a sentence that names the fault, and no file.
TEST_P(MalformedPiece, IsRefusedWithItsReason) {
  const ScratchFolder folder;
  wire::Piece piece = make_piece(wire::Piece::QUADS, 4, 23, 11);
  GetParam().spoil(piece);
  try {
    write_piece(folder / "a.vtu", piece);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(GetParam().message));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a.vtu"));
}

class MalformedPolygons : public ::testing::TestWithParam<Malformed> {};

TEST_P(MalformedPolygons, AreRefusedWithTheirReason) {
  wire::Piece piece = make_polygons();
  ASSERT_EQ(wrong_with(piece), std::nullopt);
  GetParam().spoil(piece);
  EXPECT_THAT(wrong_with(piece).value_or("accepted"), ::testing::HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Vtk, MalformedPolygons,
    ::testing::Values(Malformed{"TwoCorners", [](wire::Piece& p) { p.set_corners(0, 2); },
                                "a polygon has 2 corners, expected 3 at least"},
                      Malformed{"OneMore", [](wire::Piece& p) { p.set_corners(0, 4); },
                                "48 point numbers, but its polygons have 49 corners"},
                      Malformed{"SumThatOverflows",
                                [](wire::Piece& p) {
                                  p.add_corners(0x80000000U);
                                  p.add_corners(0x80000000U);
                                },
                                "but its polygons have 4294967344 corners"},
                      Malformed{
                          "ShortCellField",
                          [](wire::Piece& p) { p.mutable_cell_fields(1)->mutable_values()->RemoveLast(); },
                          "weight has 11 values, expected 1 for each of 12 cells"}),
    [](const auto& info) { return std::string(info.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Vtk, MalformedPiece,
    ::testing::Values(
        Malformed{"OddPoints", [](wire::Piece& p) { p.add_points(1.0); }, "not pairs of x and y"},
        Malformed{"ShortConnectivity", [](wire::Piece& p) { p.add_connectivity(0); },
                  "45 point numbers, expected 4"},
        Malformed{"PointBeyondTheLast", [](wire::Piece& p) { p.set_connectivity(5, 23); },
                  "names point 23, but there are 23"},
        Malformed{"ShortPointField",
                  [](wire::Piece& p) { p.mutable_point_fields(0)->mutable_values()->RemoveLast(); },
                  "velocity_m_per_s has 45 values, expected 2 for each of 23 points"},
        Malformed{"LongCellField", [](wire::Piece& p) { p.mutable_cell_fields(1)->add_values(0.0); },
                  "weight has 12 values, expected 1 for each of 11 cells"},
        Malformed{"NoComponents", [](wire::Piece& p) { p.mutable_cell_fields(0)->set_components(0); },
                  "expected 0"},
        Malformed{"ComponentsThatOverflow",
                  [](wire::Piece& p) { p.mutable_cell_fields(0)->set_components(0xffffffffU); },
                  "4294967295"},
        Malformed{"UnknownShape", [](wire::Piece& p) { p.set_shape(static_cast<wire::Piece::Shape>(9)); },
                  "shape"},
        Malformed{"NameThatLeavesTheFolder", [](wire::Piece& p) { p.set_name("../../etc/grid"); }, "name"},
        Malformed{"NoName", [](wire::Piece& p) { p.clear_name(); }, "name"},
        Malformed{"FieldNameThatBreaksXml",
                  [](wire::Piece& p) { p.mutable_point_fields(0)->set_name("a\"/>"); }, "name"},
        Malformed{"FieldTwice", [](wire::Piece& p) { *p.add_cell_fields() = p.cell_fields(0); },
                  "two fields are named stress_Pa"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace adit::results::vtk_test
