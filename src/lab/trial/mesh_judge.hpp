// Which triangle does a ray meet first, which is nearest to a point, which pairs meet, how far are meshes apart?  By
// asking all triangles in GMP's integers, but for those whose boxes exact comparisons exclude.
//
// Laws: (1) exact, as if every triangle were asked; of equal ones the lowest number.  (2) Neither trees nor tests of
// the library have a part in it.
// A coordinate that is no multiple of 2^-50 throws InvalidShape.
// Source: none.
// Cost: up to a millisecond a question; some ten microseconds a pair that meets.
#pragma once

#include <map>
#include <vector>

#include "lab/trial/exact_meet.hpp"
#include "lab/trial/mesh_scenes.hpp"
#include "tool/trial/contestant.hpp"

namespace plumb::lab::trial {

/// In units of 2^-50.
IntegerVec integer_vec(double x, double y, double z);

class JudgedMesh {
 public:
  explicit JudgedMesh(const TriangleMesh& mesh);

  /// No number where the ray meets none; o and d in units of 2^-50.
  [[nodiscard]] std::optional<std::uint32_t> first(const IntegerVec& o, const IntegerVec& d) const;
  [[nodiscard]] std::uint32_t nearest(const IntegerVec& p) const;  // the mesh has triangles
  [[nodiscard]] const IntegerTriangle& triangle(std::uint32_t number) const { return triangles_[number]; }
  [[nodiscard]] std::size_t size() const { return triangles_.size(); }

  /// Ascending.
  friend Pairs pairs_that_meet(const JudgedMesh& a, const JudgedMesh& b);
  /// In units of 2^-100; of meshes that have triangles.
  friend mpq_class square_distance(const JudgedMesh& a, const JudgedMesh& b);

 private:
  struct Node {
    IntegerVec min, max;
    std::size_t first, count;  // of a leaf, in order_
    std::size_t left, right;   // else: its children
    [[nodiscard]] bool is_leaf() const { return count != 0; }
  };
  std::size_t grow(std::size_t first, std::size_t count);
  template <class Enters, class Visit>
  void descend(const Enters& enters, const Visit& visit) const;
  static mpz_class square_apart(const Node& a, const Node& b);
  static mpz_class square_apart(const IntegerVec& p, const Node& node);

  static bool is_larger(const Node& a, const Node& b);

  std::vector<IntegerTriangle> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;  // the root first
};

Pairs pairs_that_meet(const JudgedMesh& a, const JudgedMesh& b);
mpq_class square_distance(const JudgedMesh& a, const JudgedMesh& b);

/// Each mesh that is asked for is made once.
class JudgedShelf {
 public:
  const JudgedMesh& operator()(const MeshKey& key);

 private:
  std::map<MeshKey, JudgedMesh> made_;
};

}  // namespace plumb::lab::trial
