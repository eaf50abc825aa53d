// What was answered, as text, or what was thrown: equal texts are equal answers, bit for bit.
#pragma once

#include <string>

#include "certify/case_line.hpp"
#include "plumb/figure.hpp"
#include "plumb/query.hpp"
#include "query/body/any_figure.hpp"
#include "query/variant/answer_text.hpp"

namespace plumb::pair_cases {

/// The figure of the table as a user's.
inline plumb::AnyFigure some(const AnyFigure& s) {
  return query::with_figure(s.view(), [](const auto& shape) { return plumb::AnyFigure(shape); });
}

/// As a recorder writes it; what lies in the plane lies in the plane z = 0.
std::string words(const auto& answer) { return query::answer_text(answer); }
inline Point3 lifted(const Point2& p) { return {p.x, p.y, 0}; }
inline std::string words(const Closest2& c) {
  return words(Closest{lifted(c.on_a), lifted(c.on_b), c.distance, c.feature_a, c.feature_b});
}
inline std::string words(const Hit2& h) {
  return words(Hit{h.t, lifted(h.point), h.feature, {h.normal.x, h.normal.y, 0}});
}
inline std::string words(const Support2& s) { return words(Support3{lifted(s.point), s.feature, s.unique}); }
inline std::string words(const Aabb2& b) { return words(Aabb3{lifted(b.min), lifted(b.max)}); }
inline std::string words(Sign s) { return std::to_string(static_cast<int>(s)); }
inline std::string words(const Rational& r) { return r.text(); }
inline std::string words(const GjkBounds& b) {
  const auto& [x, y, z] = b.direction;
  std::string text = std::to_string(b.steps);
  for (const double number : {b.lower, b.upper, x, y, z}) text += " " + hexadecimal(number);
  return text;
}
template <class T>
std::string words(const std::optional<T>& x) {
  return x ? words(*x) : "nothing";
}

template <class Call>
std::string outcome(Call call) {
  const auto said = [](const char* type, const Error& e) { return std::string(type) + ": " + e.what(); };
  try {
    return words(call());
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
