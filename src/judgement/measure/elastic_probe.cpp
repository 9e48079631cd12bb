#include <algorithm>
#include <array>
#include <cmath>

#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

/// A part of the tissue's energy that is recorded by itself.
struct EnergySeries {
  const char* name;
  const char* long_name;
  double VolumeState::*value_J;
  bool since_start;  ///< a sum, counted from the record's first row
};

constexpr auto kEnergies = std::to_array<EnergySeries>({
    {"stored_energy", "elastic energy of the tissue, 0 at rest", &VolumeState::stored_J, false},
    {"gravity_energy", "potential energy of the tissue in gravity, 0 at rest", &VolumeState::gravity_J,
     false},
    {"viscous_loss", "energy that viscosity took since the start", &VolumeState::viscous_loss_J, true},
    {"mass_damping_loss", "energy that mass damping took since the start", &VolumeState::mass_damping_loss_J,
     true},
    {"contact_work", "work that contacts did on the tissue since the start", &VolumeState::contact_work_J,
     true},
    {"tool_work", "work that tools did on the tissue since the start", &VolumeState::tool_work_J, true},
});

/// Where the energy of an elastic body goes: the series of kEnergies, with kinetic_energy of the bodies all
/// there is; contact_loss, the tools' work that contacts did not pass on; energy_error, what does not add up
/// since the start; and max_pressure, substeps and inverted_elements.
class ElasticProbe : public Probe {
 public:
  void declare(RecordLayout& layout) override {
    for (std::size_t i = 0; i < kEnergies.size(); ++i)
      columns_[i] = layout.add(
          {.name = kEnergies[i].name, .units = "J", .long_name = kEnergies[i].long_name, .axes = {}});
    loss_column_ = layout.add({.name = "contact_loss",
                               .units = "J",
                               .long_name = "tool work less contact work: lost in contacts since the start",
                               .axes = {}});
    error_column_ = layout.add(
        {.name = "energy_error",
         .units = "J",
         .long_name = "kinetic, stored, gravity energy and losses less contact work, since the start",
         .axes = {}});
    pressure_column_ = layout.add({.name = "max_pressure",
                                   .units = "Pa",
                                   .long_name = "largest normal stress of contacts on the tissue",
                                   .axes = {}});
    substeps_column_ = layout.add({.name = "substeps",
                                   .units = "1",
                                   .long_name = "substeps of the elements in the step",
                                   .type = ValueType::count,
                                   .axes = {}});
    inverted_column_ = layout.add({.name = "inverted_elements",
                                   .units = "1",
                                   .long_name = "tetrahedra turned inside out",
                                   .type = ValueType::count,
                                   .axes = {}});
  }

  void sample(const State& state, RecordRow& row) override {
    if (!state.volume) return;
    const VolumeState& now = *state.volume;
    if (steps_++ == 0) first_ = now;
    for (std::size_t i = 0; i < kEnergies.size(); ++i)
      row[columns_[i]] =
          now.*kEnergies[i].value_J - (kEnergies[i].since_start ? first_.*kEnergies[i].value_J : 0);
    row[loss_column_] = (now.tool_work_J - first_.tool_work_J) - (now.contact_work_J - first_.contact_work_J);
    RunningMax pressures_Pa;  // NaN where one is
    for (const double pressure_Pa : now.pressures_Pa) pressures_Pa.add(pressure_Pa);
    const double pressure_Pa = now.pressures_Pa.empty() ? 0 : pressures_Pa.value();
    row[pressure_column_] = pressure_Pa;
    max_pressure_Pa_.add(pressure_Pa);
    const double error_J = balance_J(now) - balance_J(first_);
    row[error_column_] = error_J;
    row[substeps_column_] = now.substeps;
    row[inverted_column_] = now.inverted_elements;
    max_error_J_.add(std::abs(error_J));
    const double turned_J = std::abs(now.contact_work_J - first_.contact_work_J) + now.viscous_loss_J -
                            first_.viscous_loss_J + now.mass_damping_loss_J - first_.mass_damping_loss_J;
    max_turned_J_.add(turned_J + now.kinetic_J + now.stored_J + std::abs(now.gravity_J - first_.gravity_J));
    max_substeps_ = std::max(max_substeps_, now.substeps);
    max_inverted_ = std::max(max_inverted_, now.inverted_elements);
  }

  void summarize(Summary& summary) const override {
    summary.push_back({"max_pressure_Pa", max_pressure_Pa_.value()});
    summary.push_back({"energy_balance_error", max_error_J_.value() / max_turned_J_.value()});
    summary.push_back(countOrMissing("max_substeps", steps_ > 0, max_substeps_));
    summary.push_back(countOrMissing("max_inverted_elements", steps_ > 0, max_inverted_));
  }

 private:
  static double balance_J(const VolumeState& at) {
    return at.kinetic_J + at.stored_J + at.gravity_J + at.viscous_loss_J + at.mass_damping_loss_J -
           at.contact_work_J;
  }

  std::array<std::size_t, kEnergies.size()> columns_{};
  std::size_t loss_column_ = 0, error_column_ = 0, pressure_column_ = 0, substeps_column_ = 0,
              inverted_column_ = 0;
  VolumeState first_;
  long long steps_ = 0;
  RunningMax max_pressure_Pa_;
  RunningMax max_error_J_, max_turned_J_;  ///< what energies did in all, to compare the error with
  int max_substeps_ = 0, max_inverted_ = 0;
};

}  // namespace

std::unique_ptr<Probe> makeElasticProbe() {
  return std::make_unique<ElasticProbe>();
}

}  // namespace fissure
