// Is this a figure at all?  What every function that is handed figures asks of their numbers, by what their bodies say.
//
// Laws: NonFinite for a number that is none, by the name of its part; InvalidShape for a negative length, a chain of
// fewer than three places, a surface without faces, the quaternion zero.
// Source: none.
// Cost: an addition a number, in a tree; lists are looked through.  Nothing is searched.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/body.hpp"

namespace plumb::figure {

/// What a quaternion has beside w.
constexpr double vector_part(const Rotation2& q) { return q.z; }
constexpr Vector3 vector_part(const Rotation& q) { return {q.x, q.y, q.z}; }

template <class Numbers>
constexpr double sum_of(const Numbers& x) {
  if constexpr (requires { x.w; }) {
    return x.w + sum_of(vector_part(x));
  } else if constexpr (requires { x.z; }) {
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
  template <part::Role R, class Member>
  constexpr double operator()(const part::Part<R, Member>& p) const {
    if constexpr (R == part::Role::figure) {
      return 0;
    } else if constexpr (R == part::Role::surface) {
      return sum_of(p.is.vertices);
    } else if constexpr (R == part::Role::slabs) {
      return sum_of(p.is.min) + sum_of(p.is.max);
    } else {
      return sum_of(p.is);
    }
  }
};
struct PartHolds {
  template <part::Role R, class Member>
  constexpr bool operator()(const part::Part<R, Member>& p) const {
    if constexpr (R == part::Role::length) {
      return p.is >= 0;
    } else if constexpr (R == part::Role::surface) {
      return !p.is.corners.empty();
    } else if constexpr (R == part::Role::turn) {
      return p.is != Member{0, 0};
    } else if constexpr (R == part::Role::slabs) {
      return p.is.min.size() == p.is.directions.size() && p.is.max.size() == p.is.directions.size();
    } else if constexpr (R == part::Role::figure && IsList<Member>::value) {
      for (const auto& item : p.is) {
        if (!is_sound(item)) return false;
      }
      return true;
    } else if constexpr (R == part::Role::figure) {
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

// What the slow look throws.
[[noreturn]] void refuse_chain(std::string_view function, const std::string& name, std::size_t size);
[[noreturn]] void refuse_ends(std::string_view function, const std::string& name, std::size_t directions,
                              std::size_t min, std::size_t max);
[[noreturn]] void refuse_length(std::string_view function, const std::string& name);
[[noreturn]] void refuse_surface(std::string_view function, const std::string& name);
[[noreturn]] void refuse_turn(std::string_view function, const std::string& name);
/// What names are made of: "whole.part", or "whole" for a part without a name, and "list[i]".
std::string name_of_part(const std::string& whole, std::string_view part);
std::string name_of_item(const std::string& list, std::size_t i);
/// For the first of some coordinates, each called by its letter, or of one number, that is none.
void refuse_number(std::string_view function, const std::string& name, std::span<const double> numbers,
                   std::string_view letters = "xyz");

template <class Numbers>
[[gnu::cold, gnu::noinline]] void refuse_numbers(std::string_view function, const std::string& name, const Numbers& x) {
  if constexpr (std::is_same_v<Numbers, Rotation>) {
    refuse_number(function, name, std::array{x.w, x.x, x.y, x.z}, "wxyz");
  } else if constexpr (std::is_same_v<Numbers, Rotation2>) {
    refuse_number(function, name, std::array{x.w, x.z}, "wz");
  } else if constexpr (requires { x.z; }) {
    refuse_number(function, name, std::array{x.x, x.y, x.z});
  } else if constexpr (requires { x.y; }) {
    refuse_number(function, name, std::array{x.x, x.y});
  } else if constexpr (requires { x.begin(); }) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!is_real(sum_of(x[i]))) refuse_numbers(function, name_of_item(name, i), x[i]);
    }
  } else {
    refuse_number(function, name, std::array{x});
  }
}

/// Which part is it?  Returns where there is none.
template <Described Shape>
[[gnu::cold, gnu::noinline]] void refuse(std::string_view function, const std::string& name, const Shape& s);

template <part::Role R, class Member>
[[gnu::cold]] void refuse_part(std::string_view function, const std::string& whole, const part::Part<R, Member>& p) {
  if constexpr (R == part::Role::figure && IsList<Member>::value) {
    for (std::size_t i = 0; i < p.is.size(); ++i) refuse(function, name_of_item(whole, i), p.is[i]);
  } else if constexpr (R == part::Role::figure) {
    refuse(function, whole, p.is);
  } else if constexpr (R == part::Role::surface) {
    refuse_numbers(function, name_of_part(whole, "vertices"), p.is.vertices);
  } else if constexpr (R == part::Role::slabs) {
    const std::size_t n = p.is.directions.size();
    if (p.is.min.size() != n || p.is.max.size() != n) refuse_ends(function, whole, n, p.is.min.size(), p.is.max.size());
    refuse_numbers(function, name_of_part(whole, "min"), p.is.min);
    refuse_numbers(function, name_of_part(whole, "max"), p.is.max);
  } else {
    if constexpr (IsList<Member>::value) {
      if (p.is.size() < 3) refuse_chain(function, whole, p.is.size());
    }
    refuse_numbers(function, whole, p.is);
  }
}

template <Described Shape>
void refuse(std::string_view function, const std::string& name, const Shape& s) {
  const auto whole = [&](const auto& p) { return name_of_part(name, p.name); };
  body(s, [&]<class... Parts>(std::string_view, const Parts&... parts) {
    (refuse_part(function, whole(parts), parts), ...);
    const auto refuse_what_is_none = [&]<class Part>(const Part& p) {
      if constexpr (Part::role == part::Role::length) {
        if (p.is < 0) refuse_length(function, whole(p));
      } else if constexpr (Part::role == part::Role::surface) {
        if (p.is.corners.empty()) refuse_surface(function, name);
      } else if constexpr (Part::role == part::Role::turn) {
        if (!PartHolds{}(p)) refuse_turn(function, whole(p));
      }
    };
    (refuse_what_is_none(parts), ...);
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
  (refuse_numbers(function, std::string(asked.name), asked.is), ...);
}

}  // namespace plumb::figure
