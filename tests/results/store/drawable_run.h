#pragma once

#include <filesystem>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "store/result_file.h"

namespace fissure {

/// Two bodies, a tool with four nodes and a clamp of two jaws with a handle, on the ground at y = -0.03 m.
Scene drawableScene();
/// Moved a little from snapshot to snapshot; snapshot k is of step 2 k at k / 10 s.
State drawableState(std::size_t snapshot);
/// The penetration depth that is recorded with it.
double drawableDepth_m(std::size_t snapshot);

/// A run of a result: its status, and how many snapshots it came to.
struct DrawableRun {
  std::string name;
  RunEnd end = RunEnd::ok;
  std::size_t snapshots = 3;
};

/// A result file of that scene; its scenario is named `drawn`.
void writeDrawableResult(const std::filesystem::path& path, const std::vector<DrawableRun>& runs);

}  // namespace fissure
