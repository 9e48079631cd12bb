#include "scenario/catalog.h"

#include <variant>

#include "law/force_law.h"
#include "scenario/elastic.h"
#include "scenario/motions.h"
#include "scenario/pipeline_table.h"
#include "scenario/shapes.h"
#include "scenario/tissues.h"

namespace fissure {

namespace {

template <class Table>
std::vector<CatalogEntry> entriesOf(const Table& table) {
  std::vector<CatalogEntry> entries;
  for (const auto& entry : table) entries.push_back({entry.name, entry.description});
  return entries;
}

/// The names of a variant's alternatives, in its order, each with the line of its text that `line` names.
template <class... Ts, class Text>
std::vector<CatalogEntry> entriesOf(const std::variant<Ts...>&, std::string_view Text::*line) {
  return {{Ts::text.name, Ts::text.*line}...};
}

}  // namespace

const Catalog& catalog() {
  static const Catalog tables{
      .pipelines = entriesOf(pipeline_table),
      .force_laws = entriesOf(forceLaws()),
      .tissues = entriesOf(tissues()),
      .body_models = {{"shell",
                       "Bullet's springs along the surface's edges: no modulus, forces have no size"},
                      {"elastic",
                       "finite elements over the volume, with Young's modulus: forces in newtons"}},
      .elastic_materials = {{"neo_hookean", "stable neo-Hookean (Smith, de Goes and Kim 2018), large strain"},
                            {"linear_corotated", "Hooke's law after the element's rotation, small strain"},
                            {"saint_venant_kirchhoff",
                             "Hooke's law of the Green strain: to compare with finite-element programs"}},
      .elastic_presets = entriesOf(elasticPresets()),
      .body_shapes = entriesOf(SurfaceShape(), &ShapeText::as_body),
      .tool_shapes = entriesOf(SurfaceShape(), &ShapeText::as_tool),
      .clamp_openings = {{"parallel", "both jaws slide apart; openings in metres"},
                         {"hinged", "both jaws turn about one axis; openings in degrees"}},
      .node_placements = {{"grid", "on both large faces of a box, facing nodes are partners (Fukuhara)"},
                          {"centroids", "one in each triangle, its partner in the triangle behind it"}},
      .motions = entriesOf(ToolMotion(), &MotionText::description),
      .timings = {{"constant", "constant speed"},
                  {"trapezoidal", "constant acceleration, cruise, constant deceleration"},
                  {"minimum_jerk", "10 s^3 - 15 s^4 + 6 s^5"}},
      .interpolations = {{"linear", "straight lines between samples"},
                         {"monotone_cubic", "smooth, without overshoot (Fritsch and Carlson 1980)"}},
      .settings = {{"stock",
                    "Bullet's defaults: SDF voxel 0.25 m, kinematic contact hardness 0.1; deformable: as "
                    "Bullet's examples of the material are set"},
                   {"tuned",
                    "SDF voxel 0.5 mm, kinematic contact hardness 1; clusters: at least 20 iterations; "
                    "deformable: explicit, in as many substeps as the mesh asks for"}},
      .deformable_contacts = {{"nodes", "tissue vertices in the tool's signed distance field (SDF_RDN)"},
                              {"faces", "tissue triangles against the tool by GJK (SDF_RDF)"}},
      .responses = {{"none", "contacts displace the tissue and leave its velocities (the paper)"},
                    {"momentum",
                     "velocities follow the displacement; the reaction is the momentum taken, friction too"}},
      .ground_contacts = {{"bullet", "Bullet's contact of each vertex, which gives way under load"},
                          {"half_space", "an obstacle of the pipeline's own contacts, as swept has it"}},
      .precisions = {{"f64", "Bullet in double precision"}, {"f32", "Bullet in single precision"}},
      .rates = {{"differences", "of deformation: what the tissue did from step to step"},
                {"velocities", "of deformation: from the engine's vertex velocities"}},
      .deformations = {{"paper", "of a triangle: the way of its centroid from its place at rest"},
                       {"corotated", "the same, after the body's best-fit rotation and translation"}},
      .aero_models = {{"V_Point", "drag and lift at vertices, along the vertex normal towards the wind"},
                      {"V_TwoSided", "at vertices, both sides alike"},
                      {"V_TwoSidedLiftDrag", "at vertices, both sides, lift and drag"},
                      {"V_OneSided", "at vertices, the outer side alone"},
                      {"F_TwoSided", "at faces, both sides alike"},
                      {"F_TwoSidedLiftDrag", "at faces, both sides, lift and drag"},
                      {"F_OneSided", "at faces, the outer side alone"}},
      .soft_contacts = {{"none", "soft bodies ignore each other"},
                        {"vertices", "Bullet's vertices against faces"},
                        {"clusters", "Bullet's clusters against clusters"}},
      .length_units = {{"m", "metres"}, {"mm", "millimetres"}, {"cm", "centimetres"}},
      .time_units = {{"s", "seconds"}, {"ms", "milliseconds"}, {"us", "microseconds"}, {"ns", "nanoseconds"}},
      .log_layouts = {{"rows", "a header line of names, then one line a sample"},
                      {"axes", "no header: a line of all x, one of all y, one of all z"}},
      .device_axes = {{"x", "the log's first coordinate"},
                      {"y", "the log's second coordinate"},
                      {"z", "the log's third coordinate"}},
      .expected_contacts = {{"any", "bounds hold without contact too"}},
      .device_frames = {{"scene", "the device's axes are the scene's, or as `axes` says"},
                        {"novint", "Falcon by its own driver: x right, y up, z to the operator"},
                        {"chai3d", "Falcon by CHAI3D: x to the operator, y right, z up"}},
      .mesh_repairs = {{"drop_degenerate", "triangles without area"},
                       {"drop_duplicate_faces", "all but one of the triangles with the same three corners"},
                       {"keep_largest_shell",
                        "of pieces that share no vertex, the one of the largest area stays"},
                       {"drop_unreferenced", "vertices that are part of no triangle"},
                       {"orient", "neighbours made to agree; closed shells turned outward, cavities inward"},
                       {"cap_holes", "each boundary loop closed by a fan around its middle"}},
  };
  return tables;
}

}  // namespace fissure
