#pragma once

#include <functional>
#include <string>

#include "main/command.h"

namespace fissure {

/// A verb of the command line: its subcommand, and the action to perform when it is given, which returns the
/// exit code.
struct Verb {
  Command command;
  std::function<int()> action;
};

/// Add a verb to the program. `command_line`: the command line in the form that provenance records.
Verb addRun(Command app, const std::string& command_line);
Verb addSweep(Command app, const std::string& command_line);
Verb addStudy(Command app, const std::string& command_line);
Verb addPlan(Command app);
Verb addValidate(Command app);
Verb addList(Command app);
Verb addExplain(Command app);
Verb addSchema(Command app);
Verb addInit(Command app);
Verb addInfo(Command app);
Verb addCompare(Command app);
Verb addRender(Command app);
Verb addReport(Command app);
Verb addSalvage(Command app, const std::string& command_line);
Verb addExport(Command app);
Verb addFit(Command app, const std::string& command_line);

}  // namespace fissure
