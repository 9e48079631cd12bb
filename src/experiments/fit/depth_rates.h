#pragma once

#include <vector>

namespace fissure {

/// Rates of the depth at the points, m/s: the slope of the parabola through a point and its neighbours in
/// time, and at both ends the slope to the neighbour. It is a weighted mean of the slopes to both neighbours,
/// so that depths which only grow have no negative rate. Points of equal time count as one, with their mean
/// depth. Times must not decrease.
std::vector<double> ratesOf(const std::vector<double>& time_s, const std::vector<double>& depth_m);

/// Estimated standard deviation of each of these rates, m/s, that follows from noise of the depths, assumed
/// independent between times. The noise at a point is the deviation of the five nearest points of different
/// times from a polynomial of degree three (pseudo-residuals, as in Gasser, Sroka and Jennen-Steinmetz 1986,
/// Biometrika 73); single values scatter, their mean square over many points does not. 0 where there are
/// fewer than five times.
std::vector<double> rateNoiseOf(const std::vector<double>& time_s, const std::vector<double>& depth_m);

}  // namespace fissure
