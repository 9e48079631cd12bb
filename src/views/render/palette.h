#pragma once

#include <array>
#include <cstdint>

#include "base/tool_nodes.h"

namespace fissure {

/// A colour with 8 bits per channel, as written into the picture (no colour management).
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  std::uint8_t a = 255;  ///< opacity

  bool operator==(const Colour&) const = default;
};

namespace palette {

inline constexpr Colour background{255, 255, 255};
inline constexpr Colour ink{38, 44, 52};  ///< text and scale bar

inline constexpr Colour ground{238, 240, 241};
/// Directly below something that stands on the ground.
inline constexpr Colour ground_shadow{138, 143, 150};
inline constexpr Colour grid{203, 208, 212};

/// Colours of bodies in the scene's order, repeated after the last: flesh, liver, fat.
inline constexpr std::array<Colour, 3> tissue = {{{240, 172, 154}, {196, 116, 104}, {240, 208, 142}}};
inline constexpr Colour tissue_pressed{134, 24, 92};  ///< tissue under the largest pressure of a picture
inline constexpr Colour tissue_inside{128, 44, 46};   ///< faces seen from behind: inverted or cut open
inline constexpr Colour tissue_edge{104, 40, 36, 120};
inline constexpr Colour tissue_outline{112, 46, 40};

inline constexpr Colour steel{176, 186, 196};
inline constexpr Colour steel_edge{44, 54, 66};
inline constexpr Colour hidden_tint{66, 92, 128, 52};  ///< part of a tool behind or inside tissue
inline constexpr Colour hidden_line{20, 52, 110};
inline constexpr Colour cut{136, 0, 24};  ///< intersection of a tool's surface with the tissue's
inline constexpr Colour hidden_cut{136, 0, 24, 120};

/// Colours of node states, indexed by their values, after the colour-blind-safe palette of Okabe and Ito
/// (2008).
inline constexpr std::array<Colour, 4> nodes = {
    {{120, 124, 130}, {0, 158, 115}, {230, 110, 0}, {204, 80, 160}}};
inline constexpr std::array<const char*, 4> node_names = {"free", "feasible", "infeasible", "capped"};

constexpr Colour ofNode(NodeState state) {
  return nodes.at(static_cast<std::size_t>(state));
}

}  // namespace palette
}  // namespace fissure
