#include "lab/trial/mesh_judge.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

#include "plumb/arith/error.hpp"

namespace plumb::lab::trial {
namespace {

constexpr int lattice_bits = 50;
constexpr std::size_t leaf_triangles = 1;  // asking one costs more than many boxes

mpz_class integer_of(double x) {
  const double units = std::ldexp(x, lattice_bits);
  if (units != std::trunc(units)) throw InvalidShape("judge: a coordinate is no multiple of 2^-50");
  return mpz_class(units);
}

const mpz_class& axis_of(const IntegerVec& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
mpz_class& axis_of(IntegerVec& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// By the axes of box and line: none of them separates.
bool may_meet(const IntegerVec& o, const IntegerVec& d, const IntegerVec& min, const IntegerVec& max) {
  for (int k = 0; k < 3; ++k) {
    const int way = sgn(axis_of(d, k));
    if (way <= 0 && axis_of(o, k) < axis_of(min, k)) return false;
    if (way >= 0 && axis_of(o, k) > axis_of(max, k)) return false;
  }
  const IntegerVec from = o * mpz_class(2) - (min + max), size = max - min;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const mpz_class off = abs(axis_of(d, j) * axis_of(from, k) - axis_of(d, k) * axis_of(from, j));
    if (off > axis_of(size, j) * abs(axis_of(d, k)) + axis_of(size, k) * abs(axis_of(d, j))) return false;
  }
  return true;
}

mpz_class gap(const mpz_class& min_a, const mpz_class& max_a, const mpz_class& min_b, const mpz_class& max_b) {
  return max_a < min_b ? mpz_class(min_b - max_a) : max_b < min_a ? mpz_class(min_a - max_b) : mpz_class(0);
}

}  // namespace

IntegerVec integer_vec(double x, double y, double z) { return {integer_of(x), integer_of(y), integer_of(z)}; }

JudgedMesh::JudgedMesh(const TriangleMesh& mesh) : order_(mesh.triangles.size()) {
  for (const auto& corners : mesh.triangles) {
    IntegerTriangle t;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& p = mesh.vertices[corners[i]];
      t[i] = integer_vec(p.x, p.y, p.z);
    }
    triangles_.push_back(std::move(t));
  }
  std::iota(order_.begin(), order_.end(), 0U);
  if (!order_.empty()) grow(0, order_.size());
}

std::size_t JudgedMesh::grow(std::size_t first, std::size_t count) {
  const std::size_t at = nodes_.size();
  const IntegerVec& corner = triangles_[order_[first]][0];
  Node node{corner, corner, first, count, 0, 0};
  for (std::size_t i = first; i < first + count; ++i) {
    for (const IntegerVec& p : triangles_[order_[i]]) {
      for (int k = 0; k < 3; ++k) {
        if (axis_of(p, k) < axis_of(node.min, k)) axis_of(node.min, k) = axis_of(p, k);
        if (axis_of(p, k) > axis_of(node.max, k)) axis_of(node.max, k) = axis_of(p, k);
      }
    }
  }
  nodes_.push_back(node);
  if (count <= leaf_triangles) return at;
  const IntegerVec size = node.max - node.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto place = [&](std::uint32_t t) {
    return mpz_class(axis_of(triangles_[t][0], axis) + axis_of(triangles_[t][1], axis) +
                     axis_of(triangles_[t][2], axis));
  };
  const auto from = order_.begin() + static_cast<std::ptrdiff_t>(first);
  const std::size_t half = count / 2;
  std::nth_element(from, from + static_cast<std::ptrdiff_t>(half), from + static_cast<std::ptrdiff_t>(count),
                   [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  const std::size_t left = grow(first, half), right = grow(first + half, count - half);
  nodes_[at].count = 0, nodes_[at].left = left, nodes_[at].right = right;
  return at;
}

template <class Enters, class Visit>
void JudgedMesh::descend(const Enters& enters, const Visit& visit) const {
  std::vector<std::size_t> later;
  if (!nodes_.empty()) later.push_back(0);
  while (!later.empty()) {
    const Node& node = nodes_[later.back()];
    later.pop_back();
    if (!enters(node)) continue;
    if (!node.is_leaf()) later.insert(later.end(), {node.right, node.left});
    for (std::size_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
  }
}

std::optional<std::uint32_t> JudgedMesh::first(const IntegerVec& o, const IntegerVec& d) const {
  std::optional<std::uint32_t> number;
  Quotient least;
  descend([&](const Node& n) { return may_meet(o, d, n.min, n.max); },
          [&](std::uint32_t i) {
            const auto at = first_meeting(o, d, triangles_[i]);
            if (!at || (number && (least < *at || (*at == least && *number < i)))) return;
            number = i, least = *at;
          });
  return number;
}

mpz_class JudgedMesh::square_apart(const Node& a, const Node& b) {
  mpz_class sum = 0;
  for (int k = 0; k < 3; ++k) {
    const mpz_class one = gap(axis_of(a.min, k), axis_of(a.max, k), axis_of(b.min, k), axis_of(b.max, k));
    sum += one * one;
  }
  return sum;
}
mpz_class JudgedMesh::square_apart(const IntegerVec& p, const Node& node) {
  return square_apart(Node{p, p, 0, 0, 0, 0}, node);
}

std::uint32_t JudgedMesh::nearest(const IntegerVec& p) const {
  using Waiting = std::pair<mpz_class, std::size_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> later;
  later.emplace(square_apart(p, nodes_[0]), 0);
  std::optional<std::pair<mpq_class, std::uint32_t>> best;
  while (!later.empty() && !(best && cmp(best->first, later.top().first) < 0)) {
    const Node& node = nodes_[later.top().second];
    later.pop();
    if (!node.is_leaf()) {
      for (const std::size_t child : {node.left, node.right}) later.emplace(square_apart(p, nodes_[child]), child);
    }
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      std::pair<mpq_class, std::uint32_t> one{square_distance(p, triangles_[order_[i]]), order_[i]};
      if (!best || one < *best) best = std::move(one);
    }
  }
  return best->second;
}

/// By their diagonals.
bool JudgedMesh::is_larger(const Node& a, const Node& b) {
  const IntegerVec u = a.max - a.min, v = b.max - b.min;
  return dot(u, u) > dot(v, v);
}

Pairs pairs_that_meet(const JudgedMesh& a, const JudgedMesh& b) {
  Pairs pairs;
  if (a.nodes_.empty() || b.nodes_.empty()) return pairs;
  std::vector<std::pair<std::size_t, std::size_t>> later{{0, 0}};
  while (!later.empty()) {
    const auto [i, k] = later.back();
    later.pop_back();
    const JudgedMesh::Node &m = a.nodes_[i], &n = b.nodes_[k];
    if (JudgedMesh::square_apart(m, n) != 0) continue;
    if (m.is_leaf() && n.is_leaf()) {
      for (std::size_t s = m.first; s < m.first + m.count; ++s) {
        for (std::size_t t = n.first; t < n.first + n.count; ++t) {
          const std::uint32_t x = a.order_[s], y = b.order_[t];
          if (triangles_meet(a.triangles_[x], b.triangles_[y])) pairs.push_back({x, y});
        }
      }
    } else if (n.is_leaf() || (!m.is_leaf() && JudgedMesh::is_larger(m, n))) {
      later.insert(later.end(), {{m.left, k}, {m.right, k}});
    } else {
      later.insert(later.end(), {{i, n.left}, {i, n.right}});
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

mpq_class square_distance(const JudgedMesh& a, const JudgedMesh& b) {
  using Waiting = std::tuple<mpz_class, std::size_t, std::size_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> later;
  const auto wait = [&](std::size_t i, std::size_t k) {
    later.emplace(JudgedMesh::square_apart(a.nodes_[i], b.nodes_[k]), i, k);
  };
  wait(0, 0);
  std::optional<mpq_class> least;
  while (!later.empty() && !(least && cmp(*least, std::get<0>(later.top())) <= 0)) {
    const auto [apart, i, k] = later.top();
    later.pop();
    const JudgedMesh::Node &m = a.nodes_[i], &n = b.nodes_[k];
    if (m.is_leaf() && n.is_leaf()) {
      for (std::size_t s = m.first; s < m.first + m.count; ++s) {
        for (std::size_t t = n.first; t < n.first + n.count; ++t) {
          mpq_class one = square_distance(a.triangles_[a.order_[s]], b.triangles_[b.order_[t]]);
          if (!least || one < *least) least = std::move(one);
        }
      }
    } else if (n.is_leaf() || (!m.is_leaf() && JudgedMesh::is_larger(m, n))) {
      wait(m.left, k), wait(m.right, k);
    } else {
      wait(i, n.left), wait(i, n.right);
    }
  }
  return *least;
}

const JudgedMesh& JudgedShelf::operator()(const MeshKey& key) {
  const auto at = made_.find(key);
  return at != made_.end() ? at->second : made_.emplace(key, JudgedMesh(mesh_of(key))).first->second;
}

}  // namespace plumb::lab::trial
