#include "elastic/stiff_elements.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "elastic/critical_step.h"

namespace fissure {

namespace {

/// What the stiffness of a tetrahedron follows from.
struct Element {
  double volume_m3 = 0;
  Eigen::Matrix<double, 4, 3> gradients_1_m;  ///< of its shape functions, one row per corner
};

Element elementOf(const TetrahedralMesh& mesh, const Tetrahedron& tetrahedron) {
  const auto corner = [&](std::size_t k) -> const Vec3& {
    return mesh.vertices_m[static_cast<std::size_t>(tetrahedron[k])];
  };
  Eigen::Matrix3d edges_m;
  for (std::size_t k = 0; k < 3; ++k) edges_m.col(static_cast<Eigen::Index>(k)) = corner(k) - corner(3);
  Element element;
  element.volume_m3 = std::abs(edges_m.determinant()) / 6;
  element.gradients_1_m.topRows<3>() = edges_m.inverse();
  element.gradients_1_m.row(3) = -element.gradients_1_m.topRows<3>().colwise().sum();
  return element;
}

const ElasticMaterial& materialAt(const ElementMaterials& materials, std::size_t element) {
  return materials
      .materials[materials.of_elements.empty() ? 0
                                               : static_cast<std::size_t>(materials.of_elements[element])];
}

/// Largest stable substep, seconds, if only this tetrahedron had a stiffness.
double stableStep_s(const Element& element, const std::array<double, 4>& masses_kg,
                    const ElasticMaterial& material) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (Eigen::Index k = 0; k < 4; ++k)
    squares += element.gradients_1_m.row(k).transpose() * element.gradients_1_m.row(k) /
               masses_kg[static_cast<std::size_t>(k)];
  const double of_modulus =
      element.volume_m3 * Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares, Eigen::EigenvaluesOnly)
                              .eigenvalues()
                              .maxCoeff();
  const LameConstants lame = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio);
  return StepLimit{of_modulus * (lame.lambda_Pa + 2 * lame.mu_Pa), of_modulus * 2 * material.viscosity_Pa_s}
      .step_s();
}

}  // namespace

std::vector<int> stiffestElements(const TetrahedralMesh& mesh, const ElementMaterials& materials) {
  const std::size_t count = mesh.tetrahedra.size();
  std::vector<double> masses_kg(mesh.vertices_m.size(), 0.0);
  for (std::size_t t = 0; t < count; ++t) {
    const double mass_kg =
        elementOf(mesh, mesh.tetrahedra[t]).volume_m3 * materialAt(materials, t).density_kg_m3;
    for (const int v : mesh.tetrahedra[t]) masses_kg[static_cast<std::size_t>(v)] += mass_kg / 4;
  }
  std::vector<double> steps_s;
  for (std::size_t t = 0; t < count; ++t) {
    std::array<double, 4> corners_kg{};
    for (std::size_t k = 0; k < 4; ++k)
      corners_kg[k] = masses_kg[static_cast<std::size_t>(mesh.tetrahedra[t][k])];
    steps_s.push_back(
        stableStep_s(elementOf(mesh, mesh.tetrahedra[t]), corners_kg, materialAt(materials, t)));
  }
  std::vector<int> elements(count);
  std::iota(elements.begin(), elements.end(), 0);
  const auto some = elements.begin() + static_cast<std::ptrdiff_t>((count + 99) / 100);
  std::partial_sort(elements.begin(), some, elements.end(), [&](int a, int b) {
    const double of_a_s = steps_s[static_cast<std::size_t>(a)], of_b_s = steps_s[static_cast<std::size_t>(b)];
    return of_a_s != of_b_s ? of_a_s < of_b_s : a < b;
  });
  elements.erase(some, elements.end());
  return elements;
}

ElementMaterials softened(ElementMaterials materials, const TetrahedralMesh& mesh,
                          const std::vector<int>& elements) {
  constexpr double share = 1e-3;
  materials.of_elements.resize(mesh.tetrahedra.size(), 0);
  const std::size_t count = materials.materials.size();
  for (std::size_t m = 0; m < count; ++m) {
    ElasticMaterial soft = materials.materials[m];
    soft.youngs_modulus_Pa *= share;
    soft.viscosity_Pa_s *= share;
    materials.materials.push_back(soft);
  }
  for (const int t : elements) materials.of_elements[static_cast<std::size_t>(t)] += static_cast<int>(count);
  return materials;
}

}  // namespace fissure
