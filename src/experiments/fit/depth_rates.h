#pragma once

#include <vector>

namespace fissure {

/// Rate of the depth, m/s: the slope of the parabola through a point and its neighbours in time, a mean of
/// the slopes to both, so that it never lies outside them: depths that only grow have no negative rate. At
/// both ends the slope to the neighbour. Points of equal time count as one, with their mean depth. Times
/// never go back.
std::vector<double> ratesOf(const std::vector<double>& time_s, const std::vector<double>& depth_m);

/// Roughly the standard deviation of each of these rates, m/s, that noise of the depths makes, where it is
/// independent from time to time. A point's noise is what the nearest five of different times miss a
/// polynomial of degree three by (pseudo-residuals, as Gasser, Sroka and Jennen-Steinmetz 1986, Biometrika
/// 73, use them): single values scatter, their mean square over many points does not. 0 where there are
/// fewer than five times.
std::vector<double> rateNoiseOf(const std::vector<double>& time_s, const std::vector<double>& depth_m);

}  // namespace fissure
