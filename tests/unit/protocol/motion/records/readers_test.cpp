// Requirements on the readers of records.
#include <gmock/gmock.h>

#include "protocol/motion/records/records.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kG = 9.80665;

std::string at2(const std::string& unit_line, const std::string& size_line, const std::string& values) {
  return "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/1/2000\n" + unit_line + "\n" + size_line +
         "\n" + values;
}
const std::string kUnit = "ACCELERATION TIME SERIES IN UNITS OF G";
const std::string kValues = "  .1000000E+00  -.2000000E+00\n   0.300000E-01\n";

// Every style of header that PEER has used is read to the same motion.
TEST(At2, ReadsEveryStyleOfHeader) {
  const Folder folder;
  for (const std::string size :
       {"NPTS =      3 , DT =   .020 SEC ,", "NPTS =  3, DT =   .0200 SEC,      ", "NPTS=3, DT=.02 SEC",
        "npts = 3 dt = 2e-2 sec\r", "3    0.0200    NPTS, DT", "   3   .0200   NPTS,DT"}) {
    const Motion motion = read_motion(folder.write("x.AT2", at2(kUnit, size, kValues)));
    EXPECT_EQ(motion.dt, 0.02) << size;
    EXPECT_THAT(motion.acceleration,
                ElementsAre(DoubleEq(0.1 * kG), DoubleEq(-0.2 * kG), DoubleEq(0.03 * kG)));
  }
}

// The unit is taken from the header, however PEER writes it.
TEST(At2, TakesTheUnitFromTheHeader) {
  const Folder folder;
  const auto first = [&](const std::string& unit) {
    const auto file = folder.write(
        "x.at2", at2("ACCELERATION TIME HISTORY IN UNITS OF " + unit, "NPTS= 1, DT= .01 SEC", "0.5\n"));
    return read_motion(file).acceleration.front();
  };
  EXPECT_DOUBLE_EQ(first("G"), 0.5 * kG);
  EXPECT_DOUBLE_EQ(first("G. FILTER POINTS: HP=0.1 Hz"), 0.5 * kG);
  for (const auto* unit : {"GAL", "CM/S/S", "CM/SEC/SEC", "CM/SEC^2", "CM/S**2", "cm/s^2"})
    EXPECT_DOUBLE_EQ(first(unit), 0.005) << unit;
  EXPECT_DOUBLE_EQ(first("M/S^2"), 0.5);
}

// A count that differs from the values is refused with both, and the message names file and line.
TEST(At2, RefusesAnotherCountThanStated) {
  const Folder folder;
  for (const std::string count : {"2", "4", "10102"}) {
    const auto file = folder.write("x.AT2", at2(kUnit, "NPTS = " + count + ", DT = .02 SEC", kValues));
    EXPECT_THAT(complaint([&] { read_at2(file); }),
                HasSubstr("x.AT2:4: states " + count + " points, but 3 values follow"));
  }
}

// Values that no earthquake reaches betray a wrong unit.
TEST(Readers, RefuseAnImplausibleUnit) {
  const Folder folder;
  const auto record = folder.write("x.AT2", at2(kUnit, "NPTS = 2, DT = .02 SEC", "-818.0 3.5"));
  EXPECT_THAT(complaint([&] { read_at2(record); }), HasSubstr("x.AT2:3: the largest value is 818 G, beyond"));
  const auto table = folder.write("x.csv", "time_s,acceleration_m/s^2\n0,0\n0.02,-341\n");
  EXPECT_THAT(complaint([&] { read_csv(table); }),
              HasSubstr("x.csv:1: the largest value is 341 m/s^2, beyond"));
}

