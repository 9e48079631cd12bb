#pragma once

#include <functional>
#include <string>

#include "main/command.h"

namespace fissure {

/// One verb of the command line: its subcommand, and what to do when it was given; returns the exit code.
struct Verb {
  Command command;
  std::function<int()> action;
};

/// `command_line`: as provenance records it.
Verb addRun(Command app, const std::string& command_line);
Verb addSweep(Command app, const std::string& command_line);
Verb addPlan(Command app);
Verb addValidate(Command app);
Verb addList(Command app);
Verb addInfo(Command app);
Verb addCompare(Command app);
Verb addRender(Command app);
Verb addReport(Command app);
Verb addSalvage(Command app, const std::string& command_line);
Verb addExport(Command app);
Verb addFit(Command app);

}  // namespace fissure
