#pragma once

#include <string>
#include <vector>

namespace fissure::programs {

/// A thin blade 1 mm above a sphere of 32 triangles on the ground, pressed down at 0.5 m/s: in contact after
/// 2 ms. `pipelines`: the text of that list; `duration`: seconds, as text; `more`: further keys of the
/// scenario.
inline std::string pressScenario(const std::string& pipelines = "[{pipeline: fukuhara}]",
                                 const std::string& duration = "0.03", const std::string& more = "") {
  return "format: 1\n"
         "name: press\n"
         "description: A blade pressed into a soft sphere.\n"
         "time: {step_s: 0.001, settle_s: 0.005, duration_s: " +
         duration +
         "}\n"
         "ground: {height_m: 0}\n"
         "bodies:\n"
         "  - name: sphere\n"
         "    shape: {type: sphere, radius_m: 0.03, subdivisions: 1}\n"
         "    position_m: [0, 0.03, 0]\n"
         "    mass_kg: 0.1\n"
         "    material: {linear_stiffness: 0.5}\n"
         "    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}\n"
         "tools:\n"
         "  - name: spatula\n"
         "    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n"
         "    nodes: {resolution: [4, 4]}\n"
         "    motion:\n"
         "      type: script\n"
         "      start_m: [0, 0.062, 0]\n"
         "      segments:\n"
         "        - {move_to_m: [0, 0.052, 0], speed_m_s: 0.5}\n"
         "pipelines: " +
         pipelines + "\n" + more;
}

/// The same for ten thousand simulated seconds: for what happens while it runs.
inline std::string endlessScenario(const std::string& pipelines = "[{pipeline: fukuhara}]",
                                   const std::string& more = "") {
  return pressScenario(pipelines, "10000", more);
}

/// `text` with `from`, which must be in it, replaced by `to`.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? "test error: no " + from : text.replace(at, from.size(), to);
}

}  // namespace fissure::programs
