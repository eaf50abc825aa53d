#include "plumb/query/certificate/certificate_text.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "certify/case_line.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/boundary.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using query::BodyView;

std::string text_of(const Rational& x) {
  constexpr std::size_t readable = 20;
  std::string text = x.text();
  if (text.size() <= readable) return text;
  const double nearest = x.rounded();
  return std::isfinite(nearest) && Rational(nearest) == x ? hexadecimal(nearest) : text;
}

Json json_of(double x) { return hexadecimal(x); }
template <class Triplet>
requires requires(const Triplet& p) { p.x, p.y, p.z; }
Json json_of(const Triplet& p) { return Json::array({json_of(p.x), json_of(p.y), json_of(p.z)}); }
Json json_of(const Vector2& v) { return Json::array({json_of(v.x), json_of(v.y)}); }
template <class List>
requires requires(const List& list) { list.begin(); }
Json json_of(const List& list) {
  Json all = Json::array();
  for (const auto& item : list) all.push_back(json_of(item));
  return all;
}

template <class Shape>
Json json_of_figure(const Shape& s) {
  constexpr FigureKind kind = figure_kind<Shape>;
  if constexpr (figure_dimension<Shape> != 3 || !query::has_boundary<Shape> || kind == FigureKind::holed_polygon) {
    return {};
  } else if constexpr (kind == FigureKind::lozenge) {
    return {{"corner", json_of(s.corner)}, {"edges", json_of(s.edges)}, {"radius", json_of(s.radius)}};
  } else if constexpr (kind == FigureKind::aabb) {
    return {{"min", json_of(s.min)}, {"max", json_of(s.max)}};
  } else if constexpr (kind == FigureKind::obb || kind == FigureKind::rectangle) {
    return {{"center", json_of(s.center)}, {"axes", json_of(s.axes)}, {"half", json_of(s.half)}};
  } else {
    Json json{{"vertices", Json::array()}};
    query::for_each_corner<double>(s, [&json](const auto& p) { json["vertices"].push_back(json_of(p)); });
    if constexpr (requires { s.radius; }) json["radius"] = json_of(s.radius);
    return json;
  }
}

Json json_of_pose(const Pose& pose) {
  return {{"columns", json_of(pose.columns)}, {"translation", json_of(pose.translation)}};
}
Json json_of_pose(const RigidPose& pose) {
  const auto& [w, x, y, z] = pose.turn;
  return {{"turn", {json_of(w), json_of(x), json_of(y), json_of(z)}}, {"translation", json_of(pose.translation)}};
}
Json json_of_pose(const RigidChain& pose) {
  Json links = Json::array();
  for (const RigidPose& link : pose.links) links.push_back(json_of_pose(link));
  Json json;
  json["links"] = std::move(links);
  return json;
}

Json json_of_body(const BodyView& body) {
  Json json = body.is_hull() ? Json{{"vertices", json_of(body.vertices)}}
                             : query::with_figure(body.figure, [](const auto& s) { return json_of_figure(s); });
  if (body.radius != 0) json["radius"] = json_of(body.radius);  // of a hull
  std::visit(
      [&]<class By>(const By& by) {
        if constexpr (requires { json_of_pose(*by); }) json["pose"] = json_of_pose(*by);
      },
      body.pose.by);
  return json;
}

/// What both certificates have, and the bodies.
template <class Proof>
std::string finished(Json json, const Proof& proof, const BodyView& a, const BodyView& b) {
  static_cast<void>(query::bodies_of("certificate_text", a, b));
  if (proof.direction) {
    const auto& [x, y, z] = *proof.direction;
    json["direction"] = {text_of(x), text_of(y), text_of(z)};
  }
  json["pairs"] = Json::array();
  for (const WeightedPair& p : proof.pairs)
    json["pairs"].push_back({{"a", p.of_a}, {"b", p.of_b}, {"weight", text_of(p.weight)}});
  json["a"] = json_of_body(a);
  json["b"] = json_of_body(b);
  return json.dump();
}

constexpr std::string_view digits = "0123456789";

