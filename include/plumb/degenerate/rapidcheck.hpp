// How does RapidCheck draw hard inputs?  The bridge from streams of choices to RapidCheck's generators.
//
// Laws: (1) a case is made by `make(Entropy&)` alone, so RapidCheck's own numbers never reach a coordinate; (2)
// shrinking replays shrunken choices, so every shrunken case is one that the generator can make.
// Source: RapidCheck's Gen and Shrinkable; shrinking as in degenerate/shrink.hpp.
// Cost: that of the case.
// Only this header of the library needs RapidCheck, and only those who include it.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/degenerate/kind.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/shape_pair.hpp"
#include "plumb/degenerate/shrink.hpp"

namespace plumb {

/// How RapidCheck writes points: in hexadecimal, so that a failure can be typed in again.
inline void showValue(const Point2& p, std::ostream& out) { out << std::hexfloat << '(' << p.x << ' ' << p.y << ')'; }
inline void showValue(const Point3& p, std::ostream& out) {
  out << std::hexfloat << '(' << p.x << ' ' << p.y << ' ' << p.z << ')';
}

/// The case that `make` makes of these choices, with its shrinks.
template <class Make, class Case = std::decay_t<std::invoke_result_t<const Make&, Entropy&>>>
rc::Shrinkable<Case> shrinkable_case(const Make& make, std::vector<std::uint64_t> choices) {
  struct Shrinks {
    Make make;
    ChoiceShrinks rest;
    rc::Maybe<rc::Shrinkable<Case>> operator()() {
      if (!rest.next()) return rc::Nothing;
      return shrinkable_case(make, rest.candidate());
    }
  };
  const auto value = [make, choices] {
    Entropy entropy = Entropy::from_choices(choices);
    return make(entropy);
  };
  const auto shrinks = [make, choices] { return rc::Seq<rc::Shrinkable<Case>>(Shrinks{make, ChoiceShrinks(choices)}); };
  return rc::shrinkable::lambda(value, shrinks);
}

/// A RapidCheck generator of whatever `make(Entropy&)` makes.
template <class Make, class Case = std::decay_t<std::invoke_result_t<const Make&, Entropy&>>>
rc::Gen<Case> generator_of(Make make) {
  return rc::Gen<Case>([make](const rc::Random& random, int) {
    rc::Random numbers = random;
    Entropy entropy(numbers.next());
    std::vector<std::uint64_t> choices;
    entropy.record_into(&choices);
    make(entropy);
    return shrinkable_case(make, std::move(choices));
  });
}

/// Points of any family.
inline rc::Gen<std::vector<Point2>> any_points2(Degeneracy degeneracy, std::size_t count) {
  return generator_of([=](Entropy& entropy) {
    const Family family = any_family(entropy);
    return points2(family, degeneracy, count, entropy);
  });
}

inline rc::Gen<std::vector<Point3>> any_points3(Degeneracy degeneracy, std::size_t count) {
  return generator_of([=](Entropy& entropy) {
    const Family family = any_family(entropy);
    return points3(family, degeneracy, count, entropy);
  });
}

namespace degenerate {

/// A case of a kind (query/kinds/kinds.hpp), of any of its generators.
inline rc::Gen<Numbers> any_case(const Kind& kind) {
  return generator_of([kind](Entropy& entropy) {
    Numbers numbers;
    kind.generators[entropy.below(kind.generators.size())].make(numbers, entropy);
    return numbers;
  });
}

inline void showValue(const ShapePair& pair, std::ostream& out) {
  for (const auto* numbers : {&pair.a, &pair.b}) {
    out << std::hexfloat << '(';
    for (const double x : *numbers) out << ' ' << x;
    out << " )";
  }
}

/// Two shapes in any position.
inline rc::Gen<ShapePair> any_pair(ShapeKind a, ShapeKind b, int dimension) {
  return generator_of([=](Entropy& entropy) { return any_shape_pair(a, b, dimension, entropy); });
}

}  // namespace degenerate

}  // namespace plumb
