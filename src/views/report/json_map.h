#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "report/report_run.h"

namespace fissure {

/// A map in a JSON file that anybody may have written. Every member throws InputError, without a file, where
/// an entry is missing or of another kind: 'missing "cells", expected a list'. The map must outlive it.
class JsonMap {
 public:
  explicit JsonMap(const PageJson& map) : map_(&map) {}

  const PageJson& at(const char* key, const char* expected) const;
  std::string text(const char* key, const char* expected = "a text") const;
  bool truth(const char* key) const;
  std::size_t count(const char* key, const char* expected = "a count") const;
  double number(const char* key) const;          ///< finite
  PageJson numberOrNull(const char* key) const;  ///< null stands for what is not known
  const PageJson& map(const char* key) const;    ///< a map
  const PageJson& list(const char* key) const;   ///< a list
  std::vector<std::string> texts(const char* key) const;

  /// Calls `use` with each entry of a list; its errors begin with the entry's place, "cells.3: ".
  void each(const char* key, const std::function<void(const PageJson& entry)>& use) const;

  /// Throws InputError about a map that is of another format, or of a version above 1.
  void refuseOtherFormat(const char* format) const;

 private:
  [[noreturn]] void refuse(const char* key, const char* expected) const;

  const PageJson* map_;
};

}  // namespace fissure
