#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "measure/probes.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace fissure::probes_test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A run of makeProbes' probes over states that a test makes up.
class ProbesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    scene_ = test::makeScene({makeBox({0.1, 0.1, 0.1})}, {{0.04, 0.002, 0.015}});
    state_ = test::restState(scene_, {test::at(0, 0.2, 0)});
    scenario_.time.step_s = 0.001;
  }
  void addNodes(int count) {
    scene_.tools[0].nodes.positions_m.assign(static_cast<std::size_t>(count), Vec3::Zero());
    state_.contact.node_states.assign(static_cast<std::size_t>(count), NodeState::free);
  }
  void addLaws(const std::vector<std::string>& names) {
    for (const std::string& name : names)
      scenario_.force.push_back({.name = name, .model = ForceModel::linear_elastic});
    state_.forces.resize(names.size());
    state_.tool_forces_N.resize(names.size() * scene_.tools.size(), Vec3::Zero());
  }
  void limitForce(double limit_N) {
    ToolSettings tool;
    tool.name = scene_.tools[0].name;
    tool.force_limit_N = limit_N;
    scenario_.tools.push_back(tool);
  }
  void start() {
    probes_ = makeProbes(scenario_, scene_);
    for (const auto& probe : probes_) probe->declare(layout_);
    row_.assign(layout_.columns(), 12345.0);
  }
  void step() {
    for (const auto& probe : probes_) probe->sample(state_, row_);
    ++state_.step;
    state_.time_s = static_cast<double>(state_.step) * scenario_.time.step_s;
  }
  double value(const std::string& series, std::size_t index = 0) const {
    return row_[layout_.find(series)->first_column + index];
  }
  std::vector<std::string> seriesNames() const {
    std::vector<std::string> names;
    for (const Series& series : layout_.series()) names.push_back(series.name);
    return names;
  }
  SummaryValue scalar(const std::string& name) const {
    Summary summary;
    for (const auto& probe : probes_) probe->summarize(summary);
    for (const SummaryValue& value : summary) {
      if (value.name == name) return value;
    }
    return {"absent", std::string("absent")};
  }
  double real(const std::string& name) const { return std::get<double>(scalar(name).value); }
  long long count(const std::string& name) const { return std::get<long long>(scalar(name).value); }

  Scenario scenario_;
  Scene scene_;
  State state_;
  RecordLayout layout_;
  RecordRow row_;
  std::vector<std::unique_ptr<Probe>> probes_;
};

using Names = std::vector<std::string>;

}  // namespace fissure::probes_test
