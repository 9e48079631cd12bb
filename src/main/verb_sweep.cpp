#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "base/error.h"
#include "batch/build_info.h"
#include "batch/provenance.h"
#include "main/exit_codes.h"
#include "main/result_json.h"
#include "main/shard.h"
#include "main/slurm_options.h"
#include "main/text_table.h"
#include "main/verbs.h"
#include "sweep/plan_text.h"
#include "sweep/sweep_estimate.h"
#include "sweep/sweep_merge.h"
#include "sweep/sweep_planning.h"
#include "sweep/sweep_results.h"
#include "sweep/sweep_session.h"
#include "sweep/sweep_why.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"
#include "text/text_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

struct SweepOptions {
  std::string sweep;  ///< file, or the folder of a planned one
  std::string folder;
  std::string shard;
  std::optional<int> slots;
  SlurmOptions slurm;
  bool dry_run = false;
  bool why = false;
  bool allow_many_runs = false;
  bool fail_fast = false;
  bool json = false;
  std::string command_line;
};

/// Where the sweep's folder is; default: out/<the sweep's name>.
fs::path folderOf(const SweepOptions& options) {
  std::error_code ignored;
  if (fs::is_directory(options.sweep, ignored)) {
    if (!options.folder.empty())
      throw InputError("-o " + options.folder + ": " + options.sweep +
                       " is the folder of a sweep already, expected a sweep file");
    return options.sweep;
  }
  if (!options.folder.empty()) return options.folder;
  return fs::path("out") / loadSweep(options.sweep).name;
}

void printEstimate(const SweepEstimate& estimate, std::size_t tasks, std::size_t all, int slots,
                   std::ostream& out) {
  out << "to do: " << tasks << " of " << counted(all, "simulation");
  if (estimate.one_s)
    out << ", about " << durationText(estimate.total_s(tasks, slots)) << " with -j " << slots << " ("
        << std::round(*estimate.one_s * 1e3) << " ms each)";
  if (tasks > 0) out << ", at most about " << sizeText(estimate.bytes) << " on disk";
  out << "\n";
}

/// Returns the tasks of a shard, in the order of the plan.
std::vector<std::size_t> tasksOf(const SweepPlan& plan, const Shard& shard) {
  std::vector<std::size_t> tasks;
  for (std::size_t task = 0; task < plan.tasks().size(); ++task)
    if (plan.shardOf(task, shard.count) == shard.index - 1) tasks.push_back(task);
  return tasks;
}

Provenance provenanceOf(const SweepPlan& plan, const std::string& command_line) {
  std::string inputs;
  for (const auto& [name, hash] : plan.manifest().inputs)
    inputs.append(inputs.empty() ? "" : ", ").append(name).append("=").append(hash);
  const auto now = std::chrono::system_clock::now();
  LoadedScenario base = plan.base();
  base.resolved = plan.manifest().scenario;
  return collectProvenance(base, inputs, command_line, {now, now, 0});
}

int codeOf(const std::map<RunEnd, std::size_t>& counts) {
  for (const auto& [end, count] : counts)
    if (end != RunEnd::ok) return exit_run_failed;
  return exit_good;
}

/// The counts in the order of the names.
std::map<std::string, std::size_t> byName(const std::map<RunEnd, std::size_t>& counts) {
  std::map<std::string, std::size_t> named;
  for (const auto& [end, count] : counts) named[nameOf(end)] = count;
  return named;
}

/// What else is in the journals.
void printRest(const SweepState& state, std::ostream& out) {
  if (state.unplannedRecords() > 0)
    out << counted(state.unplannedRecords(), "record") << " of an earlier form of the sweep\n";
  for (const fs::path& journal : state.damaged())
    out << journal.string() << ": its end is torn or damaged, what it held is made again\n";
}

void printCounts(const SweepPlan& plan, const SweepState& state) {
  std::cout << counted(plan.runs(), "run") << ":";
  const char* comma = " ";
  for (const auto& [status, count] : byName(countRuns(plan, state))) {
    std::cout << comma << count << " " << status;
    comma = ", ";
  }
  std::cout << "\n";
  printRest(state, std::cout);
}

