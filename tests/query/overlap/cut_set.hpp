// What of a convex set lies in a halfspace?  By its generators and what is between two of them, in rationals.
//
// Laws: exact; the parts of a set that are cut off twice may be named more than once.
// Cost: the square of the generators.
#pragma once

#include "query/overlap/round_oracle.hpp"

namespace plumb::oracle {

struct CutSet {
  CutSet(const Spanned& set, const RationalPoint& normal, const mpq_class& offset) {
    struct Generator {
      RationalPoint at;
      mpq_class weight, height;
    };
    std::vector<Generator> all;
    const auto add = [&](const RationalPoint& at, int weight) {
      all.push_back({at, weight, dot(normal, at) - weight * offset});
    };
    for (const RationalPoint& p : set.points) add(p, 1);
    for (const RationalPoint& d : set.directions) add(d, 0);
    const auto keep = [this](const RationalPoint& at, const mpq_class& weight) {
      if (sgn(weight) == 0) {
        within.directions.push_back(at);
      } else {
        within.points.push_back(times_rational(at, 1 / weight));
      }
    };
    for (const Generator& g : all) {
      if (sgn(g.height) <= 0) keep(g.at, g.weight);
      reaches_inside = reaches_inside || sgn(g.height) < 0;
      for (const Generator& f : all) {
        if (sgn(g.height) <= 0 || sgn(f.height) >= 0) continue;
        keep(sum(times_rational(f.at, g.height), -f.height, g.at), g.height * f.weight - f.height * g.weight);
      }
    }
    if (within.points.empty()) within = {};
    if (polygon_detail::is_zero(normal)) reaches_inside = offset >= 0;  // all of space
  }
  Spanned within;
  bool reaches_inside = false;  // the halfspace without its plane
};

}  // namespace plumb::oracle
