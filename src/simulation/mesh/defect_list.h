#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"

namespace fissure {

/// What an inspection found wrong: a list of structs of a kind, a count and a line about them.
template <class Defect>
class DefectList {
 public:
  using Kind = decltype(Defect::kind);

  /// Adds "`count` `one`/`many` (`meaning`)" when there is any.
  void add(Kind kind, std::size_t count, const std::string& one, const std::string& many,
           const std::string& meaning) {
    if (count == 0) return;
    defects_.push_back({kind, count, counted(count, one, many) + " (" + meaning + ")"});
  }
  void add(Kind kind, const std::string& text) { defects_.push_back({kind, 1, text}); }
  std::vector<Defect> take() { return std::move(defects_); }

 private:
  std::vector<Defect> defects_;
};

}  // namespace fissure
