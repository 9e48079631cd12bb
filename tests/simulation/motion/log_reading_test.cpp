#include <gtest/gtest.h>

#include <ctime>
#include <locale>
#include <random>

#include "motion/device_log.h"
#include "temporary_log.h"

namespace fissure::log_reading_test {

namespace {

/// The sample at 0.1 s of a log that says t = 5, 5.1, 5.2 and x = 1, 2, 3; y = -x; z = 10 x.
void expectTheThreeSamples(const std::string& text) {
  const auto motion = play(text, timed());
  EXPECT_EQ(count(*motion, "replay_samples"), 3);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 0);
  EXPECT_NEAR(motion->duration_s(), 0.2, 1e-15);
  EXPECT_LT((motion->poseAt(0).position_m - Vec3(1, -1, 10)).norm(), 1e-14);
  EXPECT_LT((motion->poseAt(5.1 - 5.0).position_m - Vec3(2, -2, 20)).norm(), 1e-12);
  EXPECT_LT((motion->poseAt(9).position_m - Vec3(3, -3, 30)).norm(), 1e-14);
}

TEST(LogText, MayBeDividedByCommasSemicolonsTabsOrBlanks) {
  expectTheThreeSamples("t,x,y,z\n5,1,-1,10\n5.1,2,-2,20\n5.2,3,-3,30\n");
  expectTheThreeSamples("t;x;y;z\n5;1;-1;10\n5.1;2;-2;20\n5.2;3;-3;30\n");
  expectTheThreeSamples("t\tx\ty\tz\n5\t1\t-1\t10\n5.1\t2\t-2\t20\n5.2\t3\t-3\t30\n");
  expectTheThreeSamples("  t x   y z\n5 1 -1 10\n  5.1 2 \t -2   20  \n5.2 3 -3 30\n");
}

TEST(LogText, ToleratesWhatRealLogsHave) {
  expectTheThreeSamples("t,x,y,z,\n5,1,-1,10,\n5.1,2,-2,20,\n5.2,3,-3,30,\n");        // trailing delimiters
  expectTheThreeSamples("t,x,y,z\n5,1,-1,10,\n5.1,2,-2,20,,\n5.2,3,-3,30\n");         // in rows only
  expectTheThreeSamples("t,x,y,z\r\n5,1,-1,10\r\n5.1,2,-2,20\r\n5.2,3,-3,30\r\n");    // CRLF
  expectTheThreeSamples("\xEF\xBB\xBFt,x,y,z\n5,1,-1,10\n5.1,2,-2,20\n5.2,3,-3,30");  // mark; no last newline
  expectTheThreeSamples(
      "\" t \", \"x\" ,y ,\tz\n5, 1 ,\"-1\",10\n5.1,2,-2,20\n5.2,3,-3,30");  // quotes, padding
  expectTheThreeSamples(
      "t,x,y,z\n\n5,1,-1,10\n5.1,+2,-2.0e0,2E1\n  \n5.2,3,-3,30\n\n\n");  // empty lines, forms
  expectTheThreeSamples(
      "# probe 1, by hand\nt,x,y,z\n5,1,-1,10\n5.1,2,-2,20\n# paused\n5.2,3,-3,30\n");  // comments
}

TEST(LogText, ColumnsAreFoundByNameInAnyOrderAndOthersMayHoldText) {
  expectTheThreeSamples(
      "note,z,\"force, N\",y,x,t\nfirst,10,nan,-1,1,5\n,20,,-2,2,5.1\n\"a,b\",30,1,-3,3,5.2\n");
}

TEST(LogText, IsReadTheSameInEveryLocale) {
  // A locale with a decimal comma, as a German desktop sets it.
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  expectTheThreeSamples("t,x,y,z\n5,1,-1,10\n5.1,2,-2,20\n5.2,3,-3,30\n");
  std::locale::global(before);
}

TEST(LogText, MissingAndUselessFilesAreNamed) {
  ToolSettings tool;
  tool.name = "hand";
  ReplayMotion settings = timed();
  settings.file = "no/such/log.csv";
  tool.motion = settings;
  EXPECT_EQ(inputError([&] { makeMotion(tool, "here"); }),
            "log.csv: no such file, expected a text file of numbers");
  settings.file = ".";
  tool.motion = settings;
  EXPECT_EQ(inputError([&] { makeMotion(tool, "/"); }), "/.: is a folder, expected a text file of numbers");
  EXPECT_EQ(playError("", timed()), "log.csv: is empty, expected a header line of column names");
  EXPECT_EQ(playError("\n1,2,3,4\n", timed()),
            "log.csv:1: an empty line, expected a header line of column names");
  EXPECT_EQ(playError("t,x,y,z\n", timed()), "log.csv:1: only a header line, expected rows below it");
  EXPECT_EQ(playError(std::string("t,x,y,z\n1,2,\0,4\n", 16), timed()),
            "log.csv: is binary (it holds NUL bytes), expected plain text, UTF-8 or ASCII");
  EXPECT_EQ(playError("t,x,y,z\n1,2,,4\n,,,\n", timed()),
            "log.csv: none of its 2 rows has a pose, expected a number in each named column");
}

TEST(LogText, MissingColumnsAreNamedWithWhatThereIs) {
  EXPECT_EQ(playError("t,x_m,y_m,z_m\n0,1,2,3\n", timed()),
            "log.csv:1: no column \"x\" in the header (it has t, x_m, y_m, z_m), did you mean \"x_m\"?");
  ReplayMotion settings = timed();
  settings.position_columns[2] = "height";
  EXPECT_EQ(playError("t,x,y,z\n0,1,2,3\n", settings),
            "log.csv:1: no column \"height\" in the header (it has t, x, y, z), expected one of these");
  // Nameless columns are no advice; bytes that a terminal or JSON could choke on are not repeated.
  EXPECT_EQ(playError("x,,\x1b\xb5,y,z\n0,1,2,3,4\n", timed()),
            "log.csv:1: no column \"t\" in the header (it has x, , ??, y, z), did you mean \"x\"?");
  settings = rated(10);
  settings.quaternion_columns = {"qx", "qy", "qz", "qw"};
  EXPECT_EQ(
      playError("x,y,z,qx,qy,qz,q\n0,1,2,3,4,5,6\n", settings),
      "log.csv:1: no column \"qw\" in the header (it has x, y, z, qx, qy, qz, q), did you mean \"qx\"?");
  EXPECT_EQ(playError("t,x,y,x,z\n0,1,2,3,4\n", timed()),
            "log.csv:1: two columns are called \"x\", expected one");
  EXPECT_EQ(playError("# a comment\nt,x,y,x,z\n0,1,2,3,4\n", timed()),
            "log.csv:2: two columns are called \"x\", expected one");
}

TEST(LogText, TextInANeededCellIsAnErrorWithItsLine) {
  EXPECT_EQ(playError("t,x,y,z\n0,1,2,3\n1,1,oops,3\n", timed()),
            "log.csv:3: \"oops\" in column \"y\", expected a number like -0.0125 or nothing");
  for (const std::string bad : {"1.5m", "0x10", "1..2", "--1", "+-1", "+", "1 2", "1e999", "1e"})
    EXPECT_EQ(playError("t,x,y,z\n\n0," + bad + ",2,3\n", timed()),
              "log.csv:3: \"" + bad + "\" in column \"x\", expected a number like -0.0125 or nothing");
  EXPECT_EQ(playError("t;x;y;z\n0;1,5;2;3\n", timed()),
            "log.csv:2: \"1,5\" in column \"x\", expected a number like -0.0125 or nothing");
}

TEST(LogText, RowsWithMoreCellsThanNamesAreErrors) {
  // A decimal comma in a file divided by commas: the cells no longer stand under their names.
  EXPECT_EQ(playError("t,x,y,z\n0,1,2,3\n0,1,1,2,3\n", timed()),
            "log.csv:3: 5 cells, expected the 4 of the header");
}

TEST(LogText, NeverCrashesOnDamagedFiles) {
  const std::string good =
      "t,x,y,z,qx,qy,qz,qw\n5,1,-1,10,0,0,0,1\n5.1,2,-2,20,1,0,0,0\n5.2,3,-3,30,0,1,0,0\n";
  const std::string letters = "\n\r\t ,;\"-+.e0159nxtz\x80";
  ReplayMotion settings = timed();
  settings.quaternion_columns = {"qx", "qy", "qz", "qw"};
  settings.interpolation = Interpolation::monotone_cubic;
  std::mt19937 random(1);
  int played = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = good;
    text[random() % text.size()] = letters[random() % letters.size()];
    if (round % 4 == 0) text.resize(random() % text.size());
    try {
      const auto motion = play(text, settings);
      for (const double time_s : {0.0, 0.05, 0.15, 1e9})
        EXPECT_TRUE(motion->poseAt(time_s).position_m.allFinite());
      ++played;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(played, 200);   // some damage does not matter ...
  EXPECT_LT(played, 1800);  // ... most does
}

TEST(LogText, AMillionRowsLoadQuickly) {
  std::string text = "t,x,y,z,fx,fy,fz\n";
  for (int i = 0; i < 1'000'000; ++i)
    text += std::to_string(0.001 * i) + ",0.0150186,-0.0546833,0.104991,-0.742894,2.92383,-0.0126603\n";
  const std::clock_t start = std::clock();
  const auto motion = play(text, timed());
  const double processor_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_EQ(count(*motion, "replay_samples"), 1'000'000);
  EXPECT_EQ(count(*motion, "replay_held_samples"), 999'999);
  // Of the processor, whatever else it does. Measured: 1 s; the bound leaves room for sanitizers.
  EXPECT_LT(processor_s, 15.0);
}

}  // namespace
}  // namespace fissure::log_reading_test
