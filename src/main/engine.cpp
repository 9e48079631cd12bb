// The worker: one scenario through one pipeline into one part file.
//   exit 0: the part is finished (its status says ok or non_finite); 2: bad input; 3: failed
#include <malloc.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <optional>

#include "base/error.h"
#include "check/scenario_input.h"
#include "engine/simulation.h"
#include "files/disk_error.h"
#include "files/write_file.h"
#include "main/command.h"
#include "main/exit_codes.h"
#include "measure/probes.h"
#include "pilot/pilot.h"
#include "process/worker.h"
#include "render/offscreen_renderer.h"
#include "run/run.h"
#include "scenario/catalog.h"
#include "scenario/load.h"
#include "store/part_file.h"
#include "task/run_recorder.h"
#include "task/task_order.h"
#include "text/terminal_text.h"
#include "text/text_file.h"

namespace {

using namespace fissure;

/// The largest order that is read: one with ten million force laws. No file that a user writes is as large.
constexpr std::uintmax_t most_order_bytes = std::uintmax_t{4} << 30;

/// Pictures, chunks of files and a step's arrays come and go all the time: memory that was given back to the
/// system after each of them would be cleared page by page before the next.
void keepFreedMemory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
  mallopt(M_TOP_PAD, 16 << 20);
}

const PipelineSettings& findPipeline(const Scenario& scenario, const std::string& name) {
  for (const PipelineSettings& pipeline : scenario.pipelines) {
    if (pipeline.name == name) return pipeline;
  }
  throw InputError("the scenario has no pipeline entry named '" + name + "'");
}

/// Tells the front how far the run is, at most ten times a second.
class ProgressLines {
 public:
  void operator()(std::int64_t step, std::int64_t steps) {
    const auto now = std::chrono::steady_clock::now();
    if (step < steps && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    std::cout << "progress " << step << ' ' << steps << std::endl;
  }

 private:
  std::chrono::steady_clock::time_point last_{};
};

void checkPrecision(const PipelineSettings& pipeline) {
  if (pipeline.precision != enginePrecision())
    throw InputError("the entry '" + pipeline.name + "' wants precision " +
                     nameIn(catalog().precisions, pipeline.precision) + ", this worker is " +
                     nameIn(catalog().precisions, enginePrecision()));
}

/// One run into whatever `make_sink` makes from its layout.
class RunningRun {
 public:
  RunningRun(const LoadedScenario& loaded, const PipelineSettings& pipeline, PreparedScenario prepared)
      : loaded_(loaded), pipeline_(pipeline), run_(loaded.scenario, pipeline, std::move(prepared)) {
    probes_ = makeProbes(loaded.scenario, run_.scene());
    layout_ = declareLayout(probes_);
  }

  const RecordLayout& layout() const { return layout_; }

  std::unique_ptr<RecordSink> makePart(const std::string& part) const {
    return createPartFile(part, {.scenario = loaded_.scenario,
                                 .pipeline = pipeline_,
                                 .scene = run_.scene(),
                                 .layout = layout_,
                                 .expected_steps = run_.stepCount(),
                                 .scenario_resolved = loaded_.resolved});
  }

  /// `pilot`: watches it, where this is one.
  void execute(RecordSink& sink, Pilot* pilot) {
    ProgressLines lines;
    if (pilot) pilot->begin();
    const RunStatus status = run_.execute(
        {.sink = pilot ? pilot->watched(sink) : sink,
         .probes = probes_,
         .layout = layout_,
         .make_frame_source =
             [&](const State& first) {
               return pilot ? pilot->watchedFrames([&] { return makeFrames(first); }) : makeFrames(first);
             },
         .progress =
             [&](std::int64_t step, std::int64_t steps) {
               if (pilot) run_.changeTempo(pilot->stepped());
               lines(step, steps);
             }});
    if (pilot && status.end != RunEnd::ok) throw RunError("the pilot has no end: " + status.detail);
  }

 private:
  std::unique_ptr<FrameSource> makeFrames(const State& first) const {
    return makeOffscreenRenderer(run_.scene(), *loaded_.scenario.record.frames, first);
  }

