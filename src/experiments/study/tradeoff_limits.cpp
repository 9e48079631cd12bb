#include "study/tradeoff_limits.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "text/did_you_mean.h"
#include "text/scalars.h"
#include "text/units.h"

namespace fissure {

namespace {

struct SizeUnit {
  std::string_view name;
  std::string_view of;  ///< the unit of the quantity; empty: any, as a share
  double factor;
};

constexpr std::array<SizeUnit, 7> size_units = {{{"mm", "m", 1e-3},
                                                 {"um", "m", 1e-6},
                                                 {"m", "m", 1},
                                                 {"mN", "N", 1e-3},
                                                 {"kN", "N", 1e3},
                                                 {"N", "N", 1},
                                                 {"%", "", 0.01}}};

std::string withoutBlanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

ErrorQuantity quantityNamed(const std::string& name) {
  std::vector<std::string> known;
  for (const CatalogEntry& entry : errorQuantities()) known.emplace_back(entry.name);
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i] == name) return static_cast<ErrorQuantity>(i);
  throw InputError(fmt::format("--max-error: no error of \"{}\"{}", name, didYouMean(name, known)));
}

}  // namespace

const std::vector<CatalogEntry>& errorQuantities() {
  static const std::vector<CatalogEntry> table = {
      {"depth", "penetration depth over time"},
      {"force", "magnitude of a law's force over time"},
      {"reaction", "magnitude of the reaction force over time"},
      {"shape", "distance of the tissue's surface from the reference's, at its snapshots"},
  };
  return table;
}

std::string nameOf(ErrorQuantity quantity) {
  return std::string(errorQuantities()[static_cast<std::size_t>(quantity)].name);
}

std::string unitOf(ErrorQuantity quantity) {
  return quantity == ErrorQuantity::depth || quantity == ErrorQuantity::shape ? "m" : "N";
}

ErrorSize parseErrorSize(const std::string& text, ErrorQuantity quantity, const Origin& origin) {
  const std::string unit = unitOf(quantity);
  const char* const example = unit == "m" ? "0.1mm or 2%" : "0.05N or 2%";
  const std::string plain = withoutBlanks(text);
  for (const SizeUnit& known : size_units) {
    if (!plain.ends_with(known.name) || (!known.of.empty() && known.of != unit)) continue;
    const std::optional<double> number =
        toReal(withoutBlanks(plain.substr(0, plain.size() - known.name.size())));
    if (number && std::isfinite(*number) && *number > 0) return {*number * known.factor, known.of.empty()};
  }
  throw InputError(origin, fmt::format("{} is \"{}\", expected a size above 0 with its unit, as {}",
                                       nameOf(quantity), text, example));
}

std::vector<ErrorLimit> parseErrorLimits(const std::string& text) {
  std::vector<ErrorLimit> limits;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string one = text.substr(from, to - from);
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos)
      throw InputError(
          fmt::format("--max-error: \"{}\" has no \"=\", expected limits as depth=0.1mm,force=2%", one));
    const ErrorQuantity quantity = quantityNamed(withoutBlanks(one.substr(0, equals)));
    for (const ErrorLimit& other : limits)
      if (other.quantity == quantity)
        throw InputError(fmt::format("--max-error: {} twice, expected each quantity once", nameOf(quantity)));
    try {
      limits.push_back({quantity, parseErrorSize(one.substr(equals + 1), quantity, Origin())});
    } catch (const InputError& error) {
      throw InputError(std::string("--max-error: ") + error.text());
    }
    from = to + 1;
  }
  return limits;
}

std::string textOf(const ErrorSize& size, ErrorQuantity quantity) {
  return size.relative ? fourDigits(size.value * 100) + " %" : withUnit(size.value, unitOf(quantity));
}

}  // namespace fissure
