#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process/interrupt.h"
#include "process/progress_display.h"
#include "study/stability_boundary.h"
#include "study/stability_cell.h"
#include "study/stability_file.h"

namespace fissure {

/// The cells of one map through one pipeline, which are one sweep in the study's folder.
struct StabilityPanel {
  const StabilityMap* map = nullptr;
  std::string pipeline;
  std::filesystem::path scenario_file;  ///< as it is called from the working directory
  std::filesystem::path folder;         ///< of the sweep; its file is `<folder>.yaml`
  bool whole_numbers = false;           ///< the last axis takes no others
  struct Cell {
    StabilityCell cell;
    std::size_t point = 0;                ///< of its sweep; cells that are refused are in none
    int round = 0;                        ///< 0: of the grid, else the round of halving that asked for it
    std::optional<CellClass> classified;  ///< no value: not run yet
    std::filesystem::path result;         ///< below the study's folder; empty where there is none
    double wall_s = 0;
    bool judged_alone = false;  ///< its tissue without the tool is known to be sound, or is in the reason
  };
  std::vector<Cell> cells;
  std::vector<StabilityBoundary> boundaries;  ///< between the cells that are known
};

/// A study of stability: sweeps of cells, their classes, and further cells between neighbours of different
/// classes until boundaries are narrow. Everything that was run is in the journals of the sweeps, so that a
/// study that was stopped, killed or run elsewhere goes on.
class StabilityStudy {
 public:
  /// Studies the maps that `maps` names, or all where it is empty. Throws InputError for a study whose
  /// scenarios or cells are not valid, and for a name that no map has.
  StabilityStudy(const std::filesystem::path& file, const std::filesystem::path& folder,
                 const std::vector<std::string>& maps, const std::string& command_line);

  /// Writes the sweeps of all cells that are known to be needed, runs those never tried with `slots` workers,
  /// and classifies. Returns the number of cells that the classes call for next. Throws Interrupted, with all
  /// finished work stored.
  std::size_t round(int slots, ProgressDisplay& display);
  /// The same without running anything. Returns the folders of sweeps that have cells never tried.
  std::vector<std::filesystem::path> plan();

  const StabilitySettings& settings() const { return settings_; }
  const std::vector<StabilityPanel>& panels() const { return panels_; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Base {
    std::filesystem::path file;
    LoadedScenario loaded;
  };
  void addPanels(const StabilityMap& map);
  const LoadedScenario& baseOf(const std::filesystem::path& file) const;
  StabilityCells cellsOf(const StabilityPanel& panel) const;
  void addCells(StabilityPanel& panel, const std::vector<std::vector<std::string>>& points, int round) const;
  void classifyCells(StabilityPanel& panel) const;
  void judgeAlone(StabilityPanel& panel, int slots, ProgressDisplay& display) const;
  bool isCell(const StabilityPanel& panel, const std::vector<std::string>& values) const;
  std::size_t refine(StabilityPanel& panel, int round) const;

  StabilitySettings settings_;
  std::filesystem::path folder_;
  std::string command_line_;
  std::vector<Base> bases_;
  std::vector<StabilityPanel> panels_;
  int round_ = 0;
};

}  // namespace fissure
