#include "keys/templates.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "files/write_file.h"
#include "keys/template_assets.h"
#include "scenario/scenario.h"

namespace fissure {

namespace {

/// A file of a template; its name begins with the template's.
struct TemplateFile {
  std::string_view ending;
  std::string_view text;
};

struct Template {
  CatalogEntry entry;
  std::vector<TemplateFile> files;
};

const std::vector<Template>& all() {
  using namespace assets;
  static const std::vector<Template> table = {
      {{"press", "a spatula pressed into a soft sphere, by three pipelines"}, {{".yaml", press_yaml}}},
      {{"clamp", "a clamp that grasps a soft sphere"}, {{".yaml", clamp_yaml}}},
      {{"fissure", "a spatula that opens the slit between two lobes"}, {{".yaml", fissure_yaml}}},
      {{"replay", "a recorded hand, with a small log beside it"},
       {{".yaml", replay_yaml}, {".csv", replay_csv}}},
      {{"organ", "an organ from a mesh file, with a small one beside it"},
       {{".yaml", organ_yaml}, {".obj", organ_obj}}},
      {{"elastic", "tissue with Young's modulus, whose forces are in newtons"}, {{".yaml", elastic_yaml}}},
      {{"sweep", "many runs over speed and thickness of a blade, with their scenario beside them"},
       {{".yaml", sweep_yaml}, {"_scene.yaml", sweep_scene_yaml}}}};
  return table;
}

/// Puts `name` in the place of the template's own in what it says of itself and of its files.
std::string renamed(std::string_view text, const Template& from, const std::string& name) {
  std::string made(text);
  const auto replace = [&](const std::string& old, const std::string& with) {
    for (std::size_t at = 0; (at = made.find(old, at)) != std::string::npos; at += with.size())
      made.replace(at, old.size(), with);
  };
  const std::string_view kind(from.entry.name);
  for (const TemplateFile& file : from.files) {
    const std::string_view ending = file.ending, stem = ending.substr(0, ending.find('.'));
    replace(fmt::format(" {}{}", kind, ending), fmt::format(" {}{}", name, ending));
    replace(fmt::format("\nname: {}{}\n", kind, stem), fmt::format("\nname: {}{}\n", name, stem));
  }
  return made;
}

}  // namespace

const std::vector<CatalogEntry>& templates() {
  static const std::vector<CatalogEntry> entries = [] {
    std::vector<CatalogEntry> made;
    for (const Template& one : all()) made.push_back(one.entry);
    return made;
  }();
  return entries;
}

std::vector<std::filesystem::path> writeTemplate(const std::string& kind, const std::string& name,
                                                 const std::filesystem::path& folder) {
  const Template& from =
      *std::find_if(all().begin(), all().end(), [&](const Template& one) { return one.entry.name == kind; });
  std::vector<std::filesystem::path> files;
  for (const TemplateFile& file : from.files) {
    if (!isName(name + std::string(file.ending.substr(0, file.ending.find('.')))))
      throw InputError("name is \"" + name + "\", expected 1 to 58 letters, digits, '_' or '-'");
    files.push_back(folder / (name + std::string(file.ending)));
    if (std::filesystem::exists(std::filesystem::symlink_status(files.back())))
      throw InputError(inFile(files.back()), "exists already, expected a new name");
  }
  for (std::size_t i = 0; i < files.size(); ++i)
    replaceFile(files[i], renamed(from.files[i].text, from, name));
  return files;
}

}  // namespace fissure