nlohmann::ordered_json dryRunJson(const SweepPlan& plan, std::size_t tasks, const SweepEstimate& estimate,
                                  int slots) {
  nlohmann::ordered_json seconds;
  if (estimate.one_s) seconds = estimate.total_s(tasks, slots);
  return {{"exit_code", exit_good},          {"runs", plan.runs()},   {"simulations", plan.tasks().size()},
          {"unfinished_simulations", tasks}, {"estimate_s", seconds}, {"estimate_bytes", estimate.bytes}};
}

/// Somebody may have planned the folder's sweep anew meanwhile: the table would not be that of its plan.
void refuseReplacedPlan(const SweepPlan& plan, const fs::path& folder) {
  if (readTextFile(manifestFile(folder)) != manifestText(plan.manifest()))
    throw RunError(folder.string() +
                   ": was planned anew meanwhile; what ran is recorded, `fissure sweep merge " +
                   folder.string() + "` writes the tables of the new plan");
}

/// Tables of all that is known, and what they say.
int finish(const SweepPlan& plan, const fs::path& folder, bool json, const std::string& command_line) {
  SweepState state(plan, folder);
  forgetLostResults(state, folder, tasksOf(plan, {}), ResultCheck::contents);
  refuseReplacedPlan(plan, folder);
  writeSweepTables(plan, state, folder, provenanceOf(plan, command_line));
  if (comparesNothing(plan, folder))
    std::cerr << "no run reaches all points of " << plan.manifest().settings.fit->curve
              << ", misfit_N is empty: expected simulations as long or deep as these\n";
  const auto counts = countRuns(plan, state);
  const int code = codeOf(counts);
  if (json) {
    std::cout << jsonText({{"exit_code", code},
                           {"sweep", plan.manifest().settings.name},
                           {"runs", plan.runs()},
                           {"simulations", plan.tasks().size()},
                           {"status", byName(counts)},
                           {"table", tableFile(folder).string()},
                           {"csv", csvFile(folder).string()}});
  } else {
    printCounts(plan, state);
    std::cout << "table: " << tableFile(folder).string() << "\n";
  }
  return code;
}

nlohmann::ordered_json sessionJson(const SessionCounts& counts, int code) {
  return {{"exit_code", code},
          {"ok", counts.ok},
          {"failed", counts.failed},
          {"interrupted", counts.interrupted},
          {"advanced", counts.advanced}};
}

int finishShard(const SweepOptions& options, const SessionCounts& counts, std::ostream& out) {
  const int code = counts.failed > 0 ? exit_run_failed : exit_good;
  out << "shard " << options.shard << ": " << counts.ok << " ok, " << counts.failed << " failed\n";
  if (options.json) std::cout << jsonText(sessionJson(counts, code));
  return code;
}

void printSubmitted(const Submitted& submitted, bool json) {
  if (!json) return;
  std::cout << jsonText({{"exit_code", submitted.merge_refused.empty() ? exit_good : exit_run_failed},
                         {"shards", submitted.shards},
                         {"missing", submitted.missing},
                         {"array_job", submitted.array_job},
                         {"merge_job", submitted.merge_job}});
}

/// For how many simulations it is worth to time some first; never: one more than there are.
std::size_t timedFrom(const SweepOptions& options, const std::optional<SlurmSubmission>& slurm, int slots,
                      std::size_t simulations) {
  const bool asked = options.dry_run || (slurm && slurm->choosesByTime(simulations));
  if (asked) return 1;
  return slurm || !options.shard.empty() ? simulations + 1 : 8 * static_cast<std::size_t>(slots);
}

/// For the engine Slurm; nothing for this machine.
std::optional<SlurmSubmission> submissionOf(const SweepOptions& options, const fs::path& folder) {
  if (options.slurm.engine != "slurm") {
    refuseSlurmOptions(options.slurm);
    return std::nullopt;
  }
  if (!options.shard.empty()) throw InputError("--shard: expected not with --engine slurm, but --shards");
  if (options.fail_fast) throw InputError("--fail-fast: expected not with --engine slurm");
  SlurmOptions slurm = options.slurm;
  slurm.dry_run = options.dry_run;
  return std::optional<SlurmSubmission>(std::in_place, folder, slurm, options.slots);
}