  const LoadedScenario& loaded_;
  const PipelineSettings& pipeline_;
  Run run_;
  std::vector<std::unique_ptr<Probe>> probes_;
  RecordLayout layout_;
};

void work(const std::string& file, const std::string& directory, const std::string& name,
          const std::string& part, const PilotOrder& options) {
  // As if the file stood where the user's did, so that relative names mean the same.
  LoadedScenario loaded = parseScenario(
      readTextFile(file), std::filesystem::path(directory) / std::filesystem::path(file).filename());
  const PipelineSettings& pipeline = findPipeline(loaded.scenario, name);
  checkPrecision(pipeline);
  PreparedScenario prepared = prepareScenario(loaded.scenario, pipeline.usesNodes());
  std::optional<Pilot> pilot = options.thin(loaded.scenario, prepared);
  RunningRun run(loaded, pipeline, std::move(prepared));
  const auto sink = run.makePart(part);
  run.execute(*sink, pilot ? &*pilot : nullptr);
  options.write(pilot);
}

/// The processor time and the most memory that this process has taken.
void noteUsage(TaskRecord& record) {
  rusage used = {};
  if (::getrusage(RUSAGE_SELF, &used) != 0) return;
  record.timing["timing/worker_processor_s"] =
      static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
      1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  // Not ru_maxrss, which counts what the process was before it became this program.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double memory_kib = 0; word == "VmHWM:" && status >> memory_kib)
      record.timing["timing/worker_memory_mb"] = memory_kib / 1024;
}

/// The scenario of an order, checked as the front checks those that it runs itself.
CheckedScenario scenarioOf(const TaskOrder& order, bool with_part) {
  const std::filesystem::path file = order.directory / order.name;
  LoadedScenario loaded = parseScenario(order.scenario, file, order.overrides);
  RecordSettings& record = loaded.scenario.record;
  if (!with_part) record = {};
  record.force_inputs |= !order.laws.empty();
  return checkLoaded(
      order.name, std::move(loaded),
      {.pipelines = {order.pipeline}, .frames = with_part && order.frames, .expectations = false});
}

/// One simulation of a sweep: its record, and its part where a result is kept.
void workToOrder(const std::string& order_file, const std::string& record, const std::string& part,
                 const PilotOrder& options) {
  const TaskOrder order = parseOrder(readTextFile(order_file, most_order_bytes));
  const auto start = std::chrono::steady_clock::now();
  CheckedScenario checked = [&] {
    try {
      return scenarioOf(order, !part.empty());
    } catch (const InputError& error) {
      throw aboutAxis(error);
    }
  }();
  const PipelineSettings& pipeline = checked.loaded.scenario.pipelines.front();
  checkPrecision(pipeline);
  std::optional<Pilot> pilot = options.thin(checked.loaded.scenario, checked.prepared);
  RunningRun run(checked.loaded, pipeline, std::move(checked.prepared));
  RunRecorder::Settings settings;
  if (order.curves) {
    settings.curves = curveQuantities(order.curves->quantities, run.layout(), "curves.quantities");
    settings.times_s = curveTimes_s(*order.curves);
  }
  std::optional<LawStatistics> laws;
  if (!order.laws.empty()) settings.laws = &laws.emplace(order.laws, checked.loaded.scenario.force);
  std::unique_ptr<RecordSink> sink;
  if (!part.empty()) sink = run.makePart(part);
  settings.next = sink.get();
  RunRecorder recorder(run.layout(), settings);
  run.execute(recorder, pilot ? &*pilot : nullptr);
  options.write(pilot);
  TaskRecord done = recorder.record();
  done.timing["timing/simulation_wall_s"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  noteUsage(done);
  writeFile(record, encodeRecord(done));
}

int parseAndWork(int argc, const char* const* argv) {
  PlainOutput plain_out(std::cout);
  CommandLine line(
      "fissure's worker: one scenario through one pipeline into one part file (started by fissure)");
  std::string scenario, directory, pipeline, part, order, record;
  PilotOrder pilot;
  Command root = line.root();
  root.option("--scenario", scenario, "scenario file, resolved");
  root.option("--directory", directory, "where the scenario's relative file names start");
  root.option("--pipeline", pipeline, "name of the pipeline entry to run");
  root.option("--part", part, "part file to write");
  root.option("--order", order, "instead of a scenario: file with a simulation of a sweep");
  root.option("--record", record, "file for the sweep's record of it");
  root.option("--pilot", pilot.one_in, "about one of so many steps, the tools on the same path");
  root.option("--forecast", pilot.forecast, "file for how long the whole would take, by that pilot");
  const CommandLine::Outcome parsed = line.parse(argc, argv);
  if (parsed.done) {
    plain_out.requireWritten("standard output");
    return exit_good;
  }
  if (!parsed.error.empty()) throw InputError(parsed.error);
  if (order.empty() ? scenario.empty() || directory.empty() || pipeline.empty() || part.empty()
                    : record.empty())
    throw InputError("expected --scenario, --directory, --pipeline and --part, or --order and --record");
  if (order.empty())
    work(scenario, directory, pipeline, part, pilot);
  else
    workToOrder(order, record, part, pilot);
  return exit_good;
}

}  // namespace

int main(int argc, char** argv) {
  keepFreedMemory();
  try {
    return parseAndWork(argc, argv);
  } catch (const InputError& error) {
    std::cerr << "error: " << error.what() << '\n';
    return exit_usage;
  } catch (const DiskError& error) {
    std::cerr << "error: " << error.what() << '\n';
    return exit_unwritten;
  } catch (const std::bad_alloc&) {
    std::cerr << "error: out of memory\n";
    return exit_run_failed;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return exit_run_failed;
  }
}
