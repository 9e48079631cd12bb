#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"

namespace fissure {

/// Collects the defects that an inspection finds, as structs of a kind, a count and a line of text.
template <class Defect>
class DefectList {
 public:
  using Kind = decltype(Defect::kind);

  /// Adds a defect with the text "`count` `one`/`many` (`meaning`)" unless `count` is 0.
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
