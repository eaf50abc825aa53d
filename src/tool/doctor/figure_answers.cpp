// The digest's answers about figures in pairs.
#include "plumb/figure/generated/generated.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "plumb/query/variant/questions.hpp"
#include "tool/doctor/digest.hpp"

namespace plumb::tool {
namespace {

using FigureMaker = AnyFigure (*)(std::span<const double>);
struct DigestKind {
  degenerate::ShapeKind kind;
  FigureMaker make;
};

std::vector<DigestKind> digest_kinds(int dimension) {
  std::vector<DigestKind> found;
  for (std::size_t k = 0; k < figure_kinds; ++k) {
    query::with_figure_type({static_cast<FigureKind>(k), dimension, nullptr}, [&]<class Shape>(const Shape*) {
      if constexpr (GeneratedShape<Shape>) {
        if (generated_dimension<Shape> == dimension)
          found.push_back(
              {generated_kind<Shape>, [](std::span<const double> x) { return AnyFigure(shape_from<Shape>(x)); }});
      }
    });
  }
  return found;
}

/// Calls `of_pair` with figures of each two kinds that lie in special positions; points of one plane are no polyhedron.
template <class OfPair>
void for_each_digest_pair(HashedAnswers& to, std::uint64_t seed, std::uint64_t times, const OfPair& of_pair) {
  std::uint64_t number = 0;
  for (const int dimension : {2, 3}) {
    const std::vector<DigestKind> kinds = digest_kinds(dimension);
    for (const DigestKind& a : kinds) {
      for (const DigestKind& b : kinds) {
        for (std::uint64_t i = 0; i < times; ++i) {
          Entropy e(seed, number++);
          to.ask([&] {
            const degenerate::ShapePair pair = degenerate::any_shape_pair(a.kind, b.kind, dimension, e);
            of_pair(a.make(pair.a), b.make(pair.b));
          });
        }
      }
    }
  }
}

}  // namespace

void answer_relations(HashedAnswers& to, std::uint64_t times) {
  for_each_digest_pair(to, 3, times, [&to](const AnyFigure& a, const AnyFigure& b) {
    to.ask([&] { to.add(relate(a, b)); });
    to.ask([&] { to.add(contains(a, b)); });
    to.ask([&] {
      const std::optional<Hit> hit = first_hit(a, b);
      to.add(hit.has_value());
      if (hit) to.add(hit->t), to.add(hit->point);
    });
  });
}

void answer_distances(HashedAnswers& to, std::uint64_t times) {
  for_each_digest_pair(to, 4, times, [&to](const AnyFigure& a, const AnyFigure& b) {
    to.ask([&] { to.add(distance(a, b)); });
    to.ask([&] {
      const Closest c = closest_points(a, b);
      to.add(c.on_a), to.add(c.on_b);
      for (const Feature& feature : {c.feature_a, c.feature_b}) to.add(feature.kind), to.add(feature.index);
    });
  });
}

}  // namespace plumb::tool
