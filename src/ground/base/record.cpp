#include "base/record.h"

#include <algorithm>
#include <stdexcept>

namespace fissure {

void RecordLayout::addAxis(const RecordAxis& axis) {
  for (const RecordAxis& known : axes_) {
    if (known.name != axis.name) continue;
    if (known.labels != axis.labels) throw std::logic_error("record axis declared twice: " + axis.name);
    return;
  }
  axes_.push_back(axis);
}

std::size_t RecordLayout::add(Series series) {
  if (find(series.name)) throw std::logic_error("record series declared twice: " + series.name);
  series.columns = 1;
  for (const std::string& name : series.axes) series.columns *= axis(name).labels.size();
  series.first_column = columns_;
  columns_ += series.columns;
  series_.push_back(std::move(series));
  return series_.back().first_column;
}

const RecordAxis& RecordLayout::axis(const std::string& name) const {
  const auto found =
      std::find_if(axes_.begin(), axes_.end(), [&](const RecordAxis& a) { return a.name == name; });
  if (found == axes_.end()) throw std::logic_error("record axis not declared: " + name);
  return *found;
}

const Series* RecordLayout::find(const std::string& name) const {
  const auto found =
      std::find_if(series_.begin(), series_.end(), [&](const Series& s) { return s.name == name; });
  return found == series_.end() ? nullptr : &*found;
}

}  // namespace fissure
