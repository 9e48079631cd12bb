#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.h"
#include "batch/build_info.h"
#include "files/output_claim.h"
#include "main/exit_codes.h"
#include "main/page_file.h"
#include "main/verbs.h"
#include "process/apart.h"
#include "process/interrupt.h"
#include "report/history_page.h"
#include "report/page.h"
#include "report/page_data.h"
#include "report/study_page.h"
#include "report/sweep_page.h"
#include "report/video.h"
#include "table/sweep_table.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string input;
  std::string output;
  std::string video;
  bool force = false;
};

std::string program() {
  return "fissure " + buildInfo().version + " (" + buildInfo().commit.substr(0, 12) + ")";
}

/// The page of one result. Throws InputError about it, also where HDF5 crashes on it.
void writeResultPage(const fs::path& result, const fs::path& output, const ReportOptions& options) {
  const OutputClaim claim(output, options.force);
  Allowance allowance = allowanceFor(result);
  allowance.processor_s += 20;  // drawing pictures, in a build with sanitizers too
  try {
    writePageApart(
        output,
        [&] {
          if (isSweepTable(result)) {
            if (!options.video.empty()) throw InputError("--video: is of one result, expected no sweep");
            return pageText(sweepPage(result, program()));
          }
          return pageText(
              resultPage(result, program(), options.video.empty() ? "" : videoUri(options.video)));
        },
        allowance);
  } catch (const LostApart& lost) {
    throw InputError(inFile(result), std::string("a damaged file (") + lost.what() + ")");
  }
}

/// Files that may be results, below `folder`, by name; not within hidden folders, where unfinished runs live.
std::vector<fs::path> resultsBelow(const fs::path& folder) {
  std::vector<fs::path> results;
  std::error_code error, ignored;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
  while (!error && entry != end) {
    const bool hidden = entry->path().filename().string().starts_with('.');
    if (hidden && entry->is_directory(ignored)) entry.disable_recursion_pending();
    // A link to nowhere is one too: its row says what is wrong with it.
    const bool file = entry->is_regular_file(ignored) || entry->is_symlink(ignored);
    if (!hidden && entry->path().extension() == ".h5" && file && !entry->is_directory(ignored))
      results.push_back(entry->path());
    entry.increment(error);
  }
  if (error) throw InputError(inFile(folder), "cannot be read: " + error.message());
  std::sort(results.begin(), results.end());
  return results;
}

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code missing;
  return fs::equivalent(a, b, missing);
}

/// The page of a result lies beside the table as the result lies in its folder.
fs::path pageName(const fs::path& result, const fs::path& folder) {
  return fs::path(result.lexically_relative(folder)).replace_extension(".html");
}

FolderEntry reportOne(const fs::path& result, const fs::path& table, const ReportOptions& options) {
  const fs::path page = pageName(result, options.input);
  FolderEntry entry;
  entry.name = result.lexically_relative(options.input).generic_string();
  try {
    writeResultPage(result, table.parent_path() / page, options);
    if (isSweepTable(result)) {
      const SweepTable sweep(result);
      entry.info.title = sweep.layout().title;
      entry.note = "a sweep of " + std::to_string(sweep.runs()) + " runs";
    } else {
      entry.info = readResultInfo(result);
    }
    entry.page = linkTo(page);
  } catch (const InputError& error) {
    entry.problem = error.isAbout(result) ? error.text() : error.what();
  }
  return entry;
}

/// Nothing is begun that would be refused half-way.
void checkPages(const std::vector<fs::path>& results, const fs::path& table, const ReportOptions& options) {
  for (const fs::path& result : results) {
    const fs::path page = table.parent_path() / pageName(result, options.input);
    if (sameFile(result, table))
      throw InputError(inFile(table), "is a result itself, expected another name for the page");
    if (page.lexically_normal() == table.lexically_normal())
      throw InputError(inFile(table),
                       "is the page of " + result.string() + " too, expected another name for the table");
    if (std::error_code ignored; !options.force && fs::exists(page, ignored))
      throw InputError(inFile(page), "exists already, expected another folder or --force");
  }
}

int stopped() {
  std::cerr << "interrupted: finished pages are kept\n";
  return exit_interrupted;
}

/// The page would take the place of one of the files that it shows.
void refuseOneOf(const std::vector<fs::path>& files, const fs::path& output) {
  for (const fs::path& file : files)
    if (sameFile(file, output))
      throw InputError(inFile(output), "is one of its files, expected another name for the page");
}

