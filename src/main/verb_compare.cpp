#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "files/output_claim.h"
#include "main/comparison.h"
#include "main/exit_codes.h"
#include "main/result_json.h"
#include "main/verbs.h"
#include "process/apart.h"
#include "store/reference_file.h"

namespace fissure {

namespace {

struct CompareOptions {
  std::string a, b;
  std::string tolerance_file;
  CompareSettings settings;
  bool all = false, json = false, update = false;
};

/// Reads every value once, apart: what is damaged deep inside a file is found before it is compared.
ResultInfo readWhole(const std::filesystem::path& file) {
  tryReading(file, [&] {
    for (const PipelineResult& run : readResultInfo(file).pipelines) {
      const RunReader reader(file, run.name);
      for (const StoredQuantity& quantity : reader.quantities())
        for (std::size_t row = 0; row < quantity.rows; row += 1024)
          reader.rows(quantity, row, std::min<std::size_t>(1024, quantity.rows - row));
    }
  });
  ResultInfo info = readResultInfo(file);
  if (!info.complete) throw InputError(inFile(file), "not complete, expected a finished result");
  return info;
}

int finish(const ResultComparison& comparison, const CompareOptions& options) {
  const int code = comparison.agrees() ? exit_good : exit_differs;
  if (options.json) {
    nlohmann::ordered_json json = {{"exit_code", code}};
    json.update(comparisonJson(comparison));
    std::cout << jsonText(json);
  } else {
    std::cout << comparisonText(comparison, options.all);
  }
  return code;
}

int failWithoutReference(const std::string& message) {
  std::cerr << message << "\n";
  return exit_differs;
}

int compare(const CompareOptions& options) {
  const ResultChoice a = parseChoice(options.a);
  ResultChoice b = parseChoice(options.b);
  if (b.file.empty()) b.file = a.file;  // ":NAME"
  const ResultInfo info_a = readWhole(a.file);
  ResultInfo info_b;
  try {
    info_b = readWhole(b.file);
  } catch (const InputError& error) {
    return failWithoutReference(std::string(error.what()) + " (nothing to compare with)");
  }
  return finish(compareResults(a, info_a, b, info_b, options.settings), options);
}

/// A reference must be worth comparing with: it agrees with itself, so holds no NaN, and all its runs are
/// whole.
void refuseAsReference(const ResultChoice& a, const ResultInfo& info) {
  if (!a.run.empty())
    throw InputError(inFile(a.file), "--update takes whole results, expected no run's name");
  for (const PipelineResult& run : info.pipelines)
    if (run.status.end != RunEnd::ok)
      throw InputError(inFile(a.file), "run " + run.name + " is " + nameOf(run.status.end) +
                                           ", expected only runs that are ok in a reference");
  const ResultComparison self = compareResults(a, info, a, info, {});
  for (const RunComparison& run : self.runs)
    for (const QuantityComparison& made : run.quantities)
      if (!made.agrees)
        throw InputError(inFile(a.file), run.a.run->name + "/" + made.quantity + ": " + made.problem +
                                             ", expected numbers in a reference");
}

int update(const CompareOptions& options) {
  const ResultChoice a = parseChoice(options.a), b = parseChoice(options.b);
  if (!b.run.empty() || b.file.empty())
    throw InputError(options.b + ": --update writes a file, expected its name alone");
  std::error_code missing;
  if (std::filesystem::equivalent(a.file, b.file, missing))
    throw InputError(inFile(b.file), "is the result itself, expected another name for the reference");
  const ResultInfo info_a = readWhole(a.file);
  refuseAsReference(a, info_a);
  if (std::filesystem::exists(b.file)) {
    try {
      const ResultInfo info_b = readWhole(b.file);
      if (!info_b.reference) throw InputError(inFile(b.file), "is no reference, expected one to replace");
      const ResultComparison old = compareResults(a, info_a, b, info_b, {{}, true});
      if (old.agrees()) {
        std::cout << "reference: " << b.file.string() << " is up to date\n";
        return exit_good;
      }
      std::cout << comparisonText(old, false);
    } catch (const InputError& error) {
      if (std::filesystem::file_size(b.file) > 0) throw;
    }
  }
  const OutputClaim claim(b.file, true);
  writeReference(b.file, a.file);
  std::cout << "reference: " << b.file.string() << " written from " << a.file.string() << "\n";
  return exit_good;
}

}  // namespace

Verb addCompare(Command app) {
  const auto problemOfChoice = [](const std::string& text) {
    return text.empty() || text.back() == ':' ? "\"" + text + "\" names no file or run" : std::string();
  };
  const auto options = std::make_shared<CompareOptions>();
  Command command = app.command("compare", "how two results, or two runs of one, differ");
  command.example("fissure compare new.h5 old.h5 --tolerance tolerances.yaml");
  command.option("A", options->a, "result file, or FILE:NAME for one run of it")
      .required()
      .check(problemOfChoice);
  command
      .option("B", options->b,
              "what it is compared with: a result, a reference, FILE:NAME, or :NAME of the same file")
      .required()
      .check(problemOfChoice);
  command.option("--tolerance", options->tolerance_file,
                 "YAML file with a tolerance per quantity; without it nothing may differ");
  command.flag("--exact", options->settings.exact, "bit for bit, whatever the tolerances say");
  command
      .option("--max-shift", options->settings.max_shift_s, "how far a shift in time is looked for, seconds")
      .between(0.0, 1e6)
      .showDefault();
  command.flag("--all", options->all, "show equal quantities too");
  command.flag("--json", options->json, "the comparison for machines");
  command.flag("--update", options->update,
               "make B a small reference of A: the same summaries, a few rows of each series, no pictures");
  return {command, [options] {
            if (!options->tolerance_file.empty())
              options->settings.tolerances = loadTolerances(options->tolerance_file);
            return options->update ? update(*options) : compare(*options);
          }};
}

}  // namespace fissure
