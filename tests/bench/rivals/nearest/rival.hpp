// Nearest neighbors by others: nanoflann's k-d tree and CGAL's, over doubles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::bench {

/// Leaves of ten points, as both have them by default; built when made.
class NanoflannTree {
 public:
  explicit NanoflannTree(const std::vector<Point3>& points);
  ~NanoflannTree();
  NanoflannTree(const NanoflannTree&) = delete;
  NanoflannTree& operator=(const NanoflannTree&) = delete;
  void nearest(const Point3& p, std::size_t k, std::uint32_t* out) const;
  [[nodiscard]] std::size_t within(const Point3& p, double radius, std::vector<std::uint32_t>& out) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

class CgalTree {
 public:
  explicit CgalTree(const std::vector<Point3>& points);
  ~CgalTree();
  CgalTree(const CgalTree&) = delete;
  CgalTree& operator=(const CgalTree&) = delete;
  void nearest(const Point3& p, std::size_t k, std::uint32_t* out) const;
  [[nodiscard]] std::size_t within(const Point3& p, double radius, std::vector<std::uint32_t>& out) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace plumb::bench
