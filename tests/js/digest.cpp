// Are the signs of this build those of the digest that stands in the repository?  What is asked of batches there is
// asked one by one here, for batches need Highway and threads: the answers must be the same.
#include "tool/doctor/digest.hpp"

#include <cstdio>

#include "plumb/certify/batch.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

template <class Question, class... Points>
void one_by_one(const Question& question, std::span<Sign> out, const Points&... points) {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = question(points[i]...);
}

}  // namespace

void orient2d(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> c, std::span<Sign> out,
              Execution) {
  one_by_one([](const auto&... p) { return orient2d(p...); }, out, a, b, c);
}
void orient3d(std::span<const Point3> a, std::span<const Point3> b, std::span<const Point3> c,
              std::span<const Point3> d, std::span<Sign> out, Execution) {
  one_by_one([](const auto&... p) { return orient3d(p...); }, out, a, b, c, d);
}
void incircle(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> c,
              std::span<const Point2> d, std::span<Sign> out, Execution) {
  one_by_one([](const auto&... p) { return incircle(p...); }, out, a, b, c, d);
}
void insphere(std::span<const Point3> a, std::span<const Point3> b, std::span<const Point3> c,
              std::span<const Point3> d, std::span<const Point3> e, std::span<Sign> out, Execution) {
  one_by_one([](const auto&... p) { return insphere(p...); }, out, a, b, c, d, e);
}

}  // namespace plumb

int main() {
  using namespace plumb::tool;
  bool good = true;
  for (const DigestSize size : {DigestSize::small, DigestSize::full}) {
    for (const std::size_t part : {0u, 1u}) {
      HashedAnswers answers;
      digest_parts[part].answer(answers, size == DigestSize::full ? 16 : 1);
      const PartDigest found{answers.count(), answers.hash()};
      const bool is = found == expected_digest(size).parts[part];
      std::printf("%s %llu answers, %016llx: %s\n", part == 0 ? "signs" : "batches",
                  static_cast<unsigned long long>(found.count), static_cast<unsigned long long>(found.hash),
                  is ? "as expected" : "DIFFER");
      good = good && is;
    }
  }
  return good ? 0 : 1;
}
