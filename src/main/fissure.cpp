// The front program: verbs, exit codes, and the only place that prints errors.
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/build_info.h"
#include "batch/provenance.h"
#include "main/exit_codes.h"
#include "main/verbs.h"
#include "process/interrupt.h"
#include "text/terminal_text.h"

namespace {

using namespace fissure;

/// A closed pipe or a file size limit becomes a failed write, and the ends of workers are seen, whatever was
/// inherited.
void setSignals() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);
}

int runVerb(const std::vector<Verb>& verbs) {
  int code = exit_usage;
  for (const Verb& verb : verbs)
    if (verb.command.given()) code = verb.action();
  return code;
}

int fail(int code, const std::string& message) {
  std::cerr << onOneLine(message) << std::endl;
  return code;
}

int parseAndRun(int argc, char** argv) {
  CommandLine command_line("fissure: batch experiments in soft-rigid contact with thin surgical tools",
                           "fissure");
  command_line.setVersion("fissure " + buildInfo().version + " (" + buildInfo().commit + ")");
  command_line.requireCommand();
  command_line.setFooter(
      "Exit codes: 0 done and good, 1 a comparison or an expectation failed, 2 bad input or usage, 3 a run "
      "failed, 130 "
      "interrupted.");
  Command app = command_line.root();
  const std::string words = commandLine(argc, argv);
  std::string shell;
  Command completion = app.command("completion", "a script that lets a shell complete commands and options");
  completion.option("SHELL", shell, "for which shell").oneOf({"bash"}).required();
  completion.example("eval \"$(fissure completion bash)\", in ~/.bashrc");
  const auto complete = [&] {
    std::cout << command_line.bashCompletion();
    return exit_good;
  };
  const std::vector<Verb> verbs = {{completion, complete}, addRun(app, words),    addSweep(app, words),
                                   addStudy(app, words),   addPlan(app),          addValidate(app),
                                   addList(app),           addExplain(app),       addSchema(app),
                                   addInit(app),           addInfo(app),          addCompare(app),
                                   addRender(app),         addReport(app),        addExport(app),
                                   addFit(app, words),     addSalvage(app, words)};
  const CommandLine::Outcome parsed = command_line.parse(argc, argv);
  if (parsed.done) return exit_good;
  if (!parsed.error.empty()) return fail(exit_usage, parsed.error);
  return runVerb(verbs);
}

}  // namespace

int main(int argc, char** argv) {
  // Names and texts of results and scenarios come from anywhere: none of them may command the terminal.
  PlainOutput plain_out(std::cout);
  const PlainOutput plain_err(std::cerr);
  try {
    setSignals();
    const int code = parseAndRun(argc, argv);
    plain_out.requireWritten("standard output");
    return code;
  } catch (const InputError& error) {
    return fail(exit_usage, error.what());
  } catch (const RunError& error) {
    return fail(exit_run_failed, error.what());
  } catch (const Interrupted& request) {
    return fail(exit_interrupted, "fissure: " + std::string(request.what()));
  } catch (const std::bad_alloc&) {
    return fail(exit_run_failed, "fissure: out of memory");
  } catch (const std::exception& error) {
    return fail(exit_run_failed, "fissure: " + std::string(error.what()));
  }
}
