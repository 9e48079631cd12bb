#include "target.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <typeinfo>

#include "base/error.h"
#include "files/temporary_folder.h"

namespace fissure::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"scenario", &takeScenario}, {"sweep", &takeSweep},   {"study", &takeStudy},
      {"log", &takeLog},           {"curve", &takeCurve},   {"mesh", &takeMesh},
      {"volume", &takeVolume},     {"result", &takeResult}, {"journal", &takeJournal},
      {"manifest", &takeManifest},
  };
  return all;
}

const Target& targetNamed(const std::string& name) {
  for (const Target& target : targets())
    if (target.name == name) return target;
  std::cerr << "no target \"" << name << "\"\n";
  std::exit(2);
}

void require(bool holds, const std::string& promise) {
  if (holds) return;
  std::cerr << "broken promise: " << promise << std::endl;
  std::abort();
}

const std::filesystem::path& scratch() {
  static const TemporaryFolder folder;
  return folder.path();
}

std::filesystem::path put(const std::string& name, const std::string& bytes) {
  const std::filesystem::path file = scratch() / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

bool isOneLine(const std::string& text) {
  constexpr std::size_t longest = 2000;
  return !text.empty() && text.size() <= longest && text.find_first_of("\n\r") == std::string::npos;
}

Refusal ofYaml(const std::string& bytes) {
  return bytes.empty() || bytes.starts_with("\x89HDF") ? Refusal::file : Refusal::line;
}

bool accepts(const std::filesystem::path& file, Refusal refusal, const std::function<void()>& read) {
  const auto requireLine = [&](const std::string& said) {
    require(isOneLine(said), "an error is one line: " + said);
    require(said.starts_with(file.string()), "an error names its file: " + said);
  };
  try {
    read();
    return true;
  } catch (const InputError& error) {
    requireLine(error.what());
    require(refusal != Refusal::line || error.origin().line > 0,
            std::string("an error names a line: ") + error.what());
  } catch (const RunError& error) {
    require(refusal == Refusal::own_file,
            std::string("a refusal is an InputError, not a RunError: ") + error.what());
    require(isOneLine(error.what()), std::string("an error is one line: ") + error.what());
  } catch (const std::exception& error) {
    require(false, fmt::format("a refusal is an InputError, not {}: {}", typeid(error).name(), error.what()));
  }
  return false;
}

}  // namespace fissure::fuzz
