#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

namespace fissure::test {

/// Appends a row to the file that FISSURE_CERTIFICATE_TABLE names, if it does: what was asked, how often, how
/// often the truth is a meeting (an overlap), is not decided, and how often the answer was on the safe side
/// only. scripts/certificate_table.py makes results/certificate of it.
inline void addCertificateRow(const std::string& asked, long long count, long long meetings,
                              long long undecided, long long false_meetings) {
  const char* file = std::getenv("FISSURE_CERTIFICATE_TABLE");
  if (file == nullptr) return;
  std::ofstream(file, std::ios::app) << asked << "," << count << "," << meetings << "," << undecided << ","
                                     << false_meetings << "\n";
}

}  // namespace fissure::test
