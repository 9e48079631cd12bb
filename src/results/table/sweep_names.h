#pragma once

#include <set>
#include <string>
#include <vector>

namespace fissure {

/// The names of the columns that every sweep's table has.
const std::set<std::string>& fixedSweepColumns();

/// Column names for axes on these scenario paths: the shortest end of each path that is unique and neither in
/// `taken` nor in fixedSweepColumns(), in letters, digits and "_", beginning with a letter. Thus `force.hc.k`
/// gives "k" and `tools.spatula.motion.speed_m_s` gives "speed_m_s".
std::vector<std::string> sweepAxisNames(const std::vector<std::string>& paths,
                                        const std::set<std::string>& taken);

}  // namespace fissure
