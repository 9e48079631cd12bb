#include "main/study_tradeoff.h"

#include <unistd.h>

#include <iostream>
#include <memory>

#include "base/counted.h"
#include "base/error.h"
#include "files/temporary_folder.h"
#include "files/write_file.h"
#include "main/exit_codes.h"
#include "main/shard.h"
#include "main/text_table.h"
#include "process/interrupt.h"
#include "study/tradeoff_answer.h"
#include "study/tradeoff_output.h"
#include "study/tradeoff_sweeps.h"
#include "study/tradeoff_text.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

struct TradeoffOptions {
  std::string study;
  std::string folder;
  std::string shard;
  std::string max_error;
  std::string cost = "mean";
  std::optional<double> budget_us;
  int slots = 1;
  bool dry_run = false;
  bool no_rerun = false;
  std::string command_line;

  CostMeasure measure() const { return cost == "mean" ? CostMeasure::mean : CostMeasure::p99; }
};

std::vector<TradeoffWish> wishesOf(const TradeoffOptions& options, const TradeoffStudy& study) {
  std::vector<TradeoffWish> wishes;
  if (options.budget_us) wishes.push_back({"budget", options.budget_us, {}});
  if (options.max_error.empty()) return wishes;
  wishes.push_back({"errors", std::nullopt, parseErrorLimits(options.max_error)});
  refuseUnjudged(study, wishes.back().limits);
  return wishes;
}

/// Simulates what is missing; false: it was interrupted.
bool simulate(const StudyPart& part, const Shard& shard, const TradeoffOptions& options,
              Interrupt& interrupt) {
  const std::vector<std::size_t> tasks = part.unfinished(shard.index, shard.count);
  std::cout << part.name() << ": " << tasks.size() << " of "
            << counted(part.plan().tasks().size(), "simulation") << " to do" << std::endl;
  ProgressDisplay display(std::cerr, STDERR_FILENO);
  const SessionCounts counts = part.run(tasks, {options.slots, options.command_line}, interrupt, display);
  return counts.interrupted == 0 && !interrupt.requested();
}

void print(const TradeoffStudy& study, const TradeoffResult& result) {
  std::cout << "\n" << alignedText(settingRows(study, result), result.paths.size() + 1, true);
  for (const std::string& line : referenceLines(study, result)) std::cout << line << "\n";
  for (const std::string& line : orderLines(study, result)) std::cout << line << "\n";
}

/// Answers the wishes, with their scenarios written and run again; false: interrupted.
bool answer(TradeoffAnswer& answer, const StudySweeps& sweeps, const TradeoffResult& result,
            const TradeoffOptions& options, Interrupt& interrupt) {
  if (answer.choice.best) {
    sweeps.writeScenario(answer, result, options.measure());
    if (!options.no_rerun) {
      const StudyPart again = sweeps.planAgain(answer, result);
      if (!simulate(again, {}, options, interrupt)) return false;
      sweeps.judgeAgain(answer, again, result, options.measure());
    }
  }
  std::cout << answerText(answer, sweeps.study(), result, options.measure()) << "\n";
  return true;
}

int interruptedAt(const fs::path& folder) {
  std::cerr << "interrupted; the same command goes on in " << folder.string() << "\n";
  return exit_interrupted;
}

int finish(const StudySweeps& sweeps, const std::vector<TradeoffWish>& wishes, const TradeoffOptions& options,
           Interrupt& interrupt) {
  const TradeoffStudy& study = sweeps.study();
  const TradeoffResult result = sweeps.judge(options.measure());
  print(study, result);
  std::vector<TradeoffAnswer> answers;
  bool good = true, interrupted = false;
  for (const TradeoffWish& wish : wishes) {
    answers.push_back(answerOf(wish, study, result, options.measure()));
    if (!answer(answers.back(), sweeps, result, options, interrupt)) {
      interrupted = true;
      break;
    }
    good &= answers.back().choice.best && (options.no_rerun || answers.back().holds);
  }
  writeTradeoff(sweeps.folder(), study, result, answers, options.measure());
  if (interrupted) return interruptedAt(sweeps.folder());
  std::cout << "table: " << (sweeps.folder() / "tradeoff.csv").string() << "\n";
  for (const JudgedSetting& setting : result.settings)
    if (setting.status.end == RunEnd::ok) return good ? exit_good : exit_differs;
  return exit_run_failed;
}

int runTradeoff(const TradeoffOptions& options) {
  const TradeoffStudy study = loadTradeoff(options.study);
  const std::vector<TradeoffWish> wishes = wishesOf(options, study);
  const Shard shard = parseShard(options.shard);
  if (!wishes.empty() && shard.count > 1)
    throw InputError("--shard: expected without --budget-us and --max-error, which need all settings");
  std::optional<TemporaryFolder> scratch;
  if (options.dry_run) scratch.emplace();
  const fs::path folder = options.folder.empty() ? fs::path("out") / study.name : fs::path(options.folder);
  const StudySweeps sweeps(study, scratch ? scratch->path() / study.name : folder);
  if (options.dry_run) {
    for (const StudyPart* part : {&sweeps.ladder(), &sweeps.settings()})
      std::cout << part->name() << ": " << counted(part->plan().tasks().size(), "simulation") << "\n";
    return exit_good;
  }
  Interrupt interrupt;
  for (const StudyPart* part : {&sweeps.ladder(), &sweeps.settings()})
    if (!simulate(*part, shard, options, interrupt)) return interruptedAt(folder);
  if (shard.count > 1) return exit_good;
  return finish(sweeps, wishes, options, interrupt);
}

}  // namespace

Verb addTradeoff(Command study, const std::string& command_line) {
  Command command = study.command("tradeoff", "errors of settings against their cost, and which to take");
  command.example(
      "fissure study tradeoff configs/studies/tradeoff_quick.yaml --max-error depth=0.1mm,force=2%");
  const auto options = std::make_shared<TradeoffOptions>();
  options->command_line = command_line;
  command.option("study", options->study, "study file").required().notEmpty();
  command.option("-o,--output", options->folder, "folder of the study; default: out/<the name in the file>")
      .notEmpty();
  command.option("-j,--jobs", options->slots, "simulations side by side; more than one disturbs the timings")
      .between(1, 1024)
      .showDefault();
  command
      .option("--budget-us", options->budget_us,
              "write the most accurate setting that takes at most so many microseconds for a simulated "
              "millisecond")
      .between(1e-3, 1e9);
  command
      .option("--max-error", options->max_error,
              "write the cheapest setting within these errors, as depth=0.1mm,force=2%")
      .notEmpty();
  command.option("--cost", options->cost, "the time of a step that counts")
      .oneOf({"mean", "p99"})
      .showDefault();
  command.flag("--no-rerun", options->no_rerun, "do not run the settings that are written again");
  command.flag("--dry-run", options->dry_run, "check the study and count its simulations");
  command.option("--shard", options->shard,
                 "I/N: only this one of N shares of the simulations; then once without it");
  return {command, [=] { return runTradeoff(*options); }};
}

}  // namespace fissure
