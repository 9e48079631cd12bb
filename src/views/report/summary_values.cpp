#include "report/summary_values.h"

namespace fissure {

std::optional<double> numberOf(const SummaryValue& value) {
  if (const double* real = std::get_if<double>(&value.value)) return *real;
  if (const long long* count = std::get_if<long long>(&value.value)) return static_cast<double>(*count);
  return std::nullopt;
}

const SummaryValue* findValue(const Summary& summary, const std::string& name) {
  for (const SummaryValue& value : summary)
    if (value.name == name) return &value;
  return nullptr;
}

}  // namespace fissure
