#include "plumb/query/certificate/certificate_text.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "certify/case_line.hpp"
#include "plumb/arith/error.hpp"
#include "query/body/figure_view.hpp"
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
  const auto vertices = [](const auto& list) { return Json{{"vertices", json_of(list)}}; };
  if constexpr (figure_dimension<Shape> != 3) {
    return {};
  } else if constexpr (kind == FigureKind::point) {
    return vertices(std::array{s});
  } else if constexpr (kind == FigureKind::segment) {
    return vertices(std::array{s.a, s.b});
  } else if constexpr (kind == FigureKind::triangle) {
    return vertices(std::array{s.a, s.b, s.c});
  } else if constexpr (kind == FigureKind::quadrilateral || kind == FigureKind::tetrahedron) {
    return vertices(std::array{s.a, s.b, s.c, s.d});
  } else if constexpr (kind == FigureKind::polygon) {
    return vertices(s.vertices);
  } else if constexpr (kind == FigureKind::convex_polyhedron) {
    return vertices(s.mesh.vertices);
  } else if constexpr (kind == FigureKind::ball) {
    return {{"vertices", json_of(std::array{s.center})}, {"radius", json_of(s.radius)}};
  } else if constexpr (kind == FigureKind::capsule) {
    return {{"vertices", json_of(std::array{s.a, s.b})}, {"radius", json_of(s.radius)}};
  } else if constexpr (kind == FigureKind::lozenge) {
    return {{"corner", json_of(s.corner)}, {"edges", json_of(s.edges)}, {"radius", json_of(s.radius)}};
  } else if constexpr (kind == FigureKind::aabb) {
    return {{"min", json_of(s.min)}, {"max", json_of(s.max)}};
  } else if constexpr (kind == FigureKind::obb || kind == FigureKind::rectangle) {
    return {{"center", json_of(s.center)}, {"axes", json_of(s.axes)}, {"half", json_of(s.half)}};
  } else {
    return {};
  }
}

Json json_of_body(const BodyView& body) {
  Json json = body.is_hull() ? Json{{"vertices", json_of(body.vertices)}}
                             : query::with_figure(body.figure, [](const auto& s) { return json_of_figure(s); });
  if (body.pose != nullptr) {
    json["pose"] = {{"columns", json_of(body.pose->columns)}, {"translation", json_of(body.pose->translation)}};
  }
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

/// A value, and where in the text it is.
class Place {
 public:
  Place(const Json& json, std::string name) : json_(&json), name_(std::move(name)) {}

  [[noreturn]] void refuse(const std::string& what) const { throw Error("read_certificate: " + name_ + what); }

  [[nodiscard]] bool has(const char* key) const { return json_->is_object() && json_->contains(key); }
  [[nodiscard]] Place operator[](const char* key) const {
    const std::string name = name_.empty() ? key : name_ + "." + key;
    if (!has(key)) throw Error("read_certificate: " + name + " is missing");
    return {(*json_)[key], name};
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
    const std::string word = text();
    if (!is_hexadecimal(word)) refuse(" is \"" + word + "\"; give a hexadecimal double, such as 0x1.8p-3");
    return parsed(word);
  }
  [[nodiscard]] Rational exact() const {
    const std::string word = text();
    if (is_hexadecimal(word)) return parsed(word);
    if (!is_fraction(word)) refuse(" is \"" + word + "\"; give a fraction such as -3/8, or a hexadecimal double");
    try {
      return Rational::from_text(word);
    } catch (const Error& e) {
      refuse(std::string(": ").append(e.what()));
    }
  }

 private:
  static bool is_hexadecimal(std::string_view word) { return word.starts_with("0x") || word.starts_with("-0x"); }
  static bool is_fraction(std::string_view word) {
    constexpr const char* digits = "0123456789";
    if (word.starts_with('-')) word.remove_prefix(1);
    const std::size_t bar = std::min(word.find_first_not_of(digits), word.size());
    const std::string_view over = word.substr(std::min(bar + 1, word.size()));
    if (bar == word.size()) return bar > 0;
    return bar > 0 && word[bar] == '/' && !over.empty() && over.find_first_not_of(digits) == over.npos;
  }
  [[nodiscard]] double parsed(const std::string& word) const {
    try {
      return parse_double(word);
    } catch (const Error& e) {
      refuse(std::string(": ").append(e.what()));
    }
  }

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

RecordedBody body_at(const Place& at) {
  RecordedBody body;
  if (at.has("vertices")) {
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
    body.shape = Aabb3{triplet<Point3>(at["min"]), triplet<Point3>(at["max"])};
  } else if (at.has("corner")) {
    body.shape = Lozenge3{triplet<Point3>(at["corner"]), vectors<2>(at["edges"]), at["radius"].real()};
  } else if (at["axes"].size() == 3) {
    body.shape = Obb3{triplet<Point3>(at["center"]), vectors<3>(at["axes"]), triplet<Vector3>(at["half"])};
  } else {
    at["half"].require_size(2);
    body.shape = Rectangle3{
        triplet<Point3>(at["center"]), vectors<2>(at["axes"]), {at["half"].item(0).real(), at["half"].item(1).real()}};
  }
  if (at.has("pose")) body.pose = Pose{vectors<3>(at["pose"]["columns"]), triplet<Vector3>(at["pose"]["translation"])};
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
  for (std::size_t i = 0; i < pairs.size(); ++i)
    proof.pairs.push_back({pairs.item(i)["a"].index(), pairs.item(i)["b"].index(), pairs.item(i)["weight"].exact()});
  return proof;
}

std::variant<Certificate, DistanceCertificate> proof_at(const Place& at) {
  const std::string claim = at["claim"].text();
  if (claim == "distance") {
    const double distance = at["distance"].text() == "infinity" ? HUGE_VAL : at["distance"].real();
    return evidence_at(at, DistanceCertificate{distance, {at["square"].exact(), at["inset"].exact()}, {}, {}});
  }
  for (const Claim c : {Claim::disjoint, Claim::touching, Claim::overlapping, Claim::intersecting}) {
    if (claim == name_of(c)) return evidence_at(at, Certificate{c, {}, {}});
  }
  at["claim"].refuse(" is \"" + claim + "\"; it is disjoint, touching, overlapping, intersecting or distance");
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
  view.pose = body.pose ? &*body.pose : nullptr;
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
  Json json;
  try {
    json = Json::parse(text);
  } catch (const nlohmann::json::exception& e) {
    throw Error(std::string("read_certificate: not JSON: ").append(e.what()));
  }
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
