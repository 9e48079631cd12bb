#include "picture/picture_times.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"

namespace fissure::picture_times_test {

namespace {

using Times = std::vector<double>;

const double nan = std::numeric_limits<double>::quiet_NaN();

/// 0, 0.001 ... as step x dt, with its rounding.
Times milliseconds(int count) {
  Times times_s;
  for (int i = 0; i < count; ++i) times_s.push_back(i * 0.001);
  return times_s;
}

TEST(PictureTimes, AllWhenNothingIsStated) {
  EXPECT_EQ(selectTimes(milliseconds(5), {}), milliseconds(5));
}

TEST(PictureTimes, BordersBelongToTheRangeInSpiteOfRounding) {
  const Times all_s = milliseconds(100);
  const Times chosen_s = selectTimes(all_s, {.from_s = 0.003, .to_s = 0.007});
  ASSERT_EQ(chosen_s.size(), 5u);
  EXPECT_EQ(chosen_s.front(), 3 * 0.001);
  EXPECT_EQ(chosen_s.back(), 7 * 0.001);
}

TEST(PictureTimes, EveryTakesTheFirstAfterEachMultiple) {
  EXPECT_EQ(selectTimes(milliseconds(31), {.every_s = 0.01}), (Times{0, 10 * 0.001, 20 * 0.001, 30 * 0.001}));
  EXPECT_EQ(selectTimes({0.004, 0.008, 0.012, 0.016, 0.02}, {.every_s = 0.01}), (Times{0.004, 0.012, 0.02}));
  EXPECT_EQ(selectTimes(milliseconds(31), {.from_s = 0.005, .every_s = 0.01}).front(), 5 * 0.001);
}

TEST(PictureTimes, AtTakesTheNearestOnceAndInOrder) {
  EXPECT_EQ(selectTimes({0, 0.1, 0.2}, {.at_s = {0.19, 0.02, 0.2, 0.24}}), (Times{0, 0.2}));
}

TEST(PictureTimes, NothingToTakeIsAnError) {
  EXPECT_THROW(selectTimes({0, 0.1}, {.from_s = 0.11}), InputError);
  EXPECT_THROW(selectTimes({0, 0.1}, {.from_s = 0.02, .to_s = 0.05}), InputError);
  EXPECT_THROW(selectTimes({0, 0.1}, {.at_s = {0, 0.16}}), InputError);
  EXPECT_THROW(selectTimes({0, 0.1}, {.at_s = {nan}}), InputError);
  EXPECT_THROW(selectTimes({0}, {.at_s = {0.001}}), InputError);
}

TEST(Video, EachFrameShowsTheLastPictureThatIsNotLater) {
  // 25 frames a second in real time: one in 40 ms.
  Times times_s;
  for (int i = 0; i <= 20; ++i) times_s.push_back(10 * i * 0.001);
  const std::vector<std::size_t> shown = timesShown(times_s, 25, 1);
  for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_EQ(shown[i], i % 4 == 0 ? 1u : 0u) << i;
  // Eight times slower: one in 5 ms, so each twice, and the last once.
  const std::vector<std::size_t> slow = timesShown(times_s, 25, 8);
  for (std::size_t i = 0; i < slow.size(); ++i) EXPECT_EQ(slow[i], i < 20 ? 2u : 1u) << i;
}

TEST(Video, LastPictureIsShown) {
  EXPECT_EQ(timesShown({0, 0.01}, 25, 1), (std::vector<std::size_t>{1, 1}));
  EXPECT_EQ(timesShown({0.3}, 25, 1), (std::vector<std::size_t>{1}));
}

TEST(Video, TooManyFramesAreRefused) {
  EXPECT_THROW(timesShown({0, 1}, 100, 1e6), InputError);
}

TEST(TimeTexts, SortAsTheTimesDo) {
  const TimeTexts texts({0, 0.5, 12});
  EXPECT_EQ(texts.of(0.5), "00.500s");
  EXPECT_LT(texts.of(0.5), texts.of(12));
}

TEST(TimeTexts, DifferWhereTheTimesDo) {
  EXPECT_EQ(TimeTexts({0, 0.001}).of(0.001), "0.001s");
  EXPECT_EQ(TimeTexts({0, 0.0005, 0.001}).of(0.0005), "0.0005s");
  EXPECT_EQ(TimeTexts({0, 1.0 / 240, 2.0 / 240}).of(1.0 / 240), "0.004s");
  EXPECT_EQ(TimeTexts({1e-12, 2e-12}).of(0), "0.000000000s") << "no end of digits";
}

}  // namespace
}  // namespace fissure::picture_times_test
