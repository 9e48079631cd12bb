#include "report/page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/base64.h"
#include "report/frames.h"
#include "report/step_times.h"
#include "report/video.h"
#include "store/sample_run.h"

namespace fissure::page_test {

namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Page, NothingInTheDataIsMarkup) {
  const std::string evil = "</script><img src=x onerror=alert(1)><!-- <script> \" ' & \xff {{data}}";
  const std::string harmless = pageText({{"title", "a"}, {"text", "b"}});
  const std::string page = pageText({{"title", evil}, {"text", evil}, {evil, 1}});
  for (const char* tag : {"<script", "</script", "<img", "<!--"})
    EXPECT_EQ(countOf(page, tag), countOf(harmless, tag)) << tag;
  EXPECT_NE(page.find("<title>&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;"), std::string::npos);
  EXPECT_NE(page.find("\\u003c/script>"), std::string::npos) << "the data still say it";
}

TEST(Page, LoadsNothingAndRunsOnlyItsOwnScripts) {
  const std::string page = pageText({{"title", "a"}});
  for (const char* words : {"default-src 'none'", "The MIT License (MIT)", "uPlot 1.6.32", "<title>a"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  for (const char* words : {"src=\"http", "href=\"http", "@import", "url(", "innerHTML", "eval("})
    EXPECT_EQ(page.find(words), std::string::npos) << words;
  EXPECT_EQ(countOf(page, "<script nonce="), 2u);
  EXPECT_EQ(page, pageText({{"title", "a"}}));
}

// RFC 4648, section 10.
TEST(Base64, KnownTexts) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Numbers, SixDigitsAndNothingThatIsNotFinite) {
  EXPECT_EQ(shortNumber(0.1234567891).dump(), "0.123457");
  EXPECT_EQ(shortNumber(-3).dump(), "-3");
  EXPECT_EQ(shortNumber(1e-30).dump(), "1e-30");
  EXPECT_TRUE(shortNumber(NAN).is_null());
  EXPECT_TRUE(shortNumber(-INFINITY).is_null());
}

// 1 to 2,000 us in steps of 1: half are at most 1,000, 1,000 above the budget.
TEST(StepTimes, QuantilesAndTheSlowestSteps) {
  std::vector<double> times = {NAN};
  for (int us = 2000; us > 0; --us) times.push_back(us);
  const PageJson json = distributionJson(times);
  EXPECT_EQ(json["steps"], 2000);
  EXPECT_EQ(json["p50_us"], 1000);
  EXPECT_EQ(json["p99_us"], 1980);
  EXPECT_EQ(json["max_us"], 2000);
  EXPECT_EQ(json["over_budget"], 1000);
  const std::size_t points = json["curve_us"].size();
  EXPECT_LT(points, 250u);
  for (std::size_t i = 0; i < points; ++i)
    EXPECT_NEAR(json["curve_percent"][i].get<double>(), json["curve_us"][i].get<double>() / 20, 1e-9);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(json["curve_us"][points - 1 - i], 2000 - i);
}

TEST(StepTimes, NoneAtAll) {
  const PageJson json = distributionJson({NAN});
  EXPECT_EQ(json["steps"], 0);
  EXPECT_TRUE(json["p50_us"].is_null());
}

TEST(Frames, EvenlySpreadWithBothEnds) {
  EXPECT_EQ(evenlySpread(3, 5), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(evenlySpread(101, 5), (std::vector<std::size_t>{0, 25, 50, 75, 100}));
  EXPECT_EQ(evenlySpread(1000, 2), (std::vector<std::size_t>{0, 999}));
  EXPECT_TRUE(evenlySpread(0, 2).empty());
}

std::string complaintAboutVideo(const std::filesystem::path& file) {
  try {
    return videoUri(file);
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Video, Mp4AndWebmUpToALimit) {
  const ScratchFolder folder;
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return folder / name;
  };
  EXPECT_EQ(complaintAboutVideo(write("a.mp4", std::string("\0\0\0\x18", 4) + "ftypisom")).substr(0, 22),
            "data:video/mp4;base64,");
  EXPECT_EQ(complaintAboutVideo(write("a.webm", "\x1a\x45\xdf\xa3...")).substr(0, 23),
            "data:video/webm;base64,");
  EXPECT_NE(complaintAboutVideo(write("a.txt", "ftyp, but later")).find("expected MP4 or WebM"),
            std::string::npos);
  EXPECT_NE(complaintAboutVideo(folder / "none.mp4").find("no such file"), std::string::npos);
  std::filesystem::resize_file(folder / "a.mp4", most_video_bytes + 1);
  EXPECT_NE(complaintAboutVideo(folder / "a.mp4").find("16 MB, expected a video of at most 16 MB"),
            std::string::npos);
}

}  // namespace
}  // namespace fissure::page_test
