// Which text is an answer?  Equal texts are equal answers, bit for bit.
//
// The parts begin with a blank, the text does not.
// Laws: what lies in the plane lies in the plane z = 0; numbers are hexadecimal, exact ones fractions.
// Source: none.
// Cost: linear in the numbers.  Nothing is searched.
#pragma once

#include <optional>
#include <string>

#include "plumb/query/contact/contact.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/body/line_parts.hpp"

namespace plumb::query {

LineParts answer_parts(Relation relation);
LineParts answer_parts(Location location);
LineParts answer_parts(bool is_so);
LineParts answer_parts(double number);
LineParts answer_parts(const ExactDistance& distance);
LineParts answer_parts(const Closest& closest);
LineParts answer_parts(const Hit& hit);
LineParts answer_parts(const RayParameter& t);
LineParts answer_parts(const Root& time);
LineParts answer_parts(const Contact& contact);
LineParts answer_parts(const Penetration& penetration);
LineParts answer_parts(const ContactManifold& manifold);
LineParts answer_parts(const Support3& support);
LineParts answer_parts(const Aabb3& box);
LineParts answer_parts(const AnyIntersection& common);

/// What refused the figures is an answer as well, of one line, in which nothing begins a remark.
std::string refusal_text(const Error& error);

template <class Answer>
LineParts answer_parts(const std::optional<Answer>& answer) {
  if (answer) return answer_parts(*answer);
  LineParts nothing;
  nothing.word("nothing");
  return nothing;
}
/// Written out.
template <class Answer>
std::string answer_text(const Answer& answer) {
  return LineParts::written(answer_parts(answer).kept()).substr(1);
}

}  // namespace plumb::query
