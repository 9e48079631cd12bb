#include "report/study_page.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/stability_data.h"
#include "report/tradeoff_data.h"
#include "text/text_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// A file of `fissure study STUDY`, and what the page shows of it.
struct StudyKind {
  const char* file;
  const char* study;
  PageJson (*data)(const PageJson&);
};

constexpr StudyKind study_kinds[] = {{"study.json", "stability", stabilityData},
                                     {"tradeoff.json", "tradeoff", tradeoffData}};

PageJson dataOf(const fs::path& file, const StudyKind& kind) {
  try {
    return kind.data(PageJson::parse(readTextFile(file)));
  } catch (const InputError& error) {
    if (error.isAbout(file)) throw;
    throw InputError(inFile(file), error.text());
  } catch (const PageJson::exception&) {
    throw InputError(inFile(file),
                     std::string("no whole JSON, expected what fissure study ") + kind.study + " writes");
  }
}

}  // namespace

std::vector<fs::path> studyFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const StudyKind& kind : study_kinds)
    if (fs::exists(folder / kind.file, ignored)) files.push_back(folder / kind.file);
  return files;
}

PageJson studyPage(const fs::path& folder, const std::string& link, const std::string& program) {
  std::string title;
  PageJson page = {{"kind", "study"}, {"title", ""}, {"program", program}, {"folder", link}};
  for (const StudyKind& kind : study_kinds) {
    page[kind.study] = nullptr;
    std::error_code ignored;
    if (!fs::exists(folder / kind.file, ignored)) continue;
    page[kind.study] = dataOf(folder / kind.file, kind);
    const std::string name = page[kind.study]["name"];
    if (title != name) title += (title.empty() ? "" : ", ") + name;
  }
  page["title"] = title;
  return page;
}

}  // namespace fissure
