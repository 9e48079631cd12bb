#include "base/error.h"
#include "main/study_stability.h"
#include "main/study_tradeoff.h"
#include "main/verbs.h"

namespace fissure {

Verb addStudy(Command app, const std::string& command_line) {
  Command command = app.command("study", "a sweep with a question: what accuracy costs, where runs break");
  command.example("fissure study tradeoff configs/studies/tradeoff_quick.yaml --budget-us 1000");
  const std::vector<Verb> studies = {addTradeoff(command, command_line), addStability(command, command_line)};
  return {command, [=] {
            for (const Verb& study : studies)
              if (study.command.given()) return study.action();
            throw InputError("study: no kind of study is named, expected tradeoff or stability");
          }};
}

}  // namespace fissure