/// A text in JSON's own spelling, which no control character gets out of.
std::string quoted(const std::string& text) { return Json(text).dump(-1, ' ', true); }

/// "0", "-12", "3/8": one spelling of an integer.
bool is_fraction(std::string_view word) {
  if (word == "0") return true;
  if (word.starts_with('-')) word.remove_prefix(1);
  const auto is_natural = [](std::string_view n) {
    return !n.empty() && !n.starts_with('0') && n.find_first_not_of(digits) == n.npos;
  };
  const std::size_t bar = word.find('/');
  return is_natural(word.substr(0, bar)) && (bar == word.npos || is_natural(word.substr(bar + 1)));
}

/// The double that "-0x1.8p-3" is: a digit 0 or 1, up to 13 more, and a power of up to four.  Nothing where that is
/// another spelling, or lies between two doubles or beyond them all.
std::optional<double> hexadecimal_double(std::string_view word) {
  const bool minus = word.starts_with('-');
  if (minus) word.remove_prefix(1);
  if (!word.starts_with("0x0") && !word.starts_with("0x1")) return {};
  const std::size_t p = word.find('p');
  if (p == word.npos) return {};
  std::string_view part = word.substr(3, p - 3), power = word.substr(p + 1);
  const bool has_point = part.starts_with('.'), is_small = power.starts_with('-');
  if (has_point) part.remove_prefix(1);
  if (has_point == part.empty() || part.size() > 13) return {};
  if (!is_small && !power.starts_with('+')) return {};
  power.remove_prefix(1);
  if (power.empty() || power.size() > 4 || (power.size() > 1 && power.starts_with('0'))) return {};
  std::int64_t whole = word[2] - '0';
  for (const char c : part) {
    const std::size_t digit = std::string_view("0123456789abcdef").find(c);
    if (digit == std::string_view::npos) return {};
    whole = 16 * whole + static_cast<std::int64_t>(digit);
  }
  int exponent = 0;
  for (const char c : power) {
    if (digits.find(c) == digits.npos) return {};
    exponent = 10 * exponent + (c - '0');
  }
  exponent = (is_small ? -exponent : exponent) - 4 * static_cast<int>(part.size());
  const auto mantissa = static_cast<double>(whole);  // of 53 bits
  const double x = std::ldexp(mantissa, exponent);
  if (std::ldexp(x, -exponent) != mantissa) return {};
  return minus ? -x : x;
}

/// A value, and where in the text it is.
class Place {
 public:
  Place(const Json& json, std::string name) : json_(&json), name_(std::move(name)) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error("read_certificate: " + (name_.empty() ? "the certificate" : name_) + what);
  }

  [[nodiscard]] bool has(const char* key) const { return json_->is_object() && json_->contains(key); }
  [[nodiscard]] Place operator[](const char* key) const {
    std::string name = name_.empty() ? key : name_ + "." + key;
    if (!has(key)) throw Error("read_certificate: " + name + " is missing");
    return {(*json_)[key], std::move(name)};
  }
  /// Throws where it has a member that is none of these.
  void require_known(std::initializer_list<std::string_view> known) const {
    if (!json_->is_object()) refuse(" is no object");
    for (const auto& [key, value] : json_->items()) {
      if (std::ranges::find(known, key) != known.end()) continue;
      std::string names;
      for (const std::string_view name : known) names.append(names.empty() ? "" : ", ").append(name);
      refuse(" has a member " + quoted(key) + " that is not known; there are " + names);
    }
  }
  [[nodiscard]] std::size_t size() const {
    if (!json_->is_array()) refuse(" is no list");
    return json_->size();
  }
  [[nodiscard]] Place item(std::size_t i) const { return {(*json_)[i], name_ + "[" + std::to_string(i) + "]"}; }
  void require_size(std::size_t wanted) const {
    if (size() != wanted) refuse(" has " + std::to_string(size()) + " items, not " + std::to_string(wanted));
  }

  [[nodiscard]] std::string text() const {
    if (!json_->is_string()) refuse(" is no text");
    return json_->get<std::string>();
  }
  [[nodiscard]] std::uint32_t index() const {
    constexpr std::uint64_t most = 0xffffffff;
    if (!json_->is_number_unsigned() || json_->get<std::uint64_t>() > most) refuse(" is not the number of a vertex");
    return json_->get<std::uint32_t>();
  }
  [[nodiscard]] double real() const {
    if (const auto x = hexadecimal_double(text())) return *x;
    refuse(" is " + quoted(text()) + "; give a hexadecimal double as it is written here, such as 0x1.8p-3");
  }
  [[nodiscard]] Rational exact() const {
    const std::string word = text();
    if (is_fraction(word)) return Rational::from_text(word);
    if (word.find('x') != word.npos) return Rational(real());
    refuse(" is " + quoted(word) + "; give a fraction such as -3/8, or a hexadecimal double");
  }

 private:
  const Json* json_;
  std::string name_;
};

