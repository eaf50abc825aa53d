// Is this a figure at all?  What every function that is handed figures asks of their numbers, by what their bodies say.
//
// Laws: NonFinite for a number that is none, by the name of its part; InvalidShape for a negative length, a chain of
// fewer than three places, a surface without faces.
// Cost: an addition a number, in a tree; lists are looked through.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "figure/basic/chain_input.hpp"
#include "plumb/figure/basic/body.hpp"

namespace plumb::figure {

template <class Numbers>
constexpr double sum_of(const Numbers& x) {
  if constexpr (requires { x.z; }) {
    return x.x + (x.y + x.z);
  } else if constexpr (requires { x.y; }) {
    return x.x + x.y;
  } else if constexpr (requires { x.begin(); }) {
    double sum = 0;
    for (const auto& item : x) sum += sum_of(item);
    return sum;
  } else {
    return x;
  }
}
constexpr bool is_real(double sum) { return sum - sum == 0; }

template <class Member>
struct IsList : std::false_type {};
template <class Item>
struct IsList<std::vector<Item>> : std::true_type {};

/// May the figure go to the quick tests?  Not where a sum of real numbers is beyond all doubles.
template <Described Shape>
constexpr bool is_sound(const Shape& s);

struct SumOfPart {
  template <Role R, class Member>
  constexpr double operator()(const part::Part<R, Member>& p) const {
    if constexpr (R == Role::figure) {
      return 0;
    } else if constexpr (R == Role::surface) {
      return sum_of(p.is.vertices);
    } else if constexpr (R == Role::slabs) {
      return sum_of(p.is.min) + sum_of(p.is.max);
    } else {
      return sum_of(p.is);
    }
  }
};
struct PartHolds {
  template <Role R, class Member>
  constexpr bool operator()(const part::Part<R, Member>& p) const {
    if constexpr (R == Role::length) {
      return p.is >= 0;
    } else if constexpr (R == Role::surface) {
      return !p.is.corners.empty();
    } else if constexpr (R == Role::slabs) {
      return p.is.min.size() == p.is.directions.size() && p.is.max.size() == p.is.directions.size();
    } else if constexpr (R == Role::figure && IsList<Member>::value) {
      for (const auto& item : p.is) {
        if (!is_sound(item)) return false;
      }
      return true;
    } else if constexpr (R == Role::figure) {
      return is_sound(p.is);
    } else if constexpr (IsList<Member>::value) {
      return p.is.size() >= 3;
    } else {
      return true;
    }
  }
};
struct AllSound {
  template <class... Parts>
  constexpr bool operator()(std::string_view, const Parts&... parts) const {
    return is_real((SumOfPart{}(parts) + ...)) && (PartHolds{}(parts) && ...);
  }
};

template <Described Shape>
constexpr bool is_sound(const Shape& s) {
  return body(s, AllSound{});
}

/// The slow look: which part is it?  Returns where there is none.
template <Described Shape>
[[gnu::noinline]] void refuse(std::string_view function, const std::string& name, const Shape& s);

inline void require_ends(std::string_view function, const std::string& name, std::size_t directions, std::size_t min,
                         std::size_t max) {
  if (min == directions && max == directions) return;
  throw InvalidShape(std::string(function)
                         .append(": ")
                         .append(name)
                         .append(" has ")
                         .append(std::to_string(min))
                         .append(" entries in min and ")
                         .append(std::to_string(max))
                         .append(" in max for ")
                         .append(std::to_string(directions))
                         .append(" directions; give one for each"));
}

template <Role R, class Member>
void refuse_part(std::string_view function, const std::string& whole, const part::Part<R, Member>& p) {
  const auto item = [&](std::size_t i) { return std::string(whole).append("[").append(std::to_string(i)).append("]"); };
  const auto look = [&](const std::string& name, const auto& numbers) {
    require_finite_parts(function, std::array<std::string_view, 1>{name}, numbers);
  };
  if constexpr (R == Role::figure && IsList<Member>::value) {
    for (std::size_t i = 0; i < p.is.size(); ++i) refuse(function, item(i), p.is[i]);
  } else if constexpr (R == Role::figure) {
    refuse(function, whole, p.is);
  } else if constexpr (R == Role::surface) {
    require_finite_points(function, std::string(whole).append(".vertices"), std::span(p.is.vertices));
  } else if constexpr (R == Role::slabs) {
    require_ends(function, whole, p.is.directions.size(), p.is.min.size(), p.is.max.size());
    for (std::size_t i = 0; i < p.is.min.size(); ++i) {
      const std::string at = std::string("[").append(std::to_string(i)).append("]");
      look(std::string(whole).append(".min").append(at), p.is.min[i]);
      look(std::string(whole).append(".max").append(at), p.is.max[i]);
    }
  } else if constexpr (IsList<Member>::value) {
    require_chain(function, whole, std::span(p.is));
  } else if constexpr (requires { p.is.size(); }) {
    for (std::size_t i = 0; i < p.is.size(); ++i) look(item(i), p.is[i]);
  } else {
    look(whole, p.is);
  }
}

template <Role R, class Member>
void refuse_what_is_none(std::string_view function, const std::string& name, const std::string& whole,
                         const part::Part<R, Member>& p) {
  if constexpr (R == Role::length) {
    if (p.is < 0)
      throw InvalidShape(std::string(function).append(": ").append(whole).append(" is negative; give zero or more"));
  } else if constexpr (R == Role::surface) {
    if (p.is.corners.empty())
      throw InvalidShape(
          std::string(function).append(": ").append(name).append(" has no faces; make it by convex_polyhedron"));
  }
}

template <Described Shape>
void refuse(std::string_view function, const std::string& name, const Shape& s) {
  const auto whole = [&](const auto& p) {
    return p.name.empty() ? name : std::string(name).append(".").append(p.name);
  };
  body(s, [&](std::string_view, const auto&... parts) {
    (refuse_part(function, whole(parts), parts), ...);
    (refuse_what_is_none(function, name, whole(parts), parts), ...);
  });
}

/// By another name than that of its kind.
template <Described Shape>
void require_sound(std::string_view function, std::string_view name, const Shape& s) {
  if (!is_sound(s)) [[unlikely]]
    refuse(function, std::string(name), s);
}

/// And what else is asked about, by name: part::place("p", p).
template <Described Shape, class... Asked>
void require_sound(std::string_view function, const Shape& s, const Asked&... asked) {
  if (is_sound(s) && (is_real(sum_of(asked.is)) && ...)) [[likely]]
    return;
  refuse(function, std::string(name_of_figure(s)), s);
  (require_finite_parts(function, std::array<std::string_view, 1>{asked.name}, asked.is), ...);
}

}  // namespace plumb::figure
