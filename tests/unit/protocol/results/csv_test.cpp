#include "protocol/results/csv.hpp"

#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>

#include "tests/unit/protocol/results/results_fixture.hpp"

namespace adit::results::csv_test {
namespace {

const std::vector<std::string> kColumns{"time_s", "tip_uy_m"};

// A number read back from a table has the bits that the run computed.
TEST(Csv, NumbersReadBackToTheBit) {
  const ScratchFolder folder;
  CsvFile file(folder / "a.csv", kColumns);
  std::mt19937_64 random(7);
  std::vector<double> written{0.1, -0.0, 5e-324, std::numeric_limits<double>::max(), 1.0 / 3.0, -1e22};
  while (written.size() < 2000) {
    const double value = std::bit_cast<double>(random());
    if (value - value == 0.0) written.push_back(value);
  }
  for (std::size_t i = 0; i < written.size(); i += 2) file.row(std::span(written).subspan(i, 2));

  std::istringstream text(content_of(folder / "a.csv"));
  std::string token;
  std::getline(text, token);
  EXPECT_EQ(token, "time_s,tip_uy_m");
  for (std::size_t i = 0; i < written.size(); ++i) {
    std::getline(text, token, i % 2 == 0 ? ',' : '\n');
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(token.c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(written[i]));
  }
}

TEST(Csv, NumbersAreShort) {
  const ScratchFolder folder;
  CsvFile file(folder / "a.csv", kColumns);
  file.row(std::array{0.028, 1e-300});
  EXPECT_EQ(content_of(folder / "a.csv"), "time_s,tip_uy_m\n0.028,1e-300\n");
}

// A killed run keeps its rows: each is in the file as soon as it is written, with the file still open.
TEST(Csv, RowsAreInTheFileAtOnce) {
  const ScratchFolder folder;
  CsvFile file(folder / "a.csv", kColumns);
  EXPECT_EQ(content_of(folder / "a.csv"), "time_s,tip_uy_m\n");
  file.row(std::array{1.0, 2.5});
  EXPECT_EQ(content_of(folder / "a.csv"), "time_s,tip_uy_m\n1,2.5\n");
}

// Users name histories: a comma or a quote in a name does not shift the columns.
TEST(Csv, QuotesTextThatCsvWouldMisread) {
  const ScratchFolder folder;
  const std::vector<std::string> columns{"a,b", "say \"x\"", "plain"};
  const CsvFile file(folder / "a.csv", columns);
  EXPECT_EQ(content_of(folder / "a.csv"), "\"a,b\",\"say \"\"x\"\"\",plain\n");
}

TEST(Csv, RefusesARowThatDoesNotFitTheColumns) {
  const ScratchFolder folder;
  CsvFile file(folder / "a.csv", kColumns);
  EXPECT_THROW(file.row(std::array{1.0}), std::logic_error);
}

TEST(Csv, NamesTheFileThatItCannotWrite) {
  const ScratchFolder folder;
  try {
    const CsvFile file(folder / "absent/a.csv", kColumns);
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("absent/a.csv: No such file"));
  }
}

// A full disk is reported, not passed over: /dev/full refuses every write.
TEST(Csv, ReportsAFullDisk) {
  try {
    const CsvFile file("/dev/full", kColumns);
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("No space left"));
  }
}

// cracks.csv holds the whole crack record: time, mode, place, length, orientation, both parents, their group,
// the stage of excavation, and the region where there are several.
TEST(Csv, CrackRowHoldsTheWholeRecord) {
  const ScratchFolder folder;
  CsvFile file(folder / "cracks.csv", crack_columns()), regions(folder / "regions.csv", crack_columns(true));
  wire::Crack crack;
  crack.set_step(2980);
  crack.set_mode(wire::Crack::SHEAR);
  crack.set_x(9.875);
  crack.set_y(0.25);
  crack.set_length(0.125);
  crack.set_orientation(-0.5);
  crack.set_parent_a(696);
  crack.set_parent_b(0xffffffffffffffffU);
  crack.set_group("particles-lining");
  crack.set_stage(2);
  write_crack(file, 0.0298, crack);
  write_crack(regions, 0.0298, crack, "cavern");
  crack.set_mode(wire::Crack::TENSILE);
  write_crack(file, 0.0299, crack);
  EXPECT_EQ(content_of(folder / "cracks.csv"),
            "time_s,step,mode,x_m,y_m,length_m,orientation_rad,parent_a,parent_b,group,stage\n"
            "0.0298,2980,shear,9.875,0.25,0.125,-0.5,696,18446744073709551615,particles-lining,2\n"
            "0.0299,2980,tensile,9.875,0.25,0.125,-0.5,696,18446744073709551615,particles-lining,2\n");
  EXPECT_EQ(content_of(folder / "regions.csv"),
            "time_s,step,mode,x_m,y_m,length_m,orientation_rad,parent_a,parent_b,group,stage,region\n"
            "0.0298,2980,shear,9.875,0.25,0.125,-0.5,696,18446744073709551615,particles-lining,2,cavern\n");
}

// crack_paths.csv holds the whole record of a path.
TEST(Csv, CrackPathRowHoldsTheWholeRecord) {
  const ScratchFolder folder;
  CsvFile file(folder / "a.csv", crack_path_columns()), regions(folder / "b.csv", crack_path_columns(true));
  wire::CrackPath path;
  path.set_cracks(12);
  path.set_mode(wire::Crack::SHEAR);
  path.set_length(1.5);
  path.set_opening(0.001);
  path.set_slip(0.002);
  path.set_x(-3.25);
  path.set_y(8);
  write_crack_path(file, 1, path);
  write_crack_path(regions, 2, path, "cavern");
  const std::string columns = "path,cracks,mode,length_m,opening_m,slip_m,x_m,y_m";
  EXPECT_EQ(content_of(folder / "a.csv"), columns + "\n1,12,shear,1.5,0.001,0.002,-3.25,8\n");
  EXPECT_EQ(content_of(folder / "b.csv"), columns + ",region\n2,12,shear,1.5,0.001,0.002,-3.25,8,cavern\n");
}

}  // namespace
}  // namespace adit::results::csv_test