template <class Triplet>
Triplet triplet(const Place& at) {
  at.require_size(3);
  return {at.item(0).real(), at.item(1).real(), at.item(2).real()};
}
template <std::size_t N>
std::array<Vector3, N> vectors(const Place& at) {
  at.require_size(N);
  std::array<Vector3, N> all;
  for (std::size_t i = 0; i < N; ++i) all[i] = triplet<Vector3>(at.item(i));
  return all;
}

RigidPose rigid_pose_at(const Place& at) {
  at.require_known({"turn", "translation"});
  const Place turn = at["turn"];
  turn.require_size(4);
  return {{turn.item(0).real(), turn.item(1).real(), turn.item(2).real(), turn.item(3).real()},
          triplet<Vector3>(at["translation"])};
}
AnyPose pose_at(const Place& at) {
  if (at.has("turn")) return rigid_pose_at(at);
  if (at.has("links")) {
    at.require_known({"links"});
    const Place links = at["links"];
    RigidChain chain;
    for (std::size_t i = 0; i < links.size(); ++i) chain.links.push_back(rigid_pose_at(links.item(i)));
    return chain;
  }
  at.require_known({"columns", "translation"});
  return Pose{vectors<3>(at["columns"]), triplet<Vector3>(at["translation"])};
}

RecordedBody body_at(const Place& at) {
  RecordedBody body;
  if (at.has("vertices")) {
    at.require_known({"vertices", "radius", "pose"});
    std::vector<Point3> points;
    const Place list = at["vertices"];
    for (std::size_t i = 0; i < list.size(); ++i) points.push_back(triplet<Point3>(list.item(i)));
    if (!at.has("radius")) {
      body.shape = std::move(points);
    } else if (points.size() == 1) {
      body.shape = Sphere3{points[0], at["radius"].real()};
    } else if (points.size() == 2) {
      body.shape = Capsule3{points[0], points[1], at["radius"].real()};
    } else {
      at["radius"].refuse(" is of one vertex, or of two");
    }
  } else if (at.has("min")) {
    at.require_known({"min", "max", "pose"});
    body.shape = Aabb3{triplet<Point3>(at["min"]), triplet<Point3>(at["max"])};
  } else if (at.has("corner")) {
    at.require_known({"corner", "edges", "radius", "pose"});
    body.shape = Lozenge3{triplet<Point3>(at["corner"]), vectors<2>(at["edges"]), at["radius"].real()};
  } else if (at.has("center")) {
    at.require_known({"center", "axes", "half", "pose"});
    const Point3 center = triplet<Point3>(at["center"]);
    const Place half = at["half"];
    if (at["axes"].size() == 3) {
      body.shape = Obb3{center, vectors<3>(at["axes"]), triplet<Vector3>(half)};
    } else {
      half.require_size(2);
      body.shape = Rectangle3{center, vectors<2>(at["axes"]), {half.item(0).real(), half.item(1).real()}};
    }
  } else {
    at.refuse(" has none of vertices, min, corner and center, one of which says what it is");
  }
  if (at.has("pose")) {
    body.pose = pose_at(at["pose"]);
  }
  return body;
}

