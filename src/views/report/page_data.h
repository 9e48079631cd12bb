#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// The data of the report page of one result. `program`: name of this program, as "fissure 0.1.0 (commit)";
/// `video`: a data URI, may be empty. The page stays below 2 MB for up to four runs of 5,000 steps, without
/// `video` and very long lists of laws, tools and gauges. Throws InputError when the result cannot be read.
/// HDF5 may crash on a damaged file: call it in a child process.
PageJson resultPage(const std::filesystem::path& file, const std::string& program, const std::string& video);

/// One row in the table of a folder's results.
struct FolderEntry {
  std::string name;     ///< path of the result below the folder
  std::string page;     ///< link to its page, relative to the page of the table; empty where there is none
  std::string problem;  ///< why it has no page
  std::string note;     ///< the kind of file, where it is no result; only the title of `info` is then used
  ResultInfo info;      ///< meaningful only without a problem
};

/// The data of the page with that table.
PageJson folderPage(const std::string& folder, const std::string& program,
                    const std::vector<FolderEntry>& entries);

}  // namespace fissure
