#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// The files study.json and tradeoff.json of `fissure study` in a folder, those that are there.
std::vector<std::filesystem::path> studyFilesIn(const std::filesystem::path& folder);

/// The data of the page of the studies in a folder, a section each. `link`: where the folder is, as the page
/// links to it, ending with '/', or empty. `program` as for resultPage(). Throws InputError about a file that
/// is damaged, of something else, or of a newer version.
PageJson studyPage(const std::filesystem::path& folder, const std::string& link, const std::string& program);

}  // namespace fissure
