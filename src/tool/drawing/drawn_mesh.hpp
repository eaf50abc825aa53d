// How does a script that draws meshes have them?  As points in the cube about all of them, numbers from -1 to 1, and
// triangles over those points that are drawn.
//
// Laws: (1) a number is rounded to a ten-millionth, for pictures alone; (2) a vertex that no triangle names is not held, for
// it may be anywhere; (3) no number is too large, whatever the doubles are.
// Source: none.
// Cost: linear.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::tool {

class DrawnCube {
 public:
  explicit DrawnCube(std::span<const TriangleMesh> meshes) {
    std::array<double, 3> least{}, most{};
    bool any = false;
    for (const TriangleMesh& mesh : meshes) {
      for (const auto& t : mesh.triangles) {
        for (const std::uint32_t v : t) {
          const std::array<double, 3> p = quarter(mesh.vertices[v]);
          for (std::size_t k = 0; k < 3; ++k) {
            least[k] = any ? std::min(least[k], p[k]) : p[k];
            most[k] = any ? std::max(most[k], p[k]) : p[k];
          }
          any = true;
        }
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      middle_[k] = least[k] / 2 + most[k] / 2;
      half_ = std::max(half_, most[k] / 2 - least[k] / 2);
    }
    if (half_ == 0) half_ = 1;
  }

  [[nodiscard]] std::array<double, 3> of(const Point3& p) const {
    std::array<double, 3> x = quarter(p);
    for (std::size_t k = 0; k < 3; ++k) x[k] = std::round((x[k] - middle_[k]) / half_ * 1e7) / 1e7;
    return x;
  }
  /// How long a picture's 1 is in the meshes.
  [[nodiscard]] double unit() const { return half_ * 4; }

 private:
  static std::array<double, 3> quarter(const Point3& p) { return {p.x / 4, p.y / 4, p.z / 4}; }
  std::array<double, 3> middle_{};  // of a quarter of the coordinates, whose differences are numbers
  double half_ = 0;
};

/// What is drawn of a mesh: points in a row, and three of their numbers a triangle.
class DrawnMesh {
 public:
  DrawnMesh(const TriangleMesh& mesh, const DrawnCube& cube)
      : mesh_(mesh), cube_(cube), number_(mesh.vertices.size(), none) {}

  std::uint32_t number_of(std::uint32_t vertex) {
    if (number_[vertex] == none) {
      number_[vertex] = static_cast<std::uint32_t>(points_.size() / 3);
      for (const double x : cube_.of(mesh_.vertices[vertex])) points_.push_back(x);
    }
    return number_[vertex];
  }
  void add(std::uint32_t triangle) {
    for (const std::uint32_t v : mesh_.triangles[triangle]) triangles_.push_back(number_of(v));
  }
  [[nodiscard]] const std::vector<double>& points() const { return points_; }
  [[nodiscard]] const std::vector<std::uint32_t>& triangles() const { return triangles_; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  const TriangleMesh& mesh_;
  const DrawnCube& cube_;
  std::vector<std::uint32_t> number_, triangles_;
  std::vector<double> points_;
};

}  // namespace plumb::tool