/// Runs tasks; then the tables, unless that is the business of a merge.
int simulate(const SweepState& state, const fs::path& folder, std::vector<std::size_t> tasks, int slots,
             const SweepOptions& options, std::unique_ptr<Interrupt> interrupt) {
  const SweepPlan& plan = state.plan();
  ProgressDisplay display(std::cerr, STDERR_FILENO);
  SessionCounts counts;
  std::string failure;
  if (!tasks.empty()) {
    const auto untried = static_cast<std::size_t>(
        std::count_if(tasks.begin(), tasks.end(), [&](std::size_t task) { return !state.task(task).place; }));
    SweepSession session(plan, folder, std::move(tasks),
                         {slots, untried, options.fail_fast, options.command_line}, display);
    session.run(*interrupt);
    counts = session.counts();
    failure = session.firstFailure();
  }
  if (!failure.empty()) std::cerr << "first failure: " << failure << "\n";
  if (counts.failed > 0 && options.fail_fast) return exit_run_failed;
  if (counts.interrupted > 0 || interrupt->requested()) {
    std::cerr << "interrupted; `fissure sweep " << folder.string() << "` goes on\n";
    if (options.json) std::cout << jsonText(sessionJson(counts, exit_interrupted));
    return exit_interrupted;
  }
  interrupt.reset();  // tables are written whole or not at all: Ctrl-C just ends it
  if (options.shard.empty()) return finish(plan, folder, options.json, options.command_line);
  return finishShard(options, counts, options.json ? std::cerr : std::cout);
}

int runSweep(const SweepOptions& options) {
  const fs::path folder = folderOf(options);
  const Shard shard = parseShard(options.shard);
  std::optional<SlurmSubmission> slurm;
  if (!options.why || options.dry_run) slurm = submissionOf(options, folder);
  const int slots = slurm ? slurm->slots() : options.slots.value_or(1);
  std::error_code ignored;
  const bool planned = fs::is_directory(options.sweep, ignored);
  SweepManifest manifest =
      planned ? readManifest(folder) : planSweep(options.sweep, folder, options.allow_many_runs);
  if (planned) refuseOtherPlan(manifest, folder);
  auto interrupt = std::make_unique<Interrupt>();
  if (!planned && !options.dry_run && !options.why) putManifest(manifest, folder);
  const SweepPlan plan(std::move(manifest), folder);
  SweepState state(plan, folder);
  const Shard concerned = options.why ? Shard() : shard;
  forgetLostResults(state, folder, tasksOf(plan, concerned), ResultCheck::contents);
  std::vector<std::size_t> tasks = state.unfinished();
  std::erase_if(tasks, [&](std::size_t task) { return plan.shardOf(task, shard.count) != shard.index - 1; });

  std::ostream& out = options.json ? std::cerr : std::cout;
  out << planText(plan);
  nlohmann::ordered_json why = {{"exit_code", exit_good}};
  if (options.why) {
    const std::vector<TaskReason> reasons = whyTasksRun(state, folder, shard.index - 1, shard.count);
    out << alignedText(whyRows(plan, reasons), 4) << "to run: " << tasks.size() << " of "
        << counted(reasons.size(), "simulation") << "\n";
    printRest(state, out);
    why["why"] = whyJson(plan, reasons);
    if (!options.dry_run && options.json) std::cout << jsonText(why);
    if (!options.dry_run) return exit_good;
  }
  const SweepEstimate estimate =
      estimateSweep(plan, state, tasks, timedFrom(options, slurm, slots, plan.tasks().size()), *interrupt);
  printEstimate(estimate, tasks.size(), plan.tasks().size(), slots, out);
  if (slurm) {
    if (interrupt->requested()) return exit_interrupted;
    const Submitted submitted = slurm->submit(plan, tasks, estimate, out);
    printSubmitted(submitted, options.json);
    if (!submitted.merge_refused.empty()) throw RunError(submitted.merge_refused);
    return exit_good;
  }
  out.flush();
  if (options.dry_run) {
    if (interrupt->requested()) return exit_interrupted;
    nlohmann::ordered_json json = dryRunJson(plan, tasks.size(), estimate, slots);
    if (options.why) json.update(why);
    if (options.json) std::cout << jsonText(json);
    return exit_good;
  }
  return simulate(state, folder, std::move(tasks), slots, options, std::move(interrupt));
}

