#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// A choice that a scenario can name, with one line for people.
struct CatalogEntry {
  std::string_view name;
  std::string_view description;
};

/// Every name a scenario can choose from. `list`, validation, help and dispatch read these tables and no
/// other; tests say that each name has its implementation. Names of an enum or of the alternatives of a
/// variant are in its order.
struct Catalog {
  std::vector<CatalogEntry> pipelines;  ///< those of pipeline_table
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
  std::vector<CatalogEntry> device_axes;        ///< not listed: a message names them
  std::vector<CatalogEntry> expected_contacts;  ///< not listed: a message names them
  std::vector<CatalogEntry> device_frames;
  std::vector<CatalogEntry> mesh_repairs;  ///< in the order in which they are done
};

const Catalog& catalog();

/// What a value of an enum is called in files, results and messages; `table` is in the enum's order.
template <class Enum>
std::string nameIn(const std::vector<CatalogEntry>& table, Enum value) {
  return std::string(table[static_cast<std::size_t>(value)].name);
}

}  // namespace fissure
