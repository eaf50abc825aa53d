// Which text is an answer?  Equal texts are equal answers, bit for bit.
//
// Laws: what lies in the plane lies in the plane z = 0; numbers are hexadecimal, exact ones fractions.
// Source: none.
// Cost: linear in the numbers.  Nothing is searched.
#pragma once

#include <optional>
#include <string>

#include "plumb/query/contact/contact.hpp"
#include "plumb/query/variant/questions.hpp"

namespace plumb::query {

std::string answer_text(Relation relation);
std::string answer_text(Location location);
std::string answer_text(bool is_so);
std::string answer_text(double number);
std::string answer_text(const ExactDistance& distance);
std::string answer_text(const Closest& closest);
std::string answer_text(const Hit& hit);
std::string answer_text(const RayParameter& t);
std::string answer_text(const Root& time);
std::string answer_text(const Contact& contact);
std::string answer_text(const Penetration& penetration);
std::string answer_text(const ContactManifold& manifold);
std::string answer_text(const Support3& support);
std::string answer_text(const Aabb3& box);
std::string answer_text(const AnyIntersection& common);

/// What refused the figures is an answer as well, of one line, in which nothing begins a remark.
std::string refusal_text(const Error& error);

template <class Answer>
std::string answer_text(const std::optional<Answer>& answer) {
  return answer ? answer_text(*answer) : "nothing";
}

}  // namespace plumb::query
