#include "measure/touch.h"

#include <algorithm>
#include <limits>
#include <span>

namespace fissure {

Touch::Touch(const Scene& scene) {
  for (const SceneBody& body : scene.bodies)
    bodies_.push_back({static_cast<std::size_t>(body.first_vertex), body.rest.vertices_m.size()});
  for (const SceneTool& tool : scene.tools) tools_.push_back({tool.name, ToolShape(tool)});
}

void Touch::add(const State& state, const PenetrationMeter& meter, const Penetration& found) {
  // Negated, so that a depth that is no number counts.
  add(state, meter, !(found.depth_m <= 0) || found.passed_through > 0);
}

void Touch::addUnmeasured(const State& state, const PenetrationMeter& meter) {
  add(state, meter, false);
}

void Touch::add(const State& state, const PenetrationMeter& meter, bool inside) {
  const std::span<const std::uint8_t> contacts = state.contact.vertex_contact;
  for (Body& body : bodies_) {
    // Which body a tool is in without a contact, the meter does not say: any may be.
    body.now = inside || (contacts.empty() && state.contact.contact_count > 0);
    for (std::size_t v = 0; v < (contacts.empty() ? 0 : body.vertex_count) && !body.now; ++v)
      body.now = contacts[body.first_vertex + v] != 0;
    body.ever = body.ever || body.now;
  }
  const bool any = state.contact.contact_count > 0 ||
                   std::any_of(bodies_.begin(), bodies_.end(), [](const Body& body) { return body.now; });
  if (!any) return;
  ++steps_;
  noteTools(state, meter);
}

// A contact is the nearest tool's: not every engine says whose it is.
void Touch::noteTools(const State& state, const PenetrationMeter& meter) {
  if (tools_.size() == 1) tools_.front().met = true;
  if (std::all_of(tools_.begin(), tools_.end(), [](const Tool& tool) { return tool.met; })) return;
  for (std::size_t t = 0; t < tools_.size(); ++t) tools_[t].met = tools_[t].met || meter.isInTissue(t);
  for (std::size_t v = 0; v < state.contact.vertex_contact.size(); ++v) {
    if (state.contact.vertex_contact[v] == 0) continue;
    Tool* nearest = nullptr;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < tools_.size(); ++t) {
      const double distance_m =
          tools_[t].shape.signedDistance_m(state.tools[t].pose.toBody(state.positions_m[v]), least_m);
      if (!(distance_m < least_m)) continue;
      least_m = distance_m;
      nearest = &tools_[t];
    }
    if (nearest) nearest->met = true;
  }
}

std::vector<std::string> Touch::untouchedTools() const {
  std::vector<std::string> names;
  for (const Tool& tool : tools_)
    if (!tool.met) names.push_back(tool.name);
  return names;
}

}  // namespace fissure
