#include <iostream>
#include <memory>

#include "base/error.h"
#include "check/scenario_warnings.h"
#include "main/exit_codes.h"
#include "main/scenario_options.h"
#include "main/verbs.h"

namespace fissure {

namespace {

int validateScenarios(const ScenarioOptions& options) {
  int code = exit_good;
  for (const std::string& file : options.files) {
    try {
      const CheckedScenario checked = checkScenario(file, options.selection());
      std::cout << file << ": ok\n";
      for (const std::string& note : checked.notes) std::cout << file << ": " << note << "\n";
      for (const std::string& warning : scenarioWarnings(checked))
        std::cout << file << ": " << warning << "\n";
    } catch (const BadSurfaces& error) {
      for (const std::string& line : error.lines()) std::cerr << onOneLine(line) << "\n";
      code = exit_usage;
    } catch (const InputError& error) {
      std::cerr << error.what() << std::endl;
      code = exit_usage;
    }
  }
  return code;
}

}  // namespace

Verb addValidate(Command app) {
  const auto options = std::make_shared<ScenarioOptions>();
  Command command = app.command("validate", "check scenarios without simulating");
  command.example("fissure validate press.yaml --set bodies.0.mass_kg=0.2");
  addScenarioOptions(command, *options);
  return {command, [options] { return validateScenarios(*options); }};
}

}  // namespace fissure
