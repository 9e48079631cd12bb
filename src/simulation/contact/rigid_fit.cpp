#include "contact/rigid_fit.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <limits>

namespace fissure {

RigidFit::RigidFit(const SceneBody& body)
    : first_vertex_(body.first_vertex), weights_(body.rest.vertices_m.size(), 0) {
  const std::vector<Vec3>& vertices_m = body.rest.vertices_m;
  double area = 0;
  for (const Face& face : body.rest.faces) {
    const Vec3 a = vertices_m[face[1]] - vertices_m[face[0]], b = vertices_m[face[2]] - vertices_m[face[0]];
    for (const int vertex : face) weights_[vertex] += a.cross(b).norm() / 6;
    area += a.cross(b).norm() / 2;
  }
  rest_mean_m_.setZero();
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    weights_[i] /= area;
    rest_mean_m_ += weights_[i] * vertices_m[i];
  }
  for (const Vec3& vertex_m : vertices_m) rest_arms_m_.push_back(vertex_m - rest_mean_m_);
  mean_m_ = rest_mean_m_;
  rotation_.setIdentity();
  stretch_.setIdentity();
}

Vec3 RigidFit::mean(const std::vector<Vec3>& of_vertices) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < weights_.size(); ++i) sum += weights_[i] * of_vertices[first_vertex_ + i];
  return sum;
}

void RigidFit::fit(const std::vector<Vec3>& positions_m) {
  mean_m_ = mean(positions_m);
  Mat3 moved = Mat3::Zero();
  for (std::size_t i = 0; i < weights_.size(); ++i)
    moved += weights_[i] * (positions_m[first_vertex_ + i] - mean_m_) * rest_arms_m_[i].transpose();
  if (!moved.allFinite()) {
    rotation_.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const Eigen::JacobiSVD<Mat3> svd(moved, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double handedness = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Vec3 proper(1, 1, handedness < 0 ? -1 : 1);  // the smallest direction gives way to a reflection
  rotation_ = svd.matrixU() * proper.asDiagonal() * svd.matrixV().transpose();
  stretch_ = rotation_.transpose() * moved;
}

// From moved = R S with S symmetric: the skew part of R^T moved' is (W S + S W) / 2, W = R^T R' the matrix of
// the angular velocity w in the rest frame, and W S + S W is the matrix of (tr(S) - S) w.
void RigidFit::fitRates(const std::vector<Vec3>& velocities_m_s) {
  mean_velocity_m_s_ = mean(velocities_m_s);
  Mat3 moving = Mat3::Zero();
  for (std::size_t i = 0; i < weights_.size(); ++i)
    moving +=
        weights_[i] * (velocities_m_s[first_vertex_ + i] - mean_velocity_m_s_) * rest_arms_m_[i].transpose();
  const Mat3 turned = rotation_.transpose() * moving;
  const Mat3 skew = turned - turned.transpose();
  const Mat3 inertia = stretch_.trace() * Mat3::Identity() - stretch_;
  turning_rad_s_ = inertia.fullPivLu().solve(Vec3(skew(2, 1), skew(0, 2), skew(1, 0)));
}

Vec3 RigidFit::toRest(const Vec3& point_m) const {
  return rest_mean_m_ + rotation_.transpose() * (point_m - mean_m_);
}

Vec3 RigidFit::velocityInRest(const Vec3& point_m, const Vec3& velocity_m_s) const {
  const Vec3 arm_m = rotation_.transpose() * (point_m - mean_m_);
  return rotation_.transpose() * (velocity_m_s - mean_velocity_m_s_) - turning_rad_s_.cross(arm_m);
}

}  // namespace fissure
