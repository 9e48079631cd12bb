
#include <fmt/core.h>

#include "measure/certifier.h"
#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

/// Series certified: 1 where the end of the step is proved free of overlap (Certifier). Scalars
/// certified_steps and uncertified_steps, which count the recorded steps, the initial state among them;
/// where not all are proved, first_uncertified_step and first_uncertified, what is in its way.
class CertificateProbe : public Probe {
 public:
  explicit CertificateProbe(const Scene& scene) : certifier_(scene) {}

  void declare(RecordLayout& layout) override {
    column_ = layout.add(
        {.name = "certified",
         .units = "1",
         .long_name = "1 where the end of the step is proved free of overlap between tools and tissue",
         .type = ValueType::flag,
         .axes = {}});
  }

  void sample(const State& state, RecordRow& row) override {
    const std::optional<Objection> objection = certifier_.certify(state);
    row[column_] = objection ? 0 : 1;
    ++(objection ? uncertified_ : certified_);
    if (objection && first_.empty()) {
      first_step_ = state.step;
      first_ = objection->what;
      if (objection->time < 1) first_ += fmt::format(" at {:.3g} of the step", objection->time);
    }
  }

  void summarize(Summary& summary) const override {
    const bool sampled = certified_ + uncertified_ > 0;
    summary.push_back(countOrMissing("certified_steps", sampled, certified_));
    summary.push_back(countOrMissing("uncertified_steps", sampled, uncertified_));
    if (first_.empty()) return;
    summary.push_back({"first_uncertified_step", first_step_});
    summary.push_back({"first_uncertified", first_});
  }

 private:
  Certifier certifier_;
  std::size_t column_ = 0;
  long long certified_ = 0, uncertified_ = 0;
  long long first_step_ = 0;
  std::string first_;
};

}  // namespace

std::unique_ptr<Probe> makeCertificateProbe(const Scene& scene) {
  return std::make_unique<CertificateProbe>(scene);
}

}  // namespace fissure
