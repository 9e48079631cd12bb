#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/record.h"
#include "base/run_status.h"
#include "scenario/key.h"

namespace fissure {

/// What a cell of a stability map is. A cell has the first class of this list whose criterion holds.
enum class StabilityClass {
  refused,
  crashed,
  too_slow,
  non_finite,
  unsound_alone,
  passed_through,
  penetrating,
  energy_growing,
  chattering,
  force_out_of_range,
  untouched,
  stable,
};

/// The names of the classes and their criteria in words, in the order of StabilityClass.
const std::vector<CatalogEntry>& stabilityClasses();

/// The thresholds of the criteria.
struct StabilityCriteria {
  double depth_m = 0.0005;
  double depth_of_thickness = 0.25;
  bool proved = true;
  double energy_growth = 10;
  double chatter_share = 0.1;
  int chatter_crossings = 6;
  double force_N = 1000;
  std::vector<std::string> forces;
};

/// One series of a run; vectors by their magnitudes.
struct CellCurve {
  std::string name;       ///< "kinetic_energy", or a force as criteria name it: "reaction", a law, a coupling
  bool is_force = false;  ///< a law's, "reaction" or that of a coupling
  std::vector<double> values;  ///< one per row of the record: the initial state, then one per step
};

/// All that the criteria look at of a cell's run.
struct CellRun {
  RunStatus status;
  std::string refused = {};  ///< why it was never run; empty: it was
  double step_s = 0;
  std::size_t rest_from = 0;  ///< first row from which on the tool is led no more
  double thickness_m = 0;     ///< shortest side of the tool
  Summary summary;
  std::vector<CellCurve> curves;
  /// What is wrong with the same tissue without the tool; empty: nothing, or nobody has asked.
  std::string alone = {};
};

struct CellClass {
  StabilityClass kind = StabilityClass::stable;
  std::string reason;       ///< one line
  double frequency_Hz = 0;  ///< of chattering; else 0
};

/// The class of a cell. Missing data is not taken for good: a run that is said to have ended well, but has no
/// depth, no energy or no value where there should be one, is non_finite.
CellClass classify(const CellRun& run, const StabilityCriteria& criteria);

/// What is wrong with tissue in a run without tools, in one line; empty: nothing.
std::string problemAlone(const CellRun& run, const StabilityCriteria& criteria);

template <class Io>
void describe(Io& io, StabilityCriteria& c) {
  io.field("depth_m", c.depth_m,
           Key("A tool that is deeper in tissue, inverted tissue counted, penetrates.").above(0));
  io.field("depth_of_thickness", c.depth_of_thickness,
           Key("And so does one that is deeper than this share of its shortest side.").noUnit().above(0));
  io.field("proved", c.proved,
           Key("Whether steps without proof count as penetrating, where the scenario asks for the proof."));
  io.field("energy_growth", c.energy_growth,
           Key("Kinetic energy grows where its largest value in the last third of the time at rest is this "
               "many times that in the first third, and does not fall between.")
               .noUnit()
               .above(1));
  io.field("chatter_share", c.chatter_share,
           Key("A force chatters where, at rest, what is left of it beside a straight line has an RMS above "
               "this share of its mean, and does not die away.")
               .noUnit()
               .above(0));
  io.field(
      "chatter_crossings", c.chatter_crossings,
      Key("And where that changes its sign at least this often, or where the force is lost and comes back "
          "half as often.")
          .count(2));
  io.field("force_N", c.force_N, Key("Forces above this are out of range.").above(0));
  io.field("forces", c.forces,
           Key("Which forces are judged: names of laws, and `reaction`.")
               .otherwise("every law, or `reaction` where there is none; and the force of couplings"));
}

}  // namespace fissure
