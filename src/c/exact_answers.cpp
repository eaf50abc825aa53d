// Answers about figures before they are rounded, as text, and certificates of answers.
#include "c/figures.hpp"
#include "c/handles.hpp"
#include "c/texts.hpp"
#include "plumb/query/certificate/certificate_text.hpp"
#include "plumb/query/penetration/along.hpp"
#include "plumb/query/variant/questions.hpp"

using namespace plumb;
using c::figure_of, c::guarded, c::need, c::need_text, c::write_text;

namespace {

std::string text_of_root(const Root& t) {
  if (const std::optional<Rational> rational = t.rational()) return rational->text();
  const auto [low, high] = t.interval();
  std::string text = low.text() + " " + high.text();
  for (const Rational& c : t.polynomial()) text.append(" ").append(c.text());
  return text;
}

std::string text_of_vector(const ExactVector3& v) { return v.x.text() + " " + v.y.text() + " " + v.z.text(); }

}  // namespace

extern "C" {

plumb_status plumb_compare_distance(const plumb_figure* a, const plumb_figure* b, const plumb_figure* c,
                                    const plumb_figure* d, int* sign) {
  return guarded("plumb_compare_distance", [&] {
    need(sign, "sign");
    *sign =
        static_cast<int>(compare_distance(figure_of(a, "a"), figure_of(b, "b"), figure_of(c, "c"), figure_of(d, "d")));
  });
}

plumb_status plumb_squared_distance(const plumb_figure* a, const plumb_figure* b, char* text, std::size_t capacity,
                                    std::size_t* length) {
  return guarded("plumb_squared_distance", [&] {
    need_text(text, capacity, length);
    write_text(squared_distance_exact(figure_of(a, "a"), figure_of(b, "b")).text(), text, capacity, length);
  });
}

plumb_status plumb_exact_distance(const plumb_figure* a, const plumb_figure* b, char* text, std::size_t capacity,
                                  std::size_t* length) {
  return guarded("plumb_exact_distance", [&] {
    need_text(text, capacity, length);
    const ExactDistance d = exact_distance(figure_of(a, "a"), figure_of(b, "b"));
    write_text(d.square.text() + " " + d.inset.text(), text, capacity, length);
  });
}

plumb_status plumb_first_hit_parameter(const plumb_figure* ray, const plumb_figure* figure, int* found, char* text,
                                       std::size_t capacity, std::size_t* length) {
  return guarded("plumb_first_hit_parameter", [&] {
    need(found, "found");
    need_text(text, capacity, length);
    const std::optional<RayParameter> t = first_hit_parameter(figure_of(ray, "ray"), figure_of(figure, "figure"));
    const std::string told = !t ? "" : t->base.text() + " " + t->square.text() + (t->greater ? " 1" : " -1");
    *found = t.has_value();
    if (t) write_text(told, text, capacity, length);
  });
}

plumb_status plumb_first_contact_time(const plumb_figure* a, const double* by_a, const plumb_figure* b,
                                      const double* by_b, int* found, char* text, std::size_t capacity,
                                      std::size_t* length) {
  return guarded("plumb_first_contact_time", [&] {
    need(found, "found");
    need_text(text, capacity, length);
    const std::optional<Root> time = first_contact_time(c::moved(a, by_a, "a"), c::moved(b, by_b, "b"));
    const std::string told = time ? text_of_root(*time) : "";
    *found = time.has_value();
    if (time) write_text(told, text, capacity, length);
  });
}

plumb_status plumb_exact_penetration(const plumb_figure* a, const plumb_figure* b, int* found, int* apart, char* text,
                                     std::size_t capacity, std::size_t* length) {
  return guarded("plumb_exact_penetration", [&] {
    need(found, "found");
    need(apart, "apart");
    need_text(text, capacity, length);
    const AnyFigure first = figure_of(a, "a"), second = figure_of(b, "b");
    const std::optional<ExactPenetration> deep = exact_penetration(first, second);
    const std::string told = !deep ? ""
                                   : text_of_vector(deep->direction) + " " + text_of_vector(deep->core_translation) +
                                         " " + deep->core_square.text() + " " + deep->radii.text();
    *found = deep.has_value();
    if (!deep) return;
    *apart = deep->cores_are_apart;
    write_text(told, text, capacity, length);
  });
}

plumb_status plumb_penetration_along(const plumb_figure* a, const plumb_figure* b, const double* directions,
                                     std::size_t count, int* found, std::size_t* which, double* depth,
                                     double* translation, char* text, std::size_t capacity, std::size_t* length) {
  return guarded("plumb_penetration_along", [&] {
    need(found, "found");
    need(which, "which");
    need(depth, "depth");
    need_text(text, capacity, length);
    const AnyFigure first = figure_of(a, "a"), second = figure_of(b, "b");
    const auto deep = penetration_along(first, second, c::items<Vector3>(directions, count, "directions"));
    const std::string told = deep ? text_of_root(deep->multiple) : "";
    *found = deep.has_value();
    if (!deep) return;
    *which = deep->index;
    *depth = deep->depth;
    if (translation != nullptr) std::memcpy(translation, &deep->translation, sizeof deep->translation);
    write_text(told, text, capacity, length);
  });
}

plumb_status plumb_support_value(const plumb_figure* figure, const double* direction, double* value) {
  return guarded("plumb_support_value", [&] {
    need(direction, "direction");
    need(value, "value");
    const AnyFigure any = figure_of(figure, "figure");
    *value = support_value(any, Vector3{direction[0], direction[1], any.dimension() == 3 ? direction[2] : 0});
  });
}

plumb_status plumb_prove(int claim, const plumb_figure* a, const plumb_figure* b, char* text, std::size_t capacity,
                         std::size_t* length) {
  return guarded("plumb_prove", [&] {
    c::need_choice(claim, PLUMB_CLAIM_DISTANCE, "claim");
    need_text(text, capacity, length);
    const AnyFigure first = figure_of(a, "a"), second = figure_of(b, "b");
    const auto told = [&](const auto& proof) { return certificate_text(proof, first, second); };
    write_text(claim == PLUMB_CLAIM_RELATION       ? told(relate_with_proof(first, second))
               : claim == PLUMB_CLAIM_INTERSECTION ? told(intersects_with_proof(first, second))
                                                   : told(distance_with_proof(first, second)),
               text, capacity, length);
  });
}

plumb_status plumb_verify(const char* certificate, int* proven, char* flaw, std::size_t capacity, std::size_t* length) {
  return guarded("plumb_verify", [&] {
    need(certificate, "certificate");
    need(proven, "proven");
    need(flaw, capacity, "flaw");
    need(length, "length");
    const ProofVerdict verdict = verify(read_certificate(certificate));
    *proven = static_cast<bool>(verdict);
    write_text(verdict.flaw, flaw, capacity, length);
  });
}

}  // extern "C"
