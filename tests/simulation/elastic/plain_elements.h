#pragma once

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/tetrahedra.h"
#include "elastic/material.h"

namespace fissure {

/// The first Piola-Kirchhoff stress as material.h writes it, with the rotation from a singular value
/// decomposition.
inline Mat3 plainStress(const ElasticMaterial& material, const Mat3& f) {
  const LameConstants lame = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio);
  if (material.model == MaterialModel::neo_hookean) {
    const double mu = 4.0 / 3 * lame.mu_Pa, lambda = lame.lambda_Pa + 5.0 / 6 * lame.mu_Pa;
    const double alpha = 1 + mu / lambda - mu / (4 * lambda);
    Mat3 cofactor;
    cofactor << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
    const double volume_ratio = f.col(0).dot(cofactor.col(0));
    return mu * (1 - 1 / (f.squaredNorm() + 1)) * f + lambda * (volume_ratio - alpha) * cofactor;
  }
  if (material.model == MaterialModel::saint_venant_kirchhoff) {
    const Mat3 strain = 0.5 * (f.transpose() * f - Mat3::Identity());
    return f * (2 * lame.mu_Pa * strain + lame.lambda_Pa * strain.trace() * Mat3::Identity());
  }
  const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 v = svd.matrixV();
  if ((svd.matrixU() * v.transpose()).determinant() < 0) v.col(2) *= -1;
  const Mat3 rotation = svd.matrixU() * v.transpose();
  return 2 * lame.mu_Pa * (f - rotation) +
         lame.lambda_Pa * ((rotation.transpose() * f).trace() - 3) * rotation;
}

/// The plain way to move tetrahedra: one element at a time, without locking's remedy.
class PlainElements {
 public:
  PlainElements(const TetrahedralMesh& rest, const ElasticMaterial& material)
      : positions_m(rest.vertices_m),
        velocities_m_s(rest.vertices_m.size(), Vec3::Zero()),
        forces_N(rest.vertices_m.size(), Vec3::Zero()),
        masses_kg(rest.vertices_m.size(), 0.0),
        material_(material),
        tetrahedra_(rest.tetrahedra) {
    for (const Tetrahedron& corners : tetrahedra_) {
      const Mat3 edges = edgesOf(corners, positions_m);
      inverse_edges_.push_back(edges.inverse());
      volumes_m3_.push_back(-edges.determinant() / 6);
      for (const int corner : corners) masses_kg[corner] += material.density_kg_m3 * volumes_m3_.back() / 4;
    }
  }

  void computeForces() {
    std::fill(forces_N.begin(), forces_N.end(), Vec3::Zero());
    for (std::size_t e = 0; e < tetrahedra_.size(); ++e) {
      const Tetrahedron& corners = tetrahedra_[e];
      const Mat3 f = edgesOf(corners, positions_m) * inverse_edges_[e];
      const Mat3 of_corners = -volumes_m3_[e] * plainStress(material_, f) * inverse_edges_[e].transpose();
      for (int c = 0; c < 3; ++c) forces_N[corners[c]] += of_corners.col(c);
      forces_N[corners[3]] -= of_corners.rowwise().sum();
    }
  }

  void advance(double substep_s) {
    computeForces();
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      velocities_m_s[v] += substep_s / masses_kg[v] * forces_N[v];
      positions_m[v] += substep_s * velocities_m_s[v];
    }
  }

  std::vector<Vec3> positions_m, velocities_m_s, forces_N;
  std::vector<double> masses_kg;

 private:
  static Mat3 edgesOf(const Tetrahedron& corners, const std::vector<Vec3>& positions) {
    Mat3 edges;
    for (int c = 0; c < 3; ++c) edges.col(c) = positions[corners[c]] - positions[corners[3]];
    return edges;
  }

  ElasticMaterial material_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<Mat3> inverse_edges_;
  std::vector<double> volumes_m3_;
};

}  // namespace fissure
