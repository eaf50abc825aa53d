// Who else answers the tasks of `plumb-lab chart`?  Libraries that people use, as methods; the program plumb-bench is plumb
// with these, and is not installed.
//
// Laws: (1) a library's shapes are made before the clock runs, by the numbers that it computes in, and its function is
// called as its users call it; `about` names the call. (2) What it reports as failure, by exception or by code, is
// unsure, not wrong. (3) No library is asked what it does not claim to answer: where touching is its own affair,
// docs/charts.md says so.
// Source: none.
// Cost: none, a list.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lab/trial/float_methods.hpp"
#include "lab/trial/tasks.hpp"

namespace plumb::bench {

using Rivals = std::vector<lab::trial::Rival>;

void add_bullet(Rivals& all);
void add_bullet_meshes(Rivals& all);
void add_ccd(Rivals& all);
void add_cgal_figures(Rivals& all);
void add_cgal_meshes(Rivals& all);
void add_cgal_predicates(Rivals& all);
void add_cgal_triangulations(Rivals& all);
void add_crowds(Rivals& all);
void add_eigen(Rivals& all);
void add_embree(Rivals& all);
void add_embree_meshes(Rivals& all);
void add_fcl(Rivals& all);
void add_fcl_meshes(Rivals& all);
void add_qhull(Rivals& all);

/// Joins a task whose questions have N numbers: `make` turns them into the library's shapes, `take` is measured.
template <std::size_t N, class Make, class Take>
void join(Rivals& all, const char* task, std::string name, std::string about, Make make, Take take) {
  all.push_back({task, lab::trial::each_made<N>(std::move(name), std::move(about), make, take)});
}

/// The same where the library takes plain numbers.
template <std::size_t N, class Take>
void join(Rivals& all, const char* task, std::string name, std::string about, Take take) {
  all.push_back({task, lab::trial::each_of<double, N>(std::move(name), std::move(about), take)});
}

/// A method of a library that asks for triangles that are not flat, of questions that name so many meshes: of classes
/// with such triangles it is not asked.
lab::trial::Method without_flat_triangles(lab::trial::Method method, std::size_t meshes);

/// A point of a question as a bit; of equal ones the first stands for all.
template <std::size_t Dimension, std::size_t N>
std::uint32_t bit_of(const std::array<double, N>& q, const double* point) {
  std::size_t first = 0;
  while (!std::equal(point, point + Dimension, &q[first * Dimension])) ++first;
  return std::uint32_t{1} << first;
}

}  // namespace plumb::bench
