// Support mapping along the way between nearest points: which point lies farther along the way that corners of two
// bodies prove to be the least, whose numbers may be of any length?
//
// Laws: exact, by proved signs; the way leads from the second body to the first, or back.
// Source: query/separation/nearest_corners.hpp.
// Cost: that of a sign of degree 4; the way is made once in doubles, and in integers only where these do not tell.
#pragma once

#include "certify/carried_errors.hpp"
#include "query/polytope_hierarchy/nearest.hpp"

namespace plumb::query::hierarchy {

enum class Heading : unsigned char { to_first, to_second };

class NearestWay {
 public:
  NearestWay(const CoreCorners& first, const CoreCorners& second, const DifferenceCorners& corners,
             Heading heading = Heading::to_first)
      : first_(first), second_(second), corners_(corners), heading_(heading), near_(way<Running>()) {}

  template <class Text>
  [[nodiscard]] Sign sign(const Text& text) const {
    if (near_) {
      if (const Unsure<Sign> s = text(*near_).sign(); s.certain()) return s.value();
    }
    if (const auto w = way<ShortDyadic>()) {
      if (const Unsure<Sign> s = text(*w).sign(); s.certain()) return s.value();
    }
    return text(*way<BigDyadic>()).sign();
  }
  [[nodiscard]] Sign beyond(const Point3& a, const Point3& b) const {
    return sign([&]<class T>(const Vec<T>& d) { return dot(d, arith::vec<T>(a) - arith::vec<T>(b)); });
  }

 private:
  template <class T>
  [[nodiscard]] std::optional<Vec<T>> way() const {
    CertainSigns ask;
    const NearestOfCorners<T> n = nearest_of<T>(first_, second_, corners_, ask);
    if (!ask.certain()) return {};
    return heading_ == Heading::to_first ? n.way : no_way<T>() - n.way;
  }

  const CoreCorners &first_, &second_;
  const DifferenceCorners& corners_;
  Heading heading_;
  std::optional<Vec<Running>> near_;
};

}  // namespace plumb::query::hierarchy
