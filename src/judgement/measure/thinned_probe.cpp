#include "measure/probe_makers.h"

namespace fissure {

namespace {

/// A probe that looks at each `every`-th state, and the last, only. In between its columns stay what they
/// are, no numbers.
class ThinnedProbe : public Probe {
 public:
  ThinnedProbe(std::unique_ptr<Probe> probe, int every) : probe_(std::move(probe)), every_(every) {}

  void declare(RecordLayout& layout) override { probe_->declare(layout); }
  void sample(const State& state, RecordRow& row) override {
    if (state.isOneOf(every_)) probe_->sample(state, row);
  }
  void summarize(Summary& summary) const override { probe_->summarize(summary); }

 private:
  std::unique_ptr<Probe> probe_;
  int every_ = 1;
};

}  // namespace

std::unique_ptr<Probe> makeThinnedProbe(std::unique_ptr<Probe> probe, int every) {
  if (every == 1) return probe;
  return std::make_unique<ThinnedProbe>(std::move(probe), every);
}

}  // namespace fissure
