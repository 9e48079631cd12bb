#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// What the report page of one result shows; `program`: what makes the page, "fissure 0.1.0 (commit)". The
/// page stays below 2 MB for up to four runs of 5,000 steps; only longer lists of laws, tools and gauges, and
/// `video` (a data URI, may be empty), take it beyond. Throws InputError when the result cannot be read;
/// whether HDF5 crashes on it is not known here.
PageJson resultPage(const std::filesystem::path& file, const std::string& program, const std::string& video);

/// One file in the table of a folder's results.
struct FolderEntry {
  std::string name;     ///< of the result, from the folder on
  std::string page;     ///< link to its page, from the table's page on; empty where there is none
  std::string problem;  ///< why it has no page
  std::string note;     ///< what it is, where it is no result; of `info` only the title counts then
  ResultInfo info;      ///< where it has one
};

/// What the page with that table shows.
PageJson folderPage(const std::string& folder, const std::string& program,
                    const std::vector<FolderEntry>& entries);

}  // namespace fissure