/// The history of benchmarks in a folder that holds files of scripts/bench and no results.
int reportHistory(const ReportOptions& options, const fs::path& output) {
  refuseOneOf(benchFilesIn(options.input), output);
  const OutputClaim claim(output, options.force);
  const BenchHistory history = readBenchHistory(options.input);
  const std::string name = fs::canonical(options.input).filename().string();
  writePageApart(output, [&] { return pageText(historyPage(name, program(), history)); },
                 {.processor_s = 60});
  for (const BenchHistory::Problem& problem : history.problems)
    std::cout << "not shown: " << problem.file << ": " << problem.text << "\n";
  std::cout << "page: " << output.string() << "\n";
  return exit_good;
}

/// The studies in a folder that `fissure study` has filled; the results of their runs have no pages then.
int reportStudy(const ReportOptions& options) {
  if (!options.video.empty()) throw InputError("--video: is of one result, expected no study");
  const fs::path folder = options.input;
  const fs::path output = options.output.empty() ? folder / "index.html" : fs::path(options.output);
  refuseOneOf(studyFilesIn(folder), output);
  const OutputClaim claim(output, options.force);
  const fs::path way = fs::weakly_canonical(fs::absolute(folder))
                           .lexically_relative(fs::weakly_canonical(fs::absolute(output)).parent_path());
  try {
    writePageApart(output, [&] { return pageText(studyPage(folder, linkTo(way) + "/", program())); },
                   {.processor_s = 60});
  } catch (const LostApart& lost) {
    throw InputError(inFile(folder), std::string("a damaged study (") + lost.what() + ")");
  }
  std::cout << "page: " << output.string() << "\n";
  return exit_good;
}

int reportFolder(const ReportOptions& options) {
  if (!options.video.empty()) throw InputError("--video: is of one result, expected no folder beside it");
  const fs::path table =
      options.output.empty() ? fs::path(options.input) / "index.html" : fs::path(options.output);
  const std::vector<fs::path> results = resultsBelow(options.input);
  if (results.empty() && !benchFilesIn(options.input).empty()) return reportHistory(options, table);
  if (results.empty()) throw InputError(inFile(options.input), "holds no result, expected *.h5 files");
  checkPages(results, table, options);
  const OutputClaim claim(table, options.force);
  Interrupt interrupt;
  std::vector<FolderEntry> entries;
  entries.reserve(results.size());
  for (const fs::path& result : results) {
    if (interrupt.requested()) return stopped();
    entries.push_back(reportOne(result, table, options));
  }
  const std::string name = fs::canonical(options.input).filename().string();
  writePageApart(table, [&] { return pageText(folderPage(name, program(), entries)); }, {.processor_s = 60});
  for (const FolderEntry& entry : entries)
    if (!entry.problem.empty()) std::cout << "no page: " << entry.name << ": " << entry.problem << "\n";
  std::cout << "page: " << table.string() << "\n";
  return exit_good;
}

/// A folder that a sweep has made is that sweep's.
ReportOptions sweepOf(ReportOptions options) {
  const fs::path table = fs::path(options.input) / "sweep.h5";
  std::error_code ignored;
  if (fs::is_directory(options.input, ignored) && fs::is_regular_file(table, ignored))
    options.input = table.string();
  return options;
}

int reportResult(const ReportOptions& options) {
  const fs::path output =
      options.output.empty() ? fs::path(options.input).replace_extension(".html") : fs::path(options.output);
  refuseInput(options.input, output);
  Interrupt interrupt;  // a page is there whole or not at all
  writeResultPage(options.input, output, options);
  if (interrupt.requested()) return stopped();
  std::cout << "page: " << output.string() << "\n";
  return exit_good;
}

}  // namespace

Verb addReport(Command app) {
  const auto options = std::make_shared<ReportOptions>();
  Command command = app.command(
      "report",
      "one page for a browser that shows a result, a sweep, a study, a table of all below a folder, or "
      "benchmarks");
  command.example("fissure report out/press.h5");
  command
      .option("RESULT", options->input,
              "result file, sweep.h5, a sweep's or a study's folder (the page is the study's, whatever "
              "results are below), a folder with result files below it, or with files of scripts/bench")
      .required()
      .notEmpty();
  command
      .option("-o,--output", options->output,
              "page; default: the result's name with .html, or index.html in the folder. The pages of a "
              "folder's results lie beside it")
      .notEmpty();
  command.option("--video", options->video, "MP4 or WebM file that becomes part of the page, at most 16 MB")
      .notEmpty();
  command.flag("--force", options->force, "replace existing pages");
  return {command, [options] {
            std::error_code ignored;
            const ReportOptions resolved = sweepOf(*options);
            try {
              if (!studyFilesIn(options->input).empty()) return reportStudy(*options);
              return fs::is_directory(resolved.input, ignored) ? reportFolder(resolved)
                                                               : reportResult(resolved);
            } catch (const Interrupted&) {
              return stopped();
            }
          }};
}

}  // namespace fissure
