#include "plumb/degenerate/convention.hpp"

#include "plumb/arith/error.hpp"

namespace plumb::degenerate {

namespace {

void require(bool difference, const Kind& kind, std::string_view what) {
  if (difference) return;
  throw Error(std::string("convention: ")
                  .append(what)
                  .append(" make no difference to ")
                  .append(kind.name)
                  .append("; leave them as they are"));
}

std::string in_words(const Kind& kind, const Convention& c) {
  std::string text = kind.convention;
  if (c.boundary == Boundary::out) text.append("; without the boundary");
  if (c.boundary == Boundary::any) text.append("; with the boundary or without it");
  const std::string ends = kind.form == AnswerForm::hit ? "the ray's origin" : "the ends";
  if (c.ends == Ends::open) text.append("; without ").append(ends);
  if (c.ends == Ends::any) text.append("; with ").append(ends).append(" or without");
  return text;
}

}  // namespace

Kind under(const Kind& kind, const Convention& convention) {
  if (convention.boundary != Boundary::in) require(kind.has_boundary, kind, "boundaries");
  if (convention.ends != Ends::closed) require(kind.has_ends, kind, "ends");
  if (!kind.exact_under) return kind;
  Kind made = kind;
  made.declared = convention;
  made.convention = in_words(kind, convention);
  using Boundaries = std::vector<Boundary>;
  using AllEnds = std::vector<Ends>;
  const bool any_boundary = convention.boundary == Boundary::any, any_ends = convention.ends == Ends::any;
  std::vector<Exact> right;
  for (const Boundary b : any_boundary ? Boundaries{Boundary::in, Boundary::out} : Boundaries{convention.boundary}) {
    for (const Ends e : any_ends ? AllEnds{Ends::closed, Ends::open} : AllEnds{convention.ends}) {
      right.emplace_back([ask = kind.exact_under, b, e](std::span<const double> numbers) {
        return ask(numbers, {b, e});
      });
    }
  }
  made.exact = right[0];
  made.also_right.assign(right.begin() + 1, right.end());
  return made;
}

}  // namespace plumb::degenerate