// Each other error of a record is one sentence with file and line.
TEST(At2, NamesFileAndLineOfEveryError) {
  const Folder folder;
  const auto refused = [&](const std::string& text) {
    const auto file = folder.write("x.AT2", text);
    return complaint([&] { read_at2(file); });
  };
  const std::string size = "NPTS = 3, DT = .02 SEC";
  EXPECT_THAT(refused(at2("VELOCITY TIME SERIES IN UNITS OF CM/S", size, kValues)),
              HasSubstr("x.AT2:3: `CM/S` is not a unit of acceleration"));
  EXPECT_THAT(refused(at2("ACCELERATION", size, kValues)),
              HasSubstr("x.AT2:4: no line above states the unit"));
  EXPECT_THAT(refused(at2(kUnit, "3 points", kValues)), HasSubstr("states count and step"));
  EXPECT_THAT(refused(at2(kUnit, "NPTS = 0, DT = .02 SEC", kValues)), HasSubstr("x.AT2:4: NPTS is `0`"));
  EXPECT_THAT(refused(at2(kUnit, "NPTS = 2.5, DT = .02 SEC", kValues)), HasSubstr("x.AT2:4: NPTS is `2.5`"));
  EXPECT_THAT(refused(at2(kUnit, "NPTS = 3, DT = -.02 SEC", kValues)), HasSubstr("x.AT2:4: DT is `-.02`"));
  EXPECT_THAT(refused(at2(kUnit, size, "0.1 0.2\n*******\n")),
              HasSubstr("x.AT2:6: `*******` is not a number"));
  EXPECT_THAT(refused(at2(kUnit, size, "0.1 0.2 nan\n")), HasSubstr("x.AT2:5: `nan` is not a number"));
  EXPECT_THAT(refused(""), HasSubstr("states count and step"));
  EXPECT_THAT(refused(std::string(1000000, '\x01')), HasSubstr("states count and step"));
  EXPECT_THAT(complaint([&] { read_at2("/nowhere/x.AT2"); }), HasSubstr("/nowhere/x.AT2: cannot be read"));
  EXPECT_THAT(complaint([&] { read_motion("/nowhere/x.txt"); }),
              HasSubstr("ends neither in .AT2 nor in .csv"));
}

// Two columns are read in the units their names state, in the project's own way of naming and with brackets.
TEST(Csv, ReadsTwoColumnsInTheirUnits) {
  const Folder folder;
  for (const std::string names : {"time_ms,acceleration_g", "t [ms] , a [g]", "t (ms),a (G)"}) {
    const Motion motion =
        read_motion(folder.write("x.csv", "# measured\n\n" + names + "\n0,0\n10,0.5\r\n20, -1e-1\n"));
    EXPECT_DOUBLE_EQ(motion.dt, 0.01);
    EXPECT_THAT(motion.acceleration, ElementsAre(0, DoubleEq(0.5 * kG), DoubleEq(-0.1 * kG)));
  }
}

// Each error of a table is one sentence with file and line.
TEST(Csv, NamesFileAndLineOfEveryError) {
  const Folder folder;
  const auto refused = [&](const std::string& text) {
    const auto file = folder.write("x.csv", text);
    return complaint([&] { read_csv(file); });
  };
  EXPECT_THAT(refused("time,acceleration_g\n0,0\n"), HasSubstr("x.csv:1: `time` states no unit"));
  EXPECT_THAT(refused("time_s,acceleration_kN\n0,0\n"),
              HasSubstr("x.csv:1: `kN` is not a unit of acceleration"));
  EXPECT_THAT(refused("time_m,acceleration_g\n0,0\n"), HasSubstr("x.csv:1: `m` is not a unit of time"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n0.1,1,2\n"), HasSubstr("x.csv:3: `0.1,1,2` is not two columns"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n0.1,x\n"), HasSubstr("x.csv:3: `x` is not a number"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n0.1,0\n0.3,0\n"),
              HasSubstr("x.csv:3: is 0.1 s after the row before"));
  EXPECT_THAT(refused("time_s,a_g\n1,0\n0,0\n"), HasSubstr("x.csv:3: the last time, 0 s, is not after"));
  EXPECT_THAT(refused("time_s,a_g\n1,0\n1,0\n"), HasSubstr("x.csv:3: the last time, 1 s, is not after"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n"), HasSubstr("x.csv:2: has 1 rows"));
  EXPECT_THAT(refused("# nothing\n"), HasSubstr("x.csv:1: holds no motion"));
}

}  // namespace
}  // namespace adit::motion::test
