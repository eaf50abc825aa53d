// Do all ways of asking about two shapes agree, whatever the shapes and their position?
//
// relate in both orders, intersects in both orders, and the exact distance, which is zero just where they meet; of a
// pair that was made to lie so, what its position promises.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <span>

#include "plumb/figure/generated/generated.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb::fuzz {
namespace {

using degenerate::Nearness;
using degenerate::Position;
using degenerate::ShapeKind;
using degenerate::ShapePair;

struct Promise {
  bool meets = false, apart = false, overlaps = false;
};

Promise promise_of(Position position) {
  if (position <= Position::shared_face) return {.meets = true};
  if (position == Position::parallel) return {.apart = true};
  return {.overlaps = position >= Position::concentric};
}

/// From the bytes: a pair in some position, exactly or nearly so, or numbers as they stand.
ShapePair pair_of(ShapeKind a, ShapeKind b, int dimension, std::span<const std::uint8_t> bytes, Promise& promise) {
  if (bytes.empty() || bytes[0] % 4 != 3) {
    Entropy entropy = Entropy::from_bytes(bytes);
    const Nearness nearness = entropy.below(4) == 0 ? Nearness::nearly : Nearness::exactly;
    Position position = degenerate::positions[entropy.below(degenerate::positions.size())].position;
    if (!degenerate::has_position(a, b, dimension, position)) position = Position::concentric;
    if (nearness == Nearness::exactly) promise = promise_of(position);
    return degenerate::shape_pair(a, b, dimension, position, nearness, entropy);
  }
  bytes = bytes.subspan(1);
  const auto numbers = [&](ShapeKind kind) {
    std::size_t count = degenerate::shape_size(kind, dimension);
    if (count == 0) count = static_cast<std::size_t>(dimension) * (bytes.empty() ? 3 : 3 + bytes[0] % 6);
    std::vector<double> made(count);
    const std::size_t taken = std::min(bytes.size(), count * sizeof(double));
    if (taken != 0) std::memcpy(made.data(), bytes.data(), taken);
    bytes = bytes.subspan(taken);
    return made;
  };
  std::vector<double> first = numbers(a);
  return {std::move(first), numbers(b), {}, {}};
}

template <class A, class B>
void ask(const ShapePair& pair, const Promise& promise) {
  const auto require = [&](bool holds, std::string_view what) {
    if (holds) return;
    std::cerr << degenerate::name_of(generated_kind<A>) << " and " << degenerate::name_of(generated_kind<B>) << " of "
              << generated_dimension<A> << "D: " << what << std::hexfloat;
    for (const auto* numbers : {&pair.a, &pair.b}) {
      std::cerr << "\n";
      for (const double x : *numbers) std::cerr << ' ' << x;
    }
    std::cerr << std::endl;
    std::abort();
  };
  const auto [a, b] = pair_from<A, B>(pair);
  const Relation relation = relate(a, b);
  const bool meets = relation != Relation::disjoint;
  require(relate(b, a) == relation, "relate is not symmetric");
  require(intersects(a, b) == meets && intersects(b, a) == meets, "intersects and relate differ");
  require(!promise.meets || meets, "they were made to meet");
  require(!promise.apart || !meets, "they were made to lie apart");
  require(!promise.overlaps || relation == Relation::overlapping, "they were made to overlap");
  if constexpr (HasDistance<A, B>) {
    require((compare_distance(a, b, 0.0) == Sign::zero) == meets, "the distance is not zero just where they meet");
  }
}

template <class... S>
struct Shapes {
  static constexpr std::size_t count = sizeof...(S);
};
using Shapes2 = Shapes<Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2, Quadrilateral2, Polygon2, HoledPolygon2,
                       Aabb2, Obb2, Circle2, Capsule2, KDop2, HalfspaceIntersection2>;
using Shapes3 = Shapes<Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Triangle3, Quadrilateral3,
                       Polygon3, HoledPolygon3, Rectangle3, Tetrahedron3, Aabb3, Obb3, Sphere3, Capsule3, Lozenge3,
                       Cylinder3, Cone3, KDop3, HalfspaceIntersection3, ConvexPolyhedron3>;

/// Calls visit(shape type) for the one of that number.
template <class... S, class Visit>
void with(Shapes<S...>, std::size_t which, const Visit& visit) {
  std::size_t at = 0;
  ((at++ == which ? visit(static_cast<const S*>(nullptr)) : void()), ...);
}

template <class All>
void run(All all, std::span<const std::uint8_t> bytes) {
  with(all, bytes[0] % All::count, [&]<class A>(const A*) {
    with(all, bytes[1] % All::count, [&]<class B>(const B*) {
      if constexpr (RelatedPair<A, B>) {
        Promise promise;
        ShapePair pair =
            pair_of(generated_kind<A>, generated_kind<B>, generated_dimension<A>, bytes.subspan(2), promise);
        try {
          ask<A, B>(pair, promise);
        } catch (const InvalidShape&) {
        } catch (const NonFinite&) {
        } catch (const BeyondDoubles&) {
        }
      }
    });
  });
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const std::span<const std::uint8_t> bytes(data + 1, size - 1);
  if (data[0] % 4 == 0) {
    plumb::fuzz::run(plumb::fuzz::Shapes2{}, bytes);
  } else {
    plumb::fuzz::run(plumb::fuzz::Shapes3{}, bytes);
  }
  return 0;
}
