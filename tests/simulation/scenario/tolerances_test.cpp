#include "scenario/tolerances.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"

namespace fissure::tolerances_test {

namespace {

Tolerances load(const std::string& text) {
  const auto file =
      std::filesystem::temp_directory_path() / ("tolerances" + std::to_string(::getpid()) + ".yaml");
  std::ofstream(file) << text;
  try {
    const Tolerances read = loadTolerances(file);
    std::filesystem::remove(file);
    return read;
  } catch (const InputError& error) {
    std::filesystem::remove(file);
    std::string message = error.what();
    throw InputError(message.substr(message.find(".yaml")));
  }
}

std::string errorOf(const std::string& text) {
  try {
    load(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Tolerances, LastFittingRuleCounts) {
  const Tolerances read = load(
      "format: 1\n"
      "tolerances:\n"
      "  - {quantity: '*', relative: 1e-6}\n"
      "  - {quantity: 'force*', pipeline: raycast, absolute: 2, time_shift_s: 0.01}\n"
      "  - {quantity: frames, ignore: true}\n");
  EXPECT_EQ(read.of("positions", "fukuhara").relative, 1e-6);
  EXPECT_EQ(read.of("force_elastic", "raycast").absolute, 2);
  EXPECT_EQ(read.of("force_elastic", "raycast").time_shift_s, 0.01);
  EXPECT_EQ(read.of("force_elastic", "raycast").relative, 0);
  EXPECT_EQ(read.of("force_elastic", "fukuhara").relative, 1e-6);
  EXPECT_TRUE(read.of("frames", "default").ignore);
  EXPECT_EQ(load("format: 1\ntolerances: []\n").of("force", "default").absolute, 0);
}

TEST(Tolerances, BadOnesAreNamedWithTheirLine) {
  EXPECT_NE(errorOf(""), "");
  EXPECT_NE(errorOf("format: 2\ntolerances: []\n").find(".yaml:1: format is 2"), std::string::npos);
  EXPECT_NE(errorOf("format: 1\ntolerances:\n  - {quantity: force, absolut: 1}\n").find(".yaml:3: "),
            std::string::npos);
  EXPECT_NE(errorOf("format: 1\ntolerances:\n  - {quantity: force, absolute: -1}\n")
                .find(".yaml:3: tolerances.0.absolute is -1, expected a number of at least 0"),
            std::string::npos);
  EXPECT_NE(errorOf("format: 1\ntolerances:\n  - {absolute: 1}\n").find("quantity"), std::string::npos);
  EXPECT_NE(errorOf("format: 1\ntolerances:\n  - {quantity: force, relative: .nan}\n"), "");
  EXPECT_NE(errorOf("format: 1\n").find("tolerances"), std::string::npos);
}

}  // namespace
}  // namespace fissure::tolerances_test
