#include "sample_study.h"

namespace fissure {

namespace {

using Json = nlohmann::ordered_json;

Json cell(const std::vector<std::string>& values, int round, const Json& kind) {
  Json json = {{"values", values}, {"round", round}, {"wall_s", 0.25}, {"class", kind}};
  json["command"] =
      "fissure run 'ball.yaml' --pipeline 'swept' --no-frames --set 'time.step_s=" + values.back() + "'";
  if (kind.is_null()) return json;
  json["reason"] = kind == "chattering" ? "force of lin swings" : "nothing is wrong";
  if (kind == "chattering") json["frequency_Hz"] = 215.5;
  json["result"] = "steps/swept/runs/a b.h5";
  return json;
}

Json spread(double median) {
  return {{"low", 0.9 * median}, {"median", median}, {"high", 1.2 * median}, {"count", 3}};
}

Json unknownSpread() {
  return {{"low", nullptr}, {"median", nullptr}, {"high", nullptr}, {"count", 0}};
}

Json setting(const std::string& pipeline, const std::string& step_s, double cost_us, const Json& depth_m) {
  const bool good = !depth_m.is_null();
  const Json us = good ? spread(cost_us) : unknownSpread();
  const Json reaction = good ? Json(0.2) : Json();
  return {{"pipeline", pipeline},
          {"values", {{"time.step_s", step_s}, {"tools.blade.nodes.resolution.0", "16"}}},
          {"status", good ? "ok" : "crashed"},
          {"status_detail", good ? "" : "signal 11"},
          {"cost",
           {{"us_per_ms", us},
            {"p99_us_per_ms", us},
            {"us_per_step", us},
            {"p99_us_per_step", us},
            {"processor_s_per_s", us},
            {"memory_mib", us}}},
          {"errors",
           {{"depth", {{"rms", depth_m}, {"worst", depth_m}, {"peak", depth_m}, {"counts", depth_m}}},
            {"reaction", {{"rms", reaction}, {"worst", reaction}, {"peak", reaction}, {"counts", nullptr}}}}},
          {"weighed_error", good ? Json(depth_m.get<double>() / 1e-4) : Json()},
          {"front", good && step_s == "0.001"}};
}

Json reference(const std::string& quantity, const std::string& units, const std::string& refused) {
  const bool kept = refused.empty();
  return {{"pipeline", "swept"},
          {"quantity", quantity},
          {"units", units},
          {"measure", "rms"},
          {"refused", refused},
          {"order", kept ? Json(1.9) : Json()},
          {"own_error", kept ? Json(2e-6) : Json()},
          {"tolerance", kept ? Json(1e-4) : Json()},
          {"peak", 0.003},
          {"peak_at_size_zero", kept ? Json(0.0031) : Json()},
          {"differences_of_rungs", {1e-5, 2.5e-6}}};
}

}  // namespace

Json sampleStability() {
  Json study = {{"format", "fissure-stability"},
                {"format_version", 1},
                {"name", "limits"},
                {"description", "Where </script><b>runs</b> break"},
                {"refine_to", 0.05},
                {"criteria", {{"depth_m", 0.0005}, {"forces", {"lin"}}, {"proved", true}}},
                {"classes",
                 {{{"name", "penetrating"}, {"means", "too deep"}},
                  {{"name", "chattering"}, {"means", "a force swings"}},
                  {{"name", "stable"}, {"means", "none of these"}}}}};
  Json steps = {{"map", "steps"},
                {"description", "speed and step"},
                {"pipeline", "swept"},
                {"axes",
                 {{{"path", "tools.blade.motion.segments.0.speed_m_s"},
                   {"multiplies", Json::array()},
                   {"scale", "linear"},
                   {"grid", {"1", "10", "2"}}},
                  {{"path", "time.step_s"},
                   {"multiplies", Json::array()},
                   {"scale", "logarithmic"},
                   {"grid", {"1e-4", "1e-2"}}}}}};
  for (const char* speed : {"1", "10", "2"}) {
    steps["cells"].push_back(cell({speed, "1e-4"}, 0, "stable"));
    steps["cells"].push_back(cell({speed, "1e-2"}, 0, "chattering"));
  }
  steps["cells"].push_back(cell({"10", "1e-3"}, 1, "stable"));
  steps["cells"].push_back(cell({"10", "3e-3"}, 2, nullptr));
  steps["boundaries"] = {{{"others", {"10"}},
                          {"below", 1e-3},
                          {"above", 1e-2},
                          {"class_below", "stable"},
                          {"class_above", "chattering"}}};
  Json responses = {{"map", "responses"},
                    {"description", "listed"},
                    {"pipeline", "default"},
                    {"axes",
                     {{{"path", "response"},
                       {"multiplies", {"bodies.ball.material.linear_stiffness"}},
                       {"scale", "values"},
                       {"grid", {"momentum", "none"}}}}},
                    {"cells", {cell({"none"}, 0, "penetrating"), cell({"momentum"}, 0, "stable")}},
                    {"boundaries", Json::array()}};
  study["panels"] = {steps, responses};
  return study;
}

Json sampleTradeoff() {
  Json study = {
      {"format", "fissure-tradeoff"},
      {"format_version", 1},
      {"study", "costs"},
      {"description", "Errors of a press"},
      {"cost", "us_per_ms"},
      {"references",
       {reference("depth", "m", ""), reference("reaction", "N", "its differences do not fall")}},
      {"settings",
       {setting("swept", "0.001", 400, 1e-5), setting("swept", "0.002", 200, 4e-5),
        setting("fukuhara", "0.001", 100, 2e-4), setting("fukuhara", "0.002", 210, 3e-4),
        setting("fukuhara", "0.004", 50, nullptr)}},
      {"orders",
       {{{"path", "time.step_s"}, {"pipeline", "swept"}, {"quantity", "depth"}, {"order", spread(2)}}}}};
  for (Json& one : study["settings"])
    one["command"] = "fissure run 'press.yaml' --pipeline '" + one["pipeline"].get<std::string>() +
                     "' --no-frames --set 'time.step_s=" + one["values"]["time.step_s"].get<std::string>() +
                     "'";
  study["answers"] = {{{"wish", "depth at most 50 um"},
                       {"setting", 1},
                       {"nearest", nullptr},
                       {"times_beyond", nullptr},
                       {"scenario", "errors.yaml"},
                       {"again", setting("swept", "0.002", 205, 4e-5)},
                       {"holds", true}},
                      {{"wish", "at most 40 us for a simulated millisecond"},
                       {"setting", nullptr},
                       {"nearest", 2},
                       {"times_beyond", 3.0},
                       {"scenario", ""},
                       {"again", nullptr},
                       {"holds", nullptr}}};
  return study;
}

}  // namespace fissure
