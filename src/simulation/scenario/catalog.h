#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// A name that a scenario can choose, with a description of one line.
struct CatalogEntry {
  std::string_view name;
  std::string_view description;
};

/// All names that a scenario can choose from. `fissure list`, validation, help and dispatch read these tables
/// and no others; tests check that each name has its implementation. The names of an enum, or of the
/// alternatives of a variant, are in its order.
struct Catalog {
  std::vector<CatalogEntry> pipelines;  ///< the names in pipeline_table
  std::vector<CatalogEntry> force_laws;
  std::vector<CatalogEntry> tissues;
  std::vector<CatalogEntry> body_models;
  std::vector<CatalogEntry> elastic_materials;
  std::vector<CatalogEntry> elastic_presets;
  std::vector<CatalogEntry> body_shapes;
  std::vector<CatalogEntry> tool_shapes;
  std::vector<CatalogEntry> clamp_openings;
  std::vector<CatalogEntry> node_placements;
  std::vector<CatalogEntry> motions;
  std::vector<CatalogEntry> timings;
  std::vector<CatalogEntry> interpolations;
  std::vector<CatalogEntry> settings;
  std::vector<CatalogEntry> deformable_contacts;
  std::vector<CatalogEntry> responses;
  std::vector<CatalogEntry> ground_contacts;
  std::vector<CatalogEntry> precisions;
  std::vector<CatalogEntry> rates;
  std::vector<CatalogEntry> deformations;
  std::vector<CatalogEntry> aero_models;
  std::vector<CatalogEntry> soft_contacts;
  std::vector<CatalogEntry> length_units;
  std::vector<CatalogEntry> time_units;
  std::vector<CatalogEntry> log_layouts;
  std::vector<CatalogEntry> device_axes;        ///< not part of `fissure list`
  std::vector<CatalogEntry> expected_contacts;  ///< not part of `fissure list`
  std::vector<CatalogEntry> device_frames;
  std::vector<CatalogEntry> mesh_repairs;  ///< in the order in which they are applied
};

/// The one catalog of the program.
const Catalog& catalog();

/// The name of an enum's value in files, results and messages; `table` is in the enum's order.
template <class Enum>
std::string nameIn(const std::vector<CatalogEntry>& table, Enum value) {
  return std::string(table[static_cast<std::size_t>(value)].name);
}

}  // namespace fissure
