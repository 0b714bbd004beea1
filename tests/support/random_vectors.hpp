// Random vectors and rotations for the tests of oblique impacts.
#pragma once
#include <Eigen/Geometry>

#include <random>

namespace support {

class random_vectors {
public:
  Eigen::Vector3d next(double size) {
    std::normal_distribution<> normal;
    return size * Eigen::Vector3d(normal(generator_), normal(generator_), normal(generator_));
  }
  Eigen::Quaterniond rotation() {
    std::normal_distribution<> normal;
    return Eigen::Quaterniond(normal(generator_), normal(generator_), normal(generator_), normal(generator_))
        .normalized();
  }

private:
  std::mt19937_64 generator_{7};
};

} // namespace support
