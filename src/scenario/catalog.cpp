#include "scenario/catalog.h"

namespace fissure {

const Catalog& catalog() {
  static const Catalog tables{
      .pipelines =
          {{"default",
            "Bullet's own soft-rigid contact: tissue vertices against the tool's signed distance field"},
           {"null",
            "(write it in quotes) default behind a detector of ours that only delegates; must equal default "
            "bit for bit"},
           {"cluster", "Bullet's own contact of clusters: pieces of tissue against the convex tool (GJK)"},
           {"raycast",
            "node ray casting and enforced displacement, without node association (paper, Fig. 3 right)"},
           {"fukuhara", "the full method: node ray casting, infeasible pairs excluded, contacts as impulses"},
           {"prescribed",
            "reference without contact detection: tissue vertices that a box tool reaches stick to it"}},
      .force_laws = {{"hunt_crossley", "F = k x^n + lambda x^n x', never pulling (Hunt and Crossley 1975)"},
                     {"kelvin_voigt", "F = k x + c x', a spring and a damper side by side, never pulling"},
                     {"linear_elastic", "F = k x, the default model that the paper replaced"}},
      .body_shapes = {{"sphere", "subdivided octahedron, 8 x 4^subdivisions triangles"},
                      {"box", "12 triangles, full edge lengths"},
                      {"triangles", "a closed surface from plain arrays"}},
      .tool_shapes = {{"box", "full edge lengths; nodes on a grid on both large faces"}},
      .motions = {{"script", "waypoints and holds"}, {"replay", "a recorded hand motion from a text file"}},
      .timings = {{"constant", "constant speed"},
                  {"trapezoidal", "constant acceleration, cruise, constant deceleration"},
                  {"minimum_jerk", "10 s^3 - 15 s^4 + 6 s^5"}},
      .interpolations = {{"linear", "straight lines between samples"},
                         {"monotone_cubic", "smooth, without overshoot (Fritsch and Carlson 1980)"}},
      .settings = {{"stock", "Bullet's defaults: SDF voxel 0.25 m, kinematic contact hardness 0.1"},
                   {"tuned",
                    "SDF voxel 0.5 mm, kinematic contact hardness 1; clusters: at least 20 iterations"}},
      .responses = {{"none", "contacts displace the tissue and leave its velocities (the paper)"},
                    {"momentum",
                     "velocities follow the displacement; the reaction is the momentum taken, friction too"}},
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
      .length_units = {{"m", "metres"}, {"mm", "millimetres"}},
      .log_layouts = {{"rows", "a header line of names, then one line a sample"},
                      {"axes", "no header: a line of all x, one of all y, one of all z"}},
      .device_frames = {{"scene", "the device's axes are the scene's, or as `axes` says"},
                        {"novint", "Falcon by its own driver: x right, y up, z to the operator"},
                        {"chai3d", "Falcon by CHAI3D: x to the operator, y right, z up"}},
  };
  return tables;
}

}  // namespace fissure
