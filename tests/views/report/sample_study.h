#pragma once

#include <nlohmann/json.hpp>

namespace fissure {

/// What `fissure study stability` writes of two maps: one of two axes, one of listed values that has an axis
/// which multiplies.
nlohmann::ordered_json sampleStability();

/// What `fissure study tradeoff` writes of five settings: depth is judged, the reaction's reference refused;
/// the last setting has crashed.
nlohmann::ordered_json sampleTradeoff();

}  // namespace fissure
