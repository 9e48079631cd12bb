// Detection, and measurement, on the sphere and the spatula of spatula_press, without an engine: tissue goes
// where contact puts it, and stays there.
#include <map>

#include "batch.h"
#include "cases.h"
#include "contact/node_contact.h"
#include "contact/swept_contact.h"
#include "measure/penetration.h"
#include "scene/build_scene.h"

namespace fissure::bench {

namespace {

constexpr double kOutside_m = -0.005;  ///< depths of the spatula's lower face below the sphere's top at rest
constexpr double kPressed_m = 0.008;
constexpr double kStep_m = 0.0001;
constexpr int kContactCalls = 25;  ///< timed ones in a batch

Scenario scenarioWith(int subdivisions, int nodes) {
  const std::string side = std::to_string(nodes);
  return configuredScenario("spatula_press",
                            {{"bodies.sphere.shape.subdivisions", std::to_string(subdivisions)},
                             {"tools.spatula.nodes.resolution", "[" + side + ", " + side + "]"}});
}

NodeContact nodeContact(const Scene& scene, const Scenario& scenario) {
  return {scene,
          {.vertex_contacts = true,
           .response = ContactResponse::momentum,
           .margins_m = {scenario.bodies[0].margin_m}}};
}

SweptContact sweptContact(const Scene& scene, const Scenario& scenario) {
  return {scene, {.margins_m = {scenario.bodies[0].margin_m}}};
}

/// Copies are independent.
template <class Contact>
struct PressedSphere {
  Scenario scenario;
  Scene scene = buildScene(scenario, true);
  Contact contact;
  std::vector<double> inverse_masses =
      std::vector<double>(scene.vertexCount(), scene.vertexCount() / scenario.bodies[0].mass_kg);
  std::vector<Vec3> before_m = scene.bodies[0].rest.vertices_m;
  std::vector<ToolState> tools_before;
  State state{.positions_m = scene.bodies[0].rest.vertices_m, .tools = {ToolState{}}};
  ContactPatch patch;

  PressedSphere(Scenario with, Contact (*make)(const Scene&, const Scenario&))
      : scenario(std::move(with)), contact(make(scene, scenario)) {
    patch.resize(scene.vertexCount(), scene.faceCount(), 1);
    moveTool(kOutside_m);
  }
  void moveTool(double depth_m) {
    const BodySettings& sphere = scenario.bodies[0];
    const double top_m = sphere.position_m.y() + std::get<SphereShape>(sphere.shape).radius_m;
    tools_before = state.tools;
    state.tools[0].pose.position_m = {
        0, top_m - depth_m + 0.5 * std::get<BoxShape>(scenario.tools[0].shape).size_m.y(), 0};
  }
  void detect() {
    contact.step({.positions_m = state.positions_m,
                  .before_m = before_m,
                  .tools_before = tools_before,
                  .tools_now = state.tools,
                  .dt_s = scenario.time.step_s},
                 inverse_masses, state.contact, patch);
    before_m = state.positions_m;
  }
  void press(double from_m, double to_m) {
    for (double depth_m = from_m; depth_m < to_m + 0.5 * kStep_m; depth_m += kStep_m) {
      moveTool(depth_m);
      detect();
    }
  }
};

/// What a detector counts over its steps, by the names of Simulation::counters().
std::map<std::string, long long> countsOf(const NodeContact& contact) {
  return {{"rays", contact.rays()},
          {"ray_triangle_tests", contact.rayTests()},
          {"displacement_sweeps", contact.displacementCounts().sweeps},
          {"displacement_pushes", contact.displacementCounts().pushes}};
}

std::map<std::string, long long> countsOf(const SweptContact& contact) {
  return {{"rounds", contact.rounds()},
          {"truncated_vertices", contact.truncationCounts().vertices},
          {"displacement_sweeps", contact.displacementCounts().sweeps},
          {"displacement_pushes", contact.displacementCounts().pushes}};
}

template <class Contact>
double detect(benchmark::State& out, PressedSphere<Contact> saved) {
  saved.press(-0.001, kPressed_m);
  saved.moveTool(kPressed_m + kStep_m);
  PressedSphere<Contact> stepped = saved;
  stepped.detect();  // its arrays have their size from here on
  const State first = stepped.state;
  Batch calls;
  for (int i = 0; i < kContactCalls; ++i) {
    stepped = saved;
    calls.time([&] { stepped.detect(); });
    if (stepped.state.positions_m != first.positions_m) throw std::logic_error("two calls differ");
  }
  const auto before = countsOf(saved.contact);
  for (const auto& [name, count] : countsOf(stepped.contact))
    out.counters[name] = static_cast<double>(count - before.at(name));
  out.counters["contacts"] = stepped.state.contact.contact_count;
  out.counters["allocations"] = calls.allocationCount() / kContactCalls;
  return calls.median_s();
}

double measure(benchmark::State& out, int subdivisions, const std::string& where) {
  PressedSphere<NodeContact> sphere(scenarioWith(subdivisions, 32), nodeContact);
  const double depth_m = where == "outside" ? kOutside_m : kPressed_m;
  if (where == "touching") sphere.press(-0.001, depth_m);
  sphere.moveTool(depth_m);
  const State before = sphere.state;
  sphere.moveTool(depth_m + kStep_m);
  if (where == "touching") sphere.detect();

  PenetrationMeter meter(sphere.scene, sphere.scenario.measure);
  Penetration found = meter.measure(sphere.state);
  Batch calls;
  long long searches = 0;
  for (int i = 0; i < kContactCalls; ++i) {
    meter.measure(before);
    searches = meter.searches();
    calls.time([&] { found = meter.measure(sphere.state); });
  }
  out.counters["searches"] = static_cast<double>(meter.searches() - searches);
  if ((found.depth_m > 0) != (where == "deep")) throw std::logic_error("not a state that is " + where);
  out.counters["samples"] = static_cast<double>(meter.sampleCount());
  out.counters["allocations"] = calls.allocationCount() / kContactCalls;
  return calls.median_s();
}

std::string trianglesOf(int subdivisions) {
  return std::to_string(8 << 2 * subdivisions);
}

}  // namespace

void addContactCases() {
  constexpr int kFinest = 6;  // 32,768 triangles: against one number of nodes only
  for (const int subdivisions : {2, 3, 4, 5, kFinest}) {
    const std::string triangles = trianglesOf(subdivisions);
    for (const int nodes : {4, 8, 16, 32}) {
      if (subdivisions == kFinest && nodes != 16) continue;
      const std::string side = std::to_string(nodes);
      addCase("detect/" + triangles + "/" + side + "x" + side, [=](benchmark::State& out) {
        return detect<NodeContact>(out, {scenarioWith(subdivisions, nodes), nodeContact});
      });
    }
    addCase("detect/" + triangles + "/swept", [=](benchmark::State& out) {
      return detect<SweptContact>(out, {scenarioWith(subdivisions, 4), sweptContact});
    });
    if (subdivisions == kFinest) continue;
    for (const std::string where : {"outside", "touching", "deep"}) {
      addCase("measure/" + triangles + "/" + where,
              [=](benchmark::State& out) { return measure(out, subdivisions, where); });
    }
  }
}

}  // namespace fissure::bench
