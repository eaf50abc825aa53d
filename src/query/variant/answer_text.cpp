#include "query/variant/answer_text.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "certify/case_line.hpp"

namespace plumb::query {
namespace {

/// Words and numbers, each behind a blank.
class Words {
 public:
  Words& operator()(std::string_view word) {
    parts_.word(word);
    return *this;
  }
  Words& operator()(const char* word) { return (*this)(std::string_view(word)); }
  Words& operator()(double x) {
    parts_.number(x);
    return *this;
  }
  Words& operator()(bool is_so) { return (*this)(is_so ? "yes" : "no"); }
  Words& operator()(std::uint32_t n) {
    parts_.count(n);
    return *this;
  }
  Words& operator()(const Rational& r) { return (*this)(r.text()); }
  Words& operator()(Relation relation) {
    constexpr std::array<std::string_view, 3> names{"disjoint", "touching", "overlapping"};
    return (*this)(names[static_cast<std::size_t>(static_cast<int>(relation) + 1)]);
  }
  Words& operator()(const Feature& f) {
    constexpr std::array<std::string_view, 4> kinds{"vertex", "edge", "face", "interior"};
    return (*this)(kinds[static_cast<std::size_t>(f.kind)])(f.index);
  }
  /// A point or a direction.
  template <class Place>
  requires requires(const Place& p) { p.x; }
  Words& operator()(const Place& p) {
    if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(p.x)>, double>) {
      return (*this)(p.x)(p.y)(p.z);
    } else {
      std::array<double, 3> all{p.x, p.y, 0};
      if constexpr (requires { p.z; }) all[2] = p.z;
      parts_.numbers(all);
      return *this;
    }
  }
  [[nodiscard]] const LineParts& parts() const { return parts_; }

 private:
  LineParts parts_;
};

/// An intersection with corners is told by what it is, and by these, rounded once.
template <class Common>
void tell_common(const Common& common, Words& words) {
  constexpr std::array<std::string_view, 7> kinds{"nothing", "point", "segment", "ray", "line", "polygon", "solid"};
  words(kinds[static_cast<std::size_t>(common.kind)]);
  for (const auto& p : common.vertices) words(approximate(p));
  if constexpr (requires { common.directions; }) {
    for (const auto& d : common.directions) words("direction")(d);
    for (std::size_t f = 0; f < common.faces(); ++f) {
      words("face");
      for (const std::uint32_t corner : common.corners_of(f)) words(corner);
    }
  }
}
void tell_common(const FlatIntersection& common, Words& words) {
  constexpr std::array<std::string_view, 5> kinds{"nothing", "point", "line", "plane", "space"};
  words(kinds[static_cast<std::size_t>(static_cast<int>(common.kind) + 1)]);
  if (common.point) words(approximate(*common.point));
  for (const ExactVector3& d : common.directions) words("direction")(d);
}

}  // namespace

LineParts answer_parts(Relation relation) { return Words()(relation).parts(); }
LineParts answer_parts(Location location) {
  constexpr std::array<std::string_view, 3> names{"outside", "boundary", "inside"};
  return Words()(names[static_cast<std::size_t>(static_cast<int>(location) + 1)]).parts();
}
LineParts answer_parts(bool is_so) { return Words()(is_so).parts(); }
LineParts answer_parts(double number) { return Words()(number).parts(); }
LineParts answer_parts(const ExactDistance& d) { return Words()(d.square)(d.inset).parts(); }
LineParts answer_parts(const Closest& c) {
  return Words()(c.distance)(c.on_a)(c.on_b)(c.feature_a)(c.feature_b).parts();
}
LineParts answer_parts(const Hit& h) { return Words()(h.t)(h.point)(h.feature)(h.normal).parts(); }
LineParts answer_parts(const RayParameter& t) { return Words()(t.rounded()).parts(); }
LineParts answer_parts(const Root& time) { return Words()(time.rounded()).parts(); }
LineParts answer_parts(const Contact& c) { return Words()(c.time)(c.feature_a)(c.feature_b).parts(); }
LineParts answer_parts(const Penetration& p) {
  return Words()(p.depth)(p.direction)(p.translation)(p.feature_a)(p.feature_b)(p.is_unique).parts();
}
LineParts answer_parts(const ContactManifold& m) {
  Words words;
  words(m.relation)(m.distance)(m.normal);
  for (const ContactCorner& c : m.corners) words("corner")(c.id.a)(c.id.b)(c.on_a)(c.on_b)(c.distance);
  return words.parts();
}
LineParts answer_parts(const Support3& s) { return Words()(s.point)(s.feature)(s.unique).parts(); }
LineParts answer_parts(const Aabb3& box) { return Words()(box.min)(box.max).parts(); }
LineParts answer_parts(const AnyIntersection& common) {
  Words words;
  std::visit([&words](const auto& is) { tell_common(is, words); }, common);
  return words.parts();
}
std::string refusal_text(const Error& error) {
  std::string text = std::string("refused: ") + error.what();
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' ' || c == '#'; }, ' ');
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

}  // namespace plumb::query
