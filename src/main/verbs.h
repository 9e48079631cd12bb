#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace fissure {

/// One verb of the command line: its subcommand, and what to do when it was given; returns the exit code.
struct Verb {
  CLI::App* command = nullptr;
  std::function<int()> action;
};

/// A check for options that name a file: what is wrong with its value, or nothing.
inline std::string notEmpty(const std::string& file) {
  return file.empty() ? "names no file" : "";
}

/// `command_line`: as provenance records it.
Verb addRun(CLI::App& app, const std::string& command_line);
Verb addSweep(CLI::App& app, const std::string& command_line);
Verb addPlan(CLI::App& app);
Verb addValidate(CLI::App& app);
Verb addList(CLI::App& app);
Verb addInfo(CLI::App& app);
Verb addCompare(CLI::App& app);
Verb addRender(CLI::App& app);
Verb addReport(CLI::App& app);
Verb addSalvage(CLI::App& app, const std::string& command_line);
Verb addExport(CLI::App& app);
Verb addFit(CLI::App& app);

}  // namespace fissure
