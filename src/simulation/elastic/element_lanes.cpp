#include "elastic/element_lanes.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace fissure {

namespace {

/// Edges from the fourth corner, as columns.
Mat3 restEdges(const TetrahedralMesh& rest, const Tetrahedron& corners) {
  Mat3 edges;
  for (int c = 0; c < 3; ++c) edges.col(c) = rest.vertices_m[corners[c]] - rest.vertices_m[corners[3]];
  return edges;
}

void checkMesh(const TetrahedralMesh& rest) {
  const auto fail = [](const std::string& what, std::size_t which, const std::string& why) {
    throw std::invalid_argument(fmt::format("elastic tissue: {} {} {}", what, which, why));
  };
  if (rest.tetrahedra.empty()) throw std::invalid_argument("elastic tissue: it has no tetrahedra");
  for (std::size_t v = 0; v < rest.vertices_m.size(); ++v)
    if (!rest.vertices_m[v].allFinite()) fail("vertex", v, "is not finite");
  std::vector<bool> used(rest.vertices_m.size());
  for (std::size_t e = 0; e < rest.tetrahedra.size(); ++e) {
    for (const int corner : rest.tetrahedra[e]) {
      if (corner < 0 || corner >= static_cast<int>(used.size()))
        fail("tetrahedron", e, "has a corner that is no vertex");
      used[corner] = true;
    }
    // Positive volume is a negative determinant of edges from the fourth corner.
    if (!(restEdges(rest, rest.tetrahedra[e]).determinant() < 0))
      fail("tetrahedron", e, "has no positive volume");
  }
  for (std::size_t v = 0; v < used.size(); ++v)
    if (!used[v]) fail("vertex", v, "belongs to no tetrahedron");
}

}  // namespace

ElementLanes::ElementLanes(const TetrahedralMesh& rest, const std::vector<int>& of_elements) {
  checkMesh(rest);
  const std::size_t elements = rest.tetrahedra.size();
  vertex_volumes_m3.resize(rest.vertices_m.size());
  first_slots.assign(rest.vertices_m.size() + 1, 0);
  for (const Tetrahedron& tetrahedron : rest.tetrahedra)
    for (const int corner : tetrahedron) ++first_slots[corner + 1];
  for (std::size_t v = 1; v < first_slots.size(); ++v) first_slots[v] += first_slots[v - 1];
  slot_count = 4 * elements + 1;

  const int last = of_elements.empty() ? 0 : *std::max_element(of_elements.begin(), of_elements.end());
  std::vector<std::vector<std::size_t>> by_material(static_cast<std::size_t>(last) + 1);
  for (std::size_t e = 0; e < elements; ++e)
    by_material[of_elements.empty() ? 0 : static_cast<std::size_t>(of_elements[e])].push_back(e);
  std::vector<int> next = first_slots;
  for (const std::vector<std::size_t>& of_one : by_material) append(rest, of_one, next);
}

void ElementLanes::append(const TetrahedralMesh& rest, const std::vector<std::size_t>& elements,
                          std::vector<int>& next) {
  const std::vector<int> first = next;
  MaterialLanes material = {.first_group = groups,
                            .groups = static_cast<int>((elements.size() + kLanes - 1) / kLanes)};
  groups += material.groups;
  const std::size_t lanes = static_cast<std::size_t>(groups) * kLanes;
  corners.resize(4 * lanes);
  slots.resize(4 * lanes);
  inverse_edges.resize(9 * lanes);
  metrics.resize(7 * lanes);
  volumes_m3.resize(lanes);
  std::vector<double> shares_m3(rest.vertices_m.size());
  for (std::size_t i = 0; i < static_cast<std::size_t>(material.groups) * kLanes; ++i) {
    const Tetrahedron& tetrahedron = rest.tetrahedra[elements[std::min(i, elements.size() - 1)]];
    const std::size_t lane = static_cast<std::size_t>(material.first_group) * kLanes + i;
    const std::size_t group = lane / kLanes, in_group = lane % kLanes;
    const Mat3 edges = restEdges(rest, tetrahedron), inverse = edges.inverse();
    for (int k = 0; k < 9; ++k) inverse_edges[(9 * group + k) * kLanes + in_group] = inverse(k / 3, k % 3);
    const Mat3 metric = inverse * inverse.transpose();
    const double of_metric[] = {metric(0, 0), metric(0, 1), metric(0, 2),         metric(1, 1),
                                metric(1, 2), metric(2, 2), inverse.determinant()};
    for (int k = 0; k < 7; ++k) metrics[(7 * group + k) * kLanes + in_group] = of_metric[k];
    const bool real = i < elements.size();
    volumes_m3[lane] = real ? -edges.determinant() / 6 : 0;
    for (int c = 0; c < 4; ++c) {
      const std::size_t at = (4 * group + c) * kLanes + in_group;
      corners[at] = tetrahedron[c];
      slots[at] = real ? next[tetrahedron[c]]++ : static_cast<int>(slot_count) - 1;
      shares_m3[tetrahedron[c]] += volumes_m3[lane] / 4;
    }
  }
  for (std::size_t v = 0; v < shares_m3.size(); ++v) {
    vertex_volumes_m3[v] += shares_m3[v];
    if (next[v] > first[v]) material.shares.push_back({static_cast<int>(v), first[v], next[v], shares_m3[v]});
  }
  materials.push_back(std::move(material));
}

ElementArrays ElementLanes::view() const {
  return {.groups = groups,
          .vertices = static_cast<int>(vertex_volumes_m3.size()),
          .corners = corners.data(),
          .slots = slots.data(),
          .inverse_edges = inverse_edges.data(),
          .metrics = metrics.data(),
          .volumes_m3 = volumes_m3.data(),
          .first_slots = first_slots.data()};
}

ElementArrays ElementLanes::viewOf(const MaterialLanes& material) const {
  const std::size_t lanes = static_cast<std::size_t>(material.first_group) * kLanes;
  ElementArrays arrays = view();
  arrays.groups = material.groups;
  arrays.corners += 4 * lanes;
  arrays.slots += 4 * lanes;
  arrays.inverse_edges += 9 * lanes;
  arrays.metrics += 7 * lanes;
  arrays.volumes_m3 += lanes;
  return arrays;
}

}  // namespace fissure
