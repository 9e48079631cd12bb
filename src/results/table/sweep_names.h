#pragma once

#include <set>
#include <string>
#include <vector>

namespace fissure {

/// The names that columns of every sweep's table have.
const std::set<std::string>& fixedSweepColumns();

/// Names for the columns of axes on these scenario paths: the shortest end of each path that no other has and
/// that is not `taken` or fixed, in letters, digits and "_", with a letter first: `force.hc.k` "k",
/// `tools.spatula.motion.speed_m_s` "speed_m_s".
std::vector<std::string> sweepAxisNames(const std::vector<std::string>& paths,
                                        const std::set<std::string>& taken);

}  // namespace fissure
