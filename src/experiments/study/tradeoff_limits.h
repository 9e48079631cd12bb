#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scenario/catalog.h"

namespace fissure {

/// What errors are of, in the order of errorQuantities().
enum class ErrorQuantity { depth, force, reaction, shape };

/// Their names in study files and on the command line.
const std::vector<CatalogEntry>& errorQuantities();
std::string nameOf(ErrorQuantity quantity);
/// The unit of its values: "m" or "N".
std::string unitOf(ErrorQuantity quantity);

/// The size of an error: in the unit of its quantity, or as a share of the reference's peak.
struct ErrorSize {
  double value = 0;
  bool relative = false;

  /// In the unit of the quantity, for a reference with this peak.
  double absolute(double peak) const { return relative ? value * peak : value; }
};

/// Reads "0.1mm", "20 um", "0.5N" or "2%". Throws InputError from `origin` about any other text, one that is
/// not above 0, and a unit that the quantity does not have.
ErrorSize parseErrorSize(const std::string& text, ErrorQuantity quantity, const Origin& origin);

/// A limit of an error, from `--max-error`.
struct ErrorLimit {
  ErrorQuantity quantity = ErrorQuantity::depth;
  ErrorSize size;
};

/// Reads "depth=0.1mm,force=2%". Throws InputError that begins with `--max-error`.
std::vector<ErrorLimit> parseErrorLimits(const std::string& text);

/// The size for people: "100 um", "2 %".
std::string textOf(const ErrorSize& size, ErrorQuantity quantity);

}  // namespace fissure
