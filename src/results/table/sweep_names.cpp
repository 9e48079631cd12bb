#include "table/sweep_names.h"

#include <algorithm>
#include <cctype>

namespace fissure {

namespace {

/// The last `pieces` pieces of a path, joined with "_".
std::string ending(const std::vector<std::string>& pieces, std::size_t count) {
  std::string name;
  for (std::size_t i = pieces.size() - std::min(count, pieces.size()); i < pieces.size(); ++i)
    name += (name.empty() ? "" : "_") + pieces[i];
  return name;
}

std::vector<std::string> piecesOf(const std::string& path) {
  std::vector<std::string> pieces(1);
  for (const char c : path) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
      pieces.back() += c;
    else if (!pieces.back().empty())
      pieces.emplace_back();
  }
  if (pieces.back().empty()) pieces.pop_back();
  return pieces;
}

bool letterFirst(const std::string& name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0;
}

}  // namespace

const std::set<std::string>& fixedSweepColumns() {
  static const std::set<std::string> names = {"run",        "point",         "pipeline", "repeat",
                                              "status",     "status_detail", "file",     "law",
                                              "curve_time", "measured",      "timing",   "provenance"};
  return names;
}

std::vector<std::string> sweepAxisNames(const std::vector<std::string>& paths,
                                        const std::set<std::string>& taken) {
  std::vector<std::vector<std::string>> pieces;
  for (const std::string& path : paths) pieces.push_back(piecesOf(path));
  std::vector<std::string> names;
  std::set<std::string> given;
  for (const std::vector<std::string>& own : pieces) {
    const auto free = [&](std::size_t count) {
      const std::string name = ending(own, count);
      const auto alike = [&](const auto& other) { return ending(other, count) == name; };
      return letterFirst(name) && !taken.contains(name) && !fixedSweepColumns().contains(name) &&
             !given.contains(name) && std::count_if(pieces.begin(), pieces.end(), alike) == 1;
    };
    std::size_t count = 1;
    while (count < own.size() && !free(count)) ++count;
    std::string name = ending(own, count);
    // Not even the whole path is a name that nobody has.
    if (!free(count)) name.insert(0, "axis_");
    while (taken.contains(name) || given.contains(name)) name += "_";
    given.insert(name);
    names.push_back(name);
  }
  return names;
}

}  // namespace fissure
