#pragma once

#include <Eigen/Eigenvalues>
#include <functional>
#include <vector>

#include "block_mesh.h"
#include "elastic/element_forces.h"

namespace fissure {

/// The second material where `holds` says so of a tetrahedron's centroid.
inline ElementMaterials twoMaterials(const TetrahedralMesh& mesh, const ElasticMaterial& first,
                                     const ElasticMaterial& second,
                                     const std::function<bool(const Vec3&)>& holds) {
  ElementMaterials materials = {{first, second}, {}};
  for (const Tetrahedron& corners : mesh.tetrahedra) {
    Vec3 sum_m = Vec3::Zero();
    for (const int corner : corners) sum_m += mesh.vertices_m[corner];
    materials.of_elements.push_back(holds(sum_m / 4) ? 1 : 0);
  }
  return materials;
}

/// The stiffness and the viscous damping of small displacements and the masses, as a textbook assembles them:
/// dense.
class DenseTissue {
 public:
  DenseTissue(const TetrahedralMesh& mesh, const ElementMaterials& given)
      : stiffness(Eigen::MatrixXd::Zero(sizeOf(mesh), sizeOf(mesh))),
        damping(stiffness),
        masses_kg(Eigen::VectorXd::Zero(sizeOf(mesh))) {
    for (std::size_t m = 0; m < given.materials.size(); ++m) add(mesh, given, static_cast<int>(m));
  }

  /// Largest eigenvalue of `matrix` and the masses, over the vertices that are not `held`.
  double largest(const Eigen::MatrixXd& matrix, const std::vector<int>& held) const {
    Eigen::VectorXd scale = masses_kg.cwiseSqrt().cwiseInverse();
    for (const int v : held) scale.segment<3>(3 * v).setZero();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
  }

  Eigen::MatrixXd stiffness, damping;
  Eigen::VectorXd masses_kg;  ///< three times each

 private:
  static Eigen::Index sizeOf(const TetrahedralMesh& mesh) {
    return 3 * static_cast<Eigen::Index>(mesh.vertices_m.size());
  }

  void add(const TetrahedralMesh& mesh, const ElementMaterials& given, int number) {
    const ElasticMaterial& material = given.materials[static_cast<std::size_t>(number)];
    const double mu_Pa = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio).mu_Pa;
    const VolumeSplit split = splitVolume(material);
    const Eigen::Index size = sizeOf(mesh);
    Eigen::MatrixXd volume_changes = Eigen::MatrixXd::Zero(size / 3, size);  // of each vertex, m^3
    Eigen::VectorXd volumes_m3 = Eigen::VectorXd::Zero(size / 3);
    for (std::size_t e = 0; e < mesh.tetrahedra.size(); ++e) {
      if (given.of_elements[e] != number) continue;
      const Tetrahedron& corners = mesh.tetrahedra[e];
      Mat3 edges;
      for (int c = 0; c < 3; ++c) edges.col(c) = mesh.vertices_m[corners[c]] - mesh.vertices_m[corners[3]];
      Eigen::Matrix<double, 4, 3> slopes;  // of the shape functions
      slopes.topRows<3>() = edges.inverse();
      slopes.row(3) = -slopes.topRows<3>().colwise().sum();
      const double volume_m3 = -edges.determinant() / 6;
      for (int a = 0; a < 4; ++a) {
        const Vec3 of_a = slopes.row(a);
        for (int b = 0; b < 4; ++b) {
          const Vec3 of_b = slopes.row(b);
          const Mat3 shear = of_b * of_a.transpose() + of_a.dot(of_b) * Mat3::Identity();
          stiffness.block<3, 3>(3 * corners[a], 3 * corners[b]) +=
              volume_m3 * (split.elements_Pa * of_a * of_b.transpose() + mu_Pa * shear);
          damping.block<3, 3>(3 * corners[a], 3 * corners[b]) += volume_m3 * material.viscosity_Pa_s * shear;
          volume_changes.block<1, 3>(corners[a], 3 * corners[b]) += volume_m3 / 4 * of_b.transpose();
        }
        masses_kg.segment<3>(3 * corners[a]).array() += material.density_kg_m3 * volume_m3 / 4;
        volumes_m3[corners[a]] += volume_m3 / 4;
      }
    }
    for (Eigen::Index v = 0; v < volumes_m3.size(); ++v)
      if (volumes_m3[v] > 0)
        stiffness +=
            split.averaged_Pa / volumes_m3[v] * volume_changes.row(v).transpose() * volume_changes.row(v);
  }
};

}  // namespace fissure
