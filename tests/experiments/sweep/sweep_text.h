#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"
#include "sweep/sweep_file.h"

namespace fissure {

/// A sweep file of this text below its obligatory head; axes and all else are the caller's.
inline SweepSettings sweepOf(const std::string& text) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("fissure_sweep_" + std::to_string(::getpid()) + ".yaml");
  std::ofstream(file) << "format: 1\nname: sweep\nbase: base.yaml\n" << text;
  struct Removed {
    const std::filesystem::path& file;
    ~Removed() { std::filesystem::remove(file); }
  } removed{file};
  return loadSweep(file);
}

/// What is wrong with it, from the line on, or "nothing".
inline std::string complaintAbout(const std::string& text) {
  try {
    sweepOf(text);
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find(".yaml:") + 6);
  }
  return "nothing";
}

}  // namespace fissure
