#include "plumb/figure/aabb/posed_aabb.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/query/convex/posed_support.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

Support3 support_in_space(const Support3& s) { return s; }
Support3 support_in_space(const Support2& s) { return {{s.point.x, s.point.y, 0}, s.feature, s.unique}; }
Aabb3 box_in_space(const Aabb3& box) { return box; }
Aabb3 box_in_space(const Aabb2& box) { return {{box.min.x, box.min.y, 0}, {box.max.x, box.max.y, 0}}; }

template <class Ask>
auto ask_along(std::string_view question, const AnyFigure& figure, const Vector3& direction, const Ask& ask) {
  using Answer = decltype(ask(Sphere3{}, direction));
  if (figure.dimension() == 2 && !(direction.z == 0)) refuse_figure(question, figure.figure());
  return visit(
      [&]<class Shape>(const Shape& s) -> Answer {
        if constexpr (figure_dimension<Shape> == 2) {
          const Vector2 in_plane{direction.x, direction.y};
          if constexpr (requires { ask(s, in_plane); }) return ask(s, in_plane);
        } else {
          if constexpr (requires { ask(s, direction); }) return ask(s, direction);
        }
        refuse_figure(question, figure.figure());
      },
      figure);
}

Support3 support_of(const AnyFigure& figure, const Vector3& direction) {
  if (figure.is_posed()) refuse_figure("support_point", figure.figure());
  return ask_along(
      "support_point", figure, direction, [](const auto& s, const auto& d) requires requires { support_point(s, d); } {
        return support_in_space(support_point(s, d));
      });
}

double support_value_of(const AnyFigure& figure, const Vector3& direction, Rounding rounding) {
  return ask_along(
      "support_value", figure,
      direction, [&](const auto& s, const auto& d) requires requires { support_value(s, d, rounding); } {
        return figure.is_posed() ? posed_support_value(figure.view(), direction, rounding)
                                 : support_value(s, d, rounding);
      });
}

Aabb3 box_of(const AnyFigure& figure) {
  return visit(
      [&figure](const auto& s) {
        return std::visit(
            [&]<class By>(const By& pose) -> Aabb3 {
              if constexpr (std::is_same_v<By, std::monostate>) {
                if constexpr (requires { fit_aabb(s); }) return box_in_space(fit_aabb(s));
              } else if constexpr (requires { figure::box::fitted_image(s, pose); }) {
                return box_in_space(figure::box::fitted_image(s, pose));
              } else if constexpr (requires { fit_aabb(Posed{s, pose}); }) {
                return posed_box(figure.view());
              }
              refuse_figure(figure.is_posed() ? "fit_aabb under a pose" : "fit_aabb", figure.figure());
            },
            figure.pose());
      },
      figure);
}

}  // namespace

Support3 any_support_point(const AnyFigure& figure, const Vector3& direction) {
  return recorded("support_point", {figure.view()}, {direction.x, direction.y, direction.z},
                  [&] { return support_of(figure, direction); });
}
double any_support_value(const AnyFigure& figure, const Vector3& direction, Rounding rounding) {
  return recorded("support_value", {figure.view()},
                  {direction.x, direction.y, direction.z, static_cast<double>(static_cast<int>(rounding))},
                  [&] { return support_value_of(figure, direction, rounding); });
}
Aabb3 any_fit_aabb(const AnyFigure& figure) {
  return recorded("fit_aabb", {figure.view()}, {}, [&] { return box_of(figure); });
}

}  // namespace plumb::query
