// Requirements on the readers of records.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <utility>

#include "protocol/motion/records/records.hpp"
#include "tests/support/read_motion.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::readers_test {
namespace {

using adit::test::read_motion;
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

// Requirement: no message shows more than 40 characters of a file, whatever the line that a reader stumbles
// over.
TEST(Records, AreNeverQuotedByTheLine) {
  std::string secret;
  for (int i = 0; i < 60; ++i) secret += fmt::format("s{:03d}", i);
  const auto table = [&](const std::string& names) { return names + "," + secret + "\n0,1,2\n0.5,1,2\n"; };
  using Case = std::pair<std::string, RecordKeys>;
  for (const auto& [content, keys] :
       {Case{secret, {}}, Case{secret + "\n" + secret, {}}, Case{"time_s,a_gal\n0," + secret, {}},
        Case{table("time_s,a_gal"), {.column = "up"}},
        Case{secret + "_gal," + secret + "_g\n1,2\n", {.time_step = 0.1}},
        Case{at2(kUnit, "NPTS= 1, DT= " + secret + " SEC", "1\n"), {}},
        Case{at2(kUnit, "NPTS= 1, DT= .01 SEC", secret), {}},
        Case{at2(secret, "NPTS= 1, DT= .01 SEC", "1"), {}}}) {
    const std::string message = complaint([&] { parse_motion("x", content, keys); });
    EXPECT_NE(message, "") << content;
    for (std::size_t i = 0; i + 41 <= secret.size(); ++i)
      ASSERT_EQ(message.find(secret.substr(i, 41)), std::string::npos) << message;
  }
}

// Every style of header that PEER has used is read to the same motion.
TEST(At2, ReadsEveryStyleOfHeader) {
  const Folder folder;
  for (const std::string size :
       {"NPTS =      3 , DT =   .020 SEC ,", "NPTS =  3, DT =   .0200 SEC,      ", "NPTS=3, DT=.02 SEC",
        "npts = 3 dt = 2e-2 sec\r", "3    0.0200    NPTS, DT", "   3   .0200   NPTS,DT", "DT= .02, NPTS= 3",
        "DT= .02 SECONDS, NPTS= 3", "NPTS= 3, DT= 20.0 MSEC", "3 20. NPTS, DT (MS)", ".02 3 DT, NPTS",
        "NPTS: 3 DT: 2.0D-02"}) {
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
  EXPECT_DOUBLE_EQ(first("(G)"), 0.5 * kG);
  for (const auto* unit : {"GAL", "GALS", "(gal)", "CM/S/S", "CM/SEC/SEC", "CM/SEC^2", "CM/S**2", "cm/s^2",
                           "CM/S2", "CM/SEC2", "cm/sec**2"})
    EXPECT_DOUBLE_EQ(first(unit), 0.005) << unit;
  EXPECT_DOUBLE_EQ(first("M/S^2"), 0.5);
}

// A count that differs from the values is refused with both, and the message names file and line.
TEST(At2, RefusesAnotherCountThanStated) {
  const Folder folder;
  for (const std::string count : {"2", "4", "10102"}) {
    const auto file = folder.write("x.AT2", at2(kUnit, "NPTS = " + count + ", DT = .02 SEC", kValues));
    EXPECT_THAT(complaint([&] { read_motion(file); }),
                HasSubstr("x.AT2:4: states " + count + " points, but 3 values follow"));
  }
}

// Values that no earthquake reaches betray a wrong unit.
TEST(Readers, RefuseAnImplausibleUnit) {
  const Folder folder;
  const auto record = folder.write("x.AT2", at2(kUnit, "NPTS = 2, DT = .02 SEC", "-818.0 3.5"));
  EXPECT_THAT(complaint([&] { read_motion(record); }),
              HasSubstr("x.AT2:3: the largest value is 818 G, beyond"));
  const auto table = folder.write("x.csv", "time_s,acceleration_m/s^2\n0,0\n0.02,-341\n");
  EXPECT_THAT(complaint([&] { read_motion(table); }),
              HasSubstr("x.csv:1: the largest value is 341 m/s^2, beyond"));
}

// Each other error of a record is one sentence with file and line.
TEST(At2, NamesFileAndLineOfEveryError) {
  const Folder folder;
  const auto refused = [&](const std::string& text) {
    const auto file = folder.write("x.AT2", text);
    return complaint([&] { read_motion(file); });
  };
  const std::string size = "NPTS = 3, DT = .02 SEC";
  EXPECT_THAT(
      refused(at2("VELOCITY TIME SERIES IN UNITS OF CM/S", size, kValues)),
      HasSubstr("x.AT2:3: `CM/S` is not a unit of acceleration; give the record of the acceleration"));
  EXPECT_THAT(refused(at2(kUnit, "NPTS = 3, DT = .02 FOO", kValues)),
              HasSubstr("x.AT2:4: `FOO` is not a unit of time"));
  EXPECT_THAT(
      refused(at2(kUnit, "NPTS = 3, DT = .02 SEC", "0.1234 0.567812.3456")),
      HasSubstr("x.AT2:5: `0.567812.3456` is several numbers without a blank between them; separate them"));
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
}

// Two columns are read in the units their names state, in the project's own way of naming and with brackets.
TEST(Csv, ReadsTwoColumnsInTheirUnits) {
  const Folder folder;
  for (const std::string names : {"time_ms,acceleration_g", "t [ms] , a [g]", "t (ms),a (G)",
                                  "Time (msec),A (g)", "\"time_ms\",\"acceleration_g\""}) {
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
    return complaint([&] { read_motion(file); });
  };
  EXPECT_THAT(refused("time,acceleration_g\n0,0\n"), HasSubstr("x.csv:1: `time` states no unit"));
  EXPECT_THAT(refused("time_s,acceleration_kN\n0,0\n"),
              HasSubstr("x.csv:1: `kN` is not a unit of acceleration"));
  EXPECT_THAT(refused("time_m,acceleration_g\n0,0\n"), HasSubstr("x.csv:1: `m` is not a unit of time"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n0.1,1,2\n"),
              HasSubstr("x.csv:3: has 3 values, but there are 2 columns"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n0.1,nan\n"), HasSubstr("x.csv:3: `nan` is not a number"));
  EXPECT_THAT(refused("time_s,a_g\n5,0\n5.1,0\n"),
              HasSubstr("x.csv:2: the first time is 5 s; let the times begin at 0 s"));
  EXPECT_THAT(refused("0,0\n0.1,0\n"),
              HasSubstr("x.csv:1: has no line of names above; begin with one such as"));
  EXPECT_THAT(
      refused("time_s,x_g,y_g\n0,0,0\n1,0,0\n"),
      HasSubstr("x.csv:1: has 2 columns of acceleration; give the name of one as `column`, such as `x_g`"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n0.1,x\n"), HasSubstr("x.csv:3: `x` is not a number"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n0.1,0\n0.3,0\n"),
              HasSubstr("x.csv:3: is 0.1 s after the row before"));
  EXPECT_THAT(refused("time_s,a_g\n1,0\n0,0\n"), HasSubstr("x.csv:3: the last time, 0 s, is not after"));
  EXPECT_THAT(refused("time_s,a_g\n1,0\n1,0\n"), HasSubstr("x.csv:3: the last time, 1 s, is not after"));
  EXPECT_THAT(refused("time_s,a_g\n0,0\n"), HasSubstr("x.csv:2: has 1 rows"));
  EXPECT_THAT(refused("# nothing\n"), HasSubstr("x.csv:1: holds no motion"));
}

// A Fortran program leaves no blank before a sign, writes exponents with D, and DOS ends a file by a mark.
TEST(At2, ReadsWhatFortranWrites) {
  const Folder folder;
  const auto file =
      folder.write("x.AT2", at2(kUnit, "NPTS = 4, DT = .02 SEC", "0.1000-0.2000+3.0D-02\n 1.0d-1\n\x1a\n"));
  EXPECT_THAT(read_motion(file).acceleration,
              ElementsAre(DoubleEq(0.1 * kG), DoubleEq(-0.2 * kG), DoubleEq(0.03 * kG), DoubleEq(0.1 * kG)));
}

// A table of several columns gives the one that is named, with or without its unit, and any separator.
TEST(Csv, ReadsTheNamedColumn) {
  for (const auto& [separator, names] : {std::pair{',', "time_s,ns_gal,ew_gal"},
                                         {';', "Time (s);ns (gal);ew (gal)"},
                                         {'\t', "Time (s)\tns (gal)\tew (gal)"},
                                         {' ', "time_s ns_gal ew_gal"}}) {
    std::string rows = "\n0,1,2\n0.5,-3,4\n";
    std::ranges::replace(rows, ',', separator);
    const std::string text = names + rows;
    EXPECT_THAT(parse_motion("x.csv", text, {.column = "ew"}).acceleration,
                ElementsAre(DoubleEq(0.02), DoubleEq(0.04)));
    EXPECT_THAT(parse_motion("x.csv", text, {.column = "NS"}).acceleration,
                ElementsAre(DoubleEq(0.01), DoubleEq(-0.03)));
    EXPECT_EQ(parse_motion("x.csv", text, {.column = "ew"}).dt, 0.5);
    EXPECT_THAT(complaint([&] { parse_motion("x.csv", text, {.column = "up"}); }),
                HasSubstr("x.csv:1: has no column `up`; its columns are "));
  }
}

// The tables that a run writes of its motions are records.
TEST(Csv, ReadsTheMotionsOfARun) {
  const std::string text =
      "time_s,acceleration_m_per_s2,velocity_m_per_s,displacement_m,arias_share\n0,0,0,0,0\n0.01,0.5,0.0025,"
      "0,1\n";
  const Motion motion = parse_motion("crown_ax_motion.csv", text);
  EXPECT_EQ(motion.dt, 0.01);
  EXPECT_THAT(motion.acceleration, ElementsAre(0, 0.5));
}

// A column whose name has no unit, and values without any name, are read as the scene states.
TEST(Csv, ReadsValuesOfTheStatedStepAndUnit) {
  for (const std::string text : {"1\n-2\n3\n", "1 -2 3\n", "a\n1\n-2\n3\n", "# x\n1.0D0 -2.0 3.0\n"}) {
    const Motion motion = parse_motion("x.txt", text, {.time_step = 0.005, .unit = "gal"});
    EXPECT_EQ(motion.dt, 0.005);
    EXPECT_THAT(motion.acceleration, ElementsAre(DoubleEq(0.01), DoubleEq(-0.02), DoubleEq(0.03)));
  }
  EXPECT_THAT(complaint([] { parse_motion("x.txt", "1\n2\n", {.unit = "gal"}); }),
              HasSubstr("state `time_step` and `unit`"));
  EXPECT_THAT(complaint([] { parse_motion("x.txt", "0 1\n1 2\n", {.time_step = 1, .unit = "gal"}); }),
              HasSubstr("x.txt:1: has several columns"));
  EXPECT_THAT(
      complaint([] { parse_motion("x.AT2", at2(kUnit, "NPTS= 3, DT= .01 SEC", kValues), {.unit = "gal"}); }),
      HasSubstr("x.AT2:1: states step and unit of its values; leave out"));
}

std::string knet(const std::string& scale, const std::string& duration, const std::string& values) {
  return "Origin Time       2000/01/01 00:00:00\nLat.              35.0\nLong.             135.0\n"
         "Depth. (km)       10\nMag.              5.0\nStation Code      XXX001\nStation Lat.      35.1\n"
         "Station Long.     135.1\nStation Height(m) 10\nRecord Time       2000/01/01 00:00:15\n"
         "Sampling Freq(Hz) 100Hz\nDuration Time(s)  " +
         duration + "\nDir.              N-S\nScale Factor      " + scale +
         "\nMax. Acc. (gal)   1.0\nLast Correction   2000/01/01 00:00:15\nMemo.             \n" + values;
}

// Counts of K-NET are gal by the scale factor, about their mean.
TEST(Knet, IsReadInItsScale) {
  const Motion motion =
      parse_motion("XXX.NS", knet("2000(gal)/8000000", "0.04", "  1000  1200\n   600  1200\n"));
  EXPECT_EQ(motion.dt, 0.01);
  EXPECT_THAT(motion.acceleration,
              ElementsAre(DoubleEq(0), DoubleEq(0.0005), DoubleEq(-0.001), DoubleEq(0.0005)));
  EXPECT_THAT(complaint([] { parse_motion("XXX.NS", knet("2000(gal)/8000000", "300", "1 2 3\n")); }),
              HasSubstr("XXX.NS:12: states 30000 values, but 3 follow"));
  EXPECT_THAT(complaint([] { parse_motion("XXX.NS", knet("2000(gal)/0", "0.03", "1 2 3\n")); }),
              HasSubstr("XXX.NS:14: `0` is not a number above 0"));
  EXPECT_THAT(complaint([] { parse_motion("XXX.NS", knet("2000(kine)/800", "0.03", "1 2 3\n")); }),
              HasSubstr("XXX.NS:14: `kine` is not a unit"));
}

std::string esm(const std::string& unit, const std::string& count) {
  return "EVENT_NAME: none\nSAMPLING_INTERVAL_S: 0.005\nNDATA: " + count +
         "\nDATA_TYPE: ACCELERATION\nUNITS: " + unit + "\nUSER5: \n1.5\n-2.5\n3.5\n";
}

TEST(Esm, IsReadByItsHeader) {
  const Motion motion = parse_motion("x.ASC", esm("cm/s^2", "3"));
  EXPECT_EQ(motion.dt, 0.005);
  EXPECT_THAT(motion.acceleration, ElementsAre(DoubleEq(0.015), DoubleEq(-0.025), DoubleEq(0.035)));
  EXPECT_THAT(
      complaint([] { parse_motion("x.ASC", esm("cm/s", "3")); }),
      HasSubstr("x.ASC:5: `cm/s` is not a unit of acceleration; give the record of the acceleration"));
  EXPECT_THAT(complaint([] { parse_motion("x.ASC", esm("cm/s^2", "4")); }),
              HasSubstr("x.ASC:3: states 4 values, but 3 follow"));
}

// CSMIP states the step beside the count; values fill their width.
TEST(Cosmos, ReadsTheBlocksOfCsmip) {
  const std::string channel =
      "    5 points of accel data equally spaced at  .020 sec, in cm/sec2. (4f8.3)\n"
      "   1.500-999.500   3.250   4.000\n   5.000\n"
      "    5 points of veloc data equally spaced at  .020 sec, in cm/sec.  (4f8.3)\n"
      "   7.000   7.000   7.000   7.000\n   7.000\n/&\n";
  const Motion motion = parse_motion("x.V2", "Corrected accelerogram\n" + channel);
  EXPECT_EQ(motion.dt, 0.02);
  EXPECT_THAT(motion.acceleration, ElementsAre(DoubleEq(0.015), DoubleEq(-9.995), DoubleEq(0.0325),
                                               DoubleEq(0.04), DoubleEq(0.05)));
  EXPECT_THAT(
      complaint([&] { parse_motion("x.V2", channel + channel); }),
      HasSubstr("x.V2:1: is the first of 2 channels of acceleration; give the number of one as `column`"));
  EXPECT_EQ(parse_motion("x.V2", channel + channel, {.column = "2"}).acceleration.size(), 5U);
}

// COSMOS states the step in the real header: entry 34 in seconds, or entry 62 in milliseconds.
TEST(Cosmos, TakesTheStepFromTheRealHeader) {
  const auto file = [](double seconds, double milliseconds, const std::string& unit,
                       const std::string& count) {
    std::string text =
        "Corrected acceleration\n 100 Real-header values follow on  10 lines, Format= (10F10.3)\n";
    for (int i = 1; i <= 100; ++i) {
      const double value = i == 34 ? seconds : i == 62 ? milliseconds : -999;
      text += fmt::format("{:10.3f}{}", value, i % 10 == 0 ? "\n" : "");
    }
    return text + "   0 Comment line(s) follow, each starting with a \"|\":\n" + count +
           " acceleration pts, approx  1 secs, units=" + unit +
           ",Format=(2E12.4)\n  1.0000E+00 -2.0000E+00\n";
  };
  for (const double seconds : {0.005, -999.0}) {
    const Motion motion = parse_motion("x.V2c", file(seconds, 5, "cm/sec2 (04)", "2"));
    EXPECT_EQ(motion.dt, 0.005);
    EXPECT_THAT(motion.acceleration, ElementsAre(DoubleEq(0.01), DoubleEq(-0.02)));
  }
  EXPECT_THAT(complaint([&] { parse_motion("x.V2c", file(-999, -999, "cm/s^2", "2")); }),
              HasSubstr("x.V2c:2: states no step"));
  EXPECT_THAT(complaint([&] { parse_motion("x.V2c", file(0.01, 5, "cm/s^2", "3")); }),
              HasSubstr("x.V2c:14: states 3 values, but 2 follow"));
  EXPECT_THAT(complaint([&] { parse_motion("x.V0", file(0.01, 5, "counts (50)", "2")); }),
              HasSubstr("x.V0:14: `counts` is not a unit of acceleration"));
}

}  // namespace
}  // namespace adit::motion::test::readers_test
