#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "measure/penetration.h"
#include "measure/tool_shape.h"

namespace fissure {

/// Records which tools and bodies have touched since the start: by a contact that the engine reports, or by a
/// tool that is in tissue without one.
class Touch {
 public:
  explicit Touch(const Scene& scene);

  /// Takes the next step; `found` is the measurement of `meter` in it.
  void add(const State& state, const PenetrationMeter& meter, const Penetration& found);
  /// The same for a step that `meter` has not measured: contacts that the engine reports are seen, a tool
  /// that is in tissue without one is not.
  void addUnmeasured(const State& state, const PenetrationMeter& meter);

  long long steps() const { return steps_; }  ///< number of steps in which any tool touched tissue
  /// Whether a tool touches the body in the last step, and whether any has touched it so far.
  bool isTouched(std::size_t body) const { return bodies_[body].now; }
  bool wasTouched(std::size_t body) const { return bodies_[body].ever; }
  /// Names of the tools that have never touched tissue, in the scene's order.
  std::vector<std::string> untouchedTools() const;

 private:
  struct Body {
    std::size_t first_vertex = 0, vertex_count = 0;
    bool now = false, ever = false;
  };
  struct Tool {
    std::string name;
    ToolShape shape;
    bool met = false;
  };
  void add(const State& state, const PenetrationMeter& meter, bool inside);
  void noteTools(const State& state, const PenetrationMeter& meter);

  std::vector<Body> bodies_;
  std::vector<Tool> tools_;
  long long steps_ = 0;
};

}  // namespace fissure