struct FolderOptions {
  std::string folder;
  bool json = false;
};

int showStatus(const FolderOptions& options) {
  const SweepPlan plan(readManifest(options.folder), options.folder);
  SweepState state(plan, options.folder);
  forgetLostResults(state, options.folder, tasksOf(plan, {}), ResultCheck::size);
  const auto counts = countRuns(plan, state);
  if (options.json) {
    std::cout << jsonText({{"sweep", plan.manifest().settings.name},
                           {"runs", plan.runs()},
                           {"simulations", plan.tasks().size()},
                           {"unfinished_simulations", state.unfinished().size()},
                           {"status", byName(counts)}});
    return exit_good;
  }
  std::cout << planText(plan);
  std::cout << "to do: " << state.unfinished().size() << " of " << counted(plan.tasks().size(), "simulation")
            << "\n";
  printCounts(plan, state);
  printJobs(options.folder, std::cout);
  return exit_good;
}

int mergeFolder(const FolderOptions& options, const std::string& command_line) {
  return finish(SweepPlan(readManifest(options.folder), options.folder), options.folder, options.json,
                command_line);
}

/// A slip of a verb below this one would be taken for a file.
void refuseSlip(const std::string& word) {
  static const std::vector<std::string> verbs{"status", "merge"};
  std::error_code ignored;
  const std::string* meant = fs::exists(word, ignored) ? nullptr : nearestName(word, verbs);
  if (meant) throw InputError("fissure sweep: no file \"" + word + "\", did you mean \"" + *meant + "\"?");
}

Command addFolderVerb(Command parent, const char* name, const char* help, FolderOptions& options) {
  Command command = parent.command(name, help);
  command.option("folder", options.folder, "folder of the sweep").required().notEmpty();
  command.flag("--json", options.json, "for machines, on standard output");
  command.example(std::string("fissure sweep ") + name + " out/speeds");
  return command;
}

void addOptions(Command command, SweepOptions& options) {
  command.option("sweep", options.sweep, "sweep file, or the folder of a sweep to go on with").notEmpty();
  command.option("-o,--output", options.folder, "folder of the sweep; default: out/<the name in the file>")
      .notEmpty();
  command.option("-j,--jobs", options.slots, "simulations side by side; default: 1").between(1, 1024);
  command.flag("--dry-run", options.dry_run, "show what would be done and how long it would take");
  command.flag("--why", options.why, "say of each simulation why it would run, or that it is finished");
  command.flag("--yes", options.allow_many_runs, "plan more than 100,000 runs");
  command.option("--shard", options.shard,
                 "I/N: only this one of N shares of the simulations; then `sweep merge`");
  command.flag("--fail-fast", options.fail_fast, "stop at the first simulation that fails");
  addSlurmOptions(command, options.slurm);
  command.flag("--json", options.json, "what became of the runs, for machines, on standard output");
}

}  // namespace

Verb addSweep(Command app, const std::string& command_line) {
  Command command = app.command("sweep", "run a scenario at many points of its parameters");
  command.example("fissure sweep speeds.yaml --dry-run");
  const auto options = std::make_shared<SweepOptions>();
  options->command_line = command_line;
  addOptions(command, *options);
  const auto folder = std::make_shared<FolderOptions>();
  Command status = addFolderVerb(command, "status", "how far a sweep is, from its files alone", *folder);
  Command merge = addFolderVerb(command, "merge", "write sweep.h5 and sweep.csv of what is there", *folder);
  return {command, [=] {
            if (status.given()) return showStatus(*folder);
            if (merge.given()) return mergeFolder(*folder, command_line);
            if (options->sweep.empty()) throw InputError("sweep: no sweep file is named, expected one");
            refuseSlip(options->sweep);
            return runSweep(*options);
          }};
}

}  // namespace fissure
