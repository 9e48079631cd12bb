#pragma once

#include <optional>
#include <string>

#include "base/record.h"

namespace fissure {

/// A summary value as a number; no value where it is a text.
std::optional<double> numberOf(const SummaryValue& value);

/// The value of that name; null when there is none.
const SummaryValue* findValue(const Summary& summary, const std::string& name);

}  // namespace fissure
