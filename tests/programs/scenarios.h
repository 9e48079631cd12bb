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

/// Nearly all that a result can hold, in 30 steps: two bodies (one partly fixed, with a gauge), a hinged
/// clamp that moves and closes, a spatula that turns, three kinds of force law and what they see, a device's
/// limit, snapshots and frames.
inline std::string fullScenario(
    const std::string& pipelines = "[{pipeline: default}, {pipeline: fukuhara}]") {
  const std::string body =
      "    shape: {type: sphere, radius_m: 0.03, subdivisions: 1}\n"
      "    mass_kg: 0.1\n"
      "    material: {linear_stiffness: 0.5}\n"
      "    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}\n";
  return "format: 1\n"
         "name: full\n"
         "description: A clamp and a turning spatula on two soft spheres.\n"
         "time: {step_s: 0.001, settle_s: 0.005, duration_s: 0.03}\n"
         "ground: {height_m: 0}\n"
         "bodies:\n"
         "  - name: left\n"
         "    position_m: [-0.05, 0.03, 0]\n"
         "    fixed: [{below_m: 0.01}]\n"
         "    gauges: [{name: top, box: {min_m: [-0.09, 0.04, -0.04], max_m: [0, 0.07, 0.04]}}]\n" +
         body +
         "  - name: right\n"
         "    position_m: [0.05, 0.03, 0]\n" +
         body +
         "tools:\n"
         "  - name: spatula\n"
         "    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n"
         "    nodes: {resolution: [4, 4]}\n"
         "    force_limit_N: 2\n"
         "    motion:\n"
         "      type: script\n"
         "      start_m: [-0.05, 0.062, 0]\n"
         "      segments:\n"
         "        - {move_to_m: [-0.05, 0.052, 0], speed_m_s: 0.5}\n"
         "        - {rotate_to: [0, 0.38268343, 0, 0.92387953], duration_s: 0.01}\n"
         "  - name: clamp\n"
         "    shape: {type: box, size_m: [0.004, 0.03, 0.03]}\n"
         "    clamp: {opening: hinged, hinge_height_m: 0.04, jaw_position_m: [0.002, 0, 0]}\n"
         "    nodes: {resolution: [4, 4]}\n"
         "    motion:\n"
         "      type: script\n"
         "      start_m: [0.05, 0.03, 0]\n"
         "      start_opening_deg: 110\n"
         "      segments: [{open_to_deg: 60, duration_s: 0.02}]\n"
         "pipelines: " +
         pipelines +
         "\n"
         "force:\n"
         "  - {name: hc, model: hunt_crossley}\n"
         "  - {name: kv, model: kelvin_voigt, k: 200, c: 2, rate: velocities}\n"
         "  - {name: area, model: linear_elastic, k: 2.3e6, per_area: true, deformation: corotated}\n"
         "record: {snapshots_every_s: 0.005, frames: {every_s: 0.01, size_px: [64, 48]}, force_inputs: "
         "true}\n";
}

/// pressScenario() for ten thousand simulated seconds: for what happens while it runs.
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
