// What was answered, as text, or what was thrown: equal texts are equal answers, bit for bit.
#pragma once

#include <string>

#include "certify/case_line.hpp"
#include "plumb/figure.hpp"
#include "plumb/query.hpp"
#include "query/body/any_figure.hpp"

namespace plumb::pair_cases {

/// The figure of the table as a user's.
inline plumb::AnyFigure some(const AnyFigure& s) {
  return query::with_figure(s.view(), [](const auto& shape) { return plumb::AnyFigure(shape); });
}

/// What lies in the plane lies in the plane z = 0.
struct Words {
  std::string of(Relation r) { return std::to_string(static_cast<int>(r)); }
  std::string of(bool b) { return b ? "yes" : "no"; }
  std::string of(double x) { return hexadecimal(x) + " "; }
  std::string of(std::uint32_t n) { return std::to_string(n); }
  std::string of(Sign s) { return std::to_string(static_cast<int>(s)); }
  std::string of(Location l) { return std::to_string(static_cast<int>(l)); }
  template <class Place>
  requires requires(const Place& p) {
    { p.x } -> std::convertible_to<double>;
  }
  std::string of(const Place& p) {
    double z = 0;
    if constexpr (requires { p.z; }) z = p.z;
    return of(p.x) + of(p.y) + of(z);
  }
  std::string of(const Feature& f) { return std::to_string(static_cast<int>(f.kind)) + "." + of(f.index) + " "; }
  std::string of(const ExactDistance& d) { return of(d.square) + of(d.inset); }
  std::string of(const Rational& r) { return r.text() + " "; }
  template <class Near>
  requires requires(const Near& c) { c.on_a; }
  std::string of(const Near& c) { return of(c.on_a) + of(c.on_b) + of(c.distance) + of(c.feature_a) + of(c.feature_b); }
  template <class Shot>
  requires requires(const Shot& h) {
    h.normal;
    h.t;
  }
  std::string of(const Shot& h) { return of(h.t) + of(h.point) + of(h.feature) + of(h.normal); }
  template <class Farthest>
  requires requires(const Farthest& s) { s.unique; }
  std::string of(const Farthest& s) { return of(s.point) + of(s.feature) + of(s.unique); }
  template <class Box>
  requires requires(const Box& b) { b.min.x; }
  std::string of(const Box& b) { return of(b.min) + of(b.max); }
  std::string of(const RayParameter& t) { return of(t.rounded()); }
  std::string of(const Root& t) { return of(t.rounded()); }
  std::string of(const Contact& c) { return of(c.time) + of(c.feature_a) + of(c.feature_b); }
  std::string of(const Penetration& p) {
    return of(p.depth) + of(p.direction) + of(p.translation) + of(p.feature_a) + of(p.feature_b) + of(p.is_unique);
  }
  std::string of(const GjkBounds& b) { return of(b.lower) + of(b.upper) + of(b.direction) + of(b.steps); }
  std::string of(const ContactManifold& c) {
    std::string text = of(c.relation) + of(c.normal) + of(c.distance);
    for (const ContactCorner& corner : c.corners) text += of(corner.on_a) + of(corner.on_b) + of(corner.distance);
    return text;
  }
  std::string of(const AnyIntersection& common) {
    return std::visit([this](const auto& c) { return of(c); }, common);
  }
  template <class Common>
  requires requires(const Common& c) {
    c.kind;
    c.vertices;
  }
  std::string of(const Common& c) {
    std::string text = std::to_string(static_cast<int>(c.kind)) + ":";
    for (const auto& p : c.vertices) text += of(approximate(p));
    return text;
  }
  std::string of(const FlatIntersection& c) {
    std::string text = std::to_string(static_cast<int>(c.kind)) + ":";
    if (c.point) text += of(approximate(*c.point));
    for (const ExactVector3& v : c.directions) text += of(v.x) + of(v.y) + of(v.z);
    return text;
  }
  template <class T>
  std::string of(const std::optional<T>& x) {
    return x ? of(*x) : "nothing";
  }
};
template <class Call>
std::string outcome(Call call) {
  const auto said = [](const char* type, const Error& e) { return std::string(type) + ": " + e.what(); };
  try {
    return Words().of(call());
  } catch (const InvalidShape& e) {
    return said("InvalidShape", e);
  } catch (const NonFinite& e) {
    return said("NonFinite", e);
  } catch (const Unsupported& e) {
    return said("Unsupported", e);
  } catch (const UnevenPose& e) {
    return said("UnevenPose", e);
  } catch (const BeyondDoubles& e) {
    return said("BeyondDoubles", e);
  }
}

}  // namespace plumb::pair_cases