template <class Proof>
Proof evidence_at(const Place& at, Proof proof) {
  if (at.has("direction")) {
    const Place n = at["direction"];
    n.require_size(3);
    proof.direction = ExactVector3{n.item(0).exact(), n.item(1).exact(), n.item(2).exact()};
  }
  const Place pairs = at["pairs"];
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Place pair = pairs.item(i);
    pair.require_known({"a", "b", "weight"});
    proof.pairs.push_back({pair["a"].index(), pair["b"].index(), pair["weight"].exact()});
  }
  return proof;
}

std::variant<Certificate, DistanceCertificate> proof_at(const Place& at) {
  const std::string claim = at["claim"].text();
  if (claim == "distance") {
    at.require_known({"claim", "distance", "square", "inset", "direction", "pairs", "a", "b"});
    const double distance = at["distance"].text() == "infinity" ? HUGE_VAL : at["distance"].real();
    return evidence_at(at, DistanceCertificate{distance, {at["square"].exact(), at["inset"].exact()}, {}, {}});
  }
  for (const Claim c : {Claim::disjoint, Claim::touching, Claim::overlapping, Claim::intersecting}) {
    if (claim != name_of(c)) continue;
    at.require_known({"claim", "direction", "pairs", "a", "b"});
    return evidence_at(at, Certificate{c, {}, {}});
  }
  at["claim"].refuse(" is " + quoted(claim) + "; it is disjoint, touching, overlapping, intersecting or distance");
}

/// JSON of one line.  Its library passes over a byte-order mark, what follows a NUL and members that are given twice, and
/// copies values by recursion, which lists within lists without end exhaust: those are refused here.
Json read_line(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.find('\n') != line.npos) throw Error("read_certificate: a certificate is one line, and this is several");
  if (line.starts_with("\xef\xbb\xbf") || line.find('\0') != line.npos)
    throw Error("read_certificate: not JSON: it holds a byte-order mark or a NUL");
  constexpr int deepest = 6;  // the certificate, a body, its pose, its links, a link, its turn
  std::vector<std::set<std::string>> open;
  const auto once = [&](int depth, Json::parse_event_t event, const Json& value) {
    const bool starts = event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    if (starts && depth >= deepest) throw Error("read_certificate: lists and objects within one another are too many");
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(value.get<std::string>()).second)
      throw Error("read_certificate: " + quoted(value.get<std::string>()) + " is given twice");
    return true;
  };
  try {
    return Json::parse(line, once);
  } catch (const nlohmann::json::exception& e) {
    throw Error(std::string("read_certificate: not JSON: ").append(e.what()));
  }
}

BodyView view_of_recorded(const RecordedBody& body) {
  BodyView view = std::visit(
      []<class Shape>(const Shape& s) -> BodyView {
        if constexpr (std::is_same_v<Shape, std::vector<Point3>>) {
          return {.vertices = s};
        } else {
          return {.figure = query::view_of(s)};
        }
      },
      body.shape);
  view.pose = body.pose;
  return view;
}

}  // namespace

namespace query {

std::string text_of_proof(const Certificate& c, const BodyView& a, const BodyView& b) {
  return finished({{"claim", name_of(c.claim)}}, c, a, b);
}

std::string text_of_proof(const DistanceCertificate& c, const BodyView& a, const BodyView& b) {
  Json json{{"claim", "distance"}};
  json["distance"] = std::isinf(c.distance) ? "infinity" : hexadecimal(c.distance);
  json["square"] = text_of(c.exact.square);
  json["inset"] = text_of(c.exact.inset);
  return finished(std::move(json), c, a, b);
}

}  // namespace query

RecordedProof read_certificate(std::string_view text) {
  const Json json = read_line(text);
  const Place all(json, "");
  return {proof_at(all), body_at(all["a"]), body_at(all["b"])};
}

ProofVerdict verify(const RecordedProof& recorded) {
  return std::visit(
      [&](const auto& proof) {
        return query::verdict_on(proof, view_of_recorded(recorded.a), view_of_recorded(recorded.b));
      },
      recorded.proof);
}

}  // namespace plumb
