#include "plumb/query/variant/questions.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <vector>

#include "c/figures.hpp"
#include "certify/batch/all_threads.hpp"
#include "plumb/query/contact/contact.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "plumb/query/separation/convex_body.hpp"

using namespace plumb;
using c::figure_of, c::guarded, c::moved, c::need, c::need_size;

struct plumb_contact_cache {
  ContactCache cache;
};

namespace {

plumb_feature told(const Feature& f) { return {static_cast<std::int32_t>(f.kind), f.index}; }

/// Asks `one` of each pair; of those that fail the first is told by its number, and no answer is written.
template <class Answer, class One>
plumb_status each_of(const char* function, const plumb_figure* a, const plumb_figure* b, std::size_t count, Answer* out,
                     const One& one) {
  constexpr std::size_t part = 64;
  std::size_t failed = 0;
  std::exception_ptr thrown;
  const plumb_status status = guarded(function, [&] {
    need(a, count, "a");
    need(b, count, "b");
    need(out, count, "the answer");
    std::vector<Answer> answers(count);
    struct Failure {
      std::size_t pair;
      std::exception_ptr thrown;
    };
    std::vector<Failure> failures((count + part - 1) / part);
    certify::batch::for_each_part(Execution::parallel, failures.size(), [&](std::size_t number) {
      std::size_t i = number * part;
      try {
        for (; i < std::min(count, (number + 1) * part); ++i)
          answers[i] = static_cast<Answer>(one(figure_of(a + i, "a"), figure_of(b + i, "b")));
      } catch (...) {
        failures[number] = {i, std::current_exception()};
      }
    });
    const auto first = std::ranges::find_if(failures, [](const Failure& f) { return f.thrown != nullptr; });
    if (first == failures.end()) {
      std::ranges::copy(answers, out);
    } else {
      failed = first->pair;
      thrown = first->thrown;
    }
  });
  if (!thrown) return status;
  char name[96];
  std::snprintf(name, sizeof name, "%s: pair %zu", function, failed);
  return guarded(name, [&] { std::rethrow_exception(thrown); });
}

}  // namespace

extern "C" {

plumb_status plumb_relate(const plumb_figure* a, const plumb_figure* b, plumb_relation* relation) {
  return guarded("plumb_relate", [&] {
    need(relation, "relation");
    *relation = static_cast<plumb_relation>(relate(figure_of(a, "a"), figure_of(b, "b")));
  });
}

plumb_status plumb_intersects(const plumb_figure* a, const plumb_figure* b, int* answer) {
  return guarded("plumb_intersects", [&] {
    need(answer, "answer");
    *answer = intersects(figure_of(a, "a"), figure_of(b, "b"));
  });
}

plumb_status plumb_contains(const plumb_figure* outer, const plumb_figure* inner, int* answer) {
  return guarded("plumb_contains", [&] {
    need(answer, "answer");
    *answer = contains(figure_of(outer, "outer"), figure_of(inner, "inner"));
  });
}

plumb_status plumb_distance(const plumb_figure* a, const plumb_figure* b, double* distance) {
  return guarded("plumb_distance", [&] {
    need(distance, "distance");
    *distance = plumb::distance(figure_of(a, "a"), figure_of(b, "b"));
  });
}

plumb_status plumb_closest_points(const plumb_figure* a, const plumb_figure* b, plumb_closest* closest) {
  return guarded("plumb_closest_points", [&] {
    need_size(closest, "closest");
    const Closest found = closest_points(figure_of(a, "a"), figure_of(b, "b"));
    plumb_closest out{};
    c::copy(out.on_a, found.on_a);
    c::copy(out.on_b, found.on_b);
    out.distance = found.distance;
    out.feature_a = told(found.feature_a);
    out.feature_b = told(found.feature_b);
    c::write(closest, out);
  });
}

plumb_status plumb_hits(const plumb_figure* ray, const plumb_figure* figure, int* answer) {
  return guarded("plumb_hits", [&] {
    need(answer, "answer");
    *answer = hits(figure_of(ray, "ray"), figure_of(figure, "figure"));
  });
}

plumb_status plumb_first_hit(const plumb_figure* ray, const plumb_figure* figure, int* found, plumb_hit* hit) {
  return guarded("plumb_first_hit", [&] {
    need(found, "found");
    need_size(hit, "hit");
    const std::optional<Hit> first = first_hit(figure_of(ray, "ray"), figure_of(figure, "figure"));
    *found = first.has_value();
    if (!first) return;
    plumb_hit out{};
    out.t = first->t;
    c::copy(out.point, first->point);
    c::copy(out.normal, first->normal);
    out.feature = told(first->feature);
    c::write(hit, out);
  });
}

plumb_status plumb_first_contact(const plumb_figure* a, const double* by_a, const plumb_figure* b, const double* by_b,
                                 int* found, plumb_meeting* meeting) {
  return guarded("plumb_first_contact", [&] {
    need(found, "found");
    need_size(meeting, "meeting");
    const std::optional<Contact> first = first_contact(moved(a, by_a, "a"), moved(b, by_b, "b"));
    *found = first.has_value();
    if (!first) return;
    c::write(meeting, plumb_meeting{0, first->time, told(first->feature_a), told(first->feature_b)});
  });
}

plumb_status plumb_penetrate(const plumb_figure* a, const plumb_figure* b, int* found, plumb_penetration* penetration) {
  return guarded("plumb_penetrate", [&] {
    need(found, "found");
    need_size(penetration, "penetration");
    const AnyFigure first = figure_of(a, "a"), second = figure_of(b, "b");
    const std::optional<Penetration> deep = plumb::penetration(first, second);
    *found = deep.has_value();
    if (!deep) return;
    plumb_penetration out{};
    out.depth = deep->depth;
    c::copy(out.direction, deep->direction);
    c::copy(out.translation, deep->translation);
    out.feature_a = told(deep->feature_a);
    out.feature_b = told(deep->feature_b);
    out.is_unique = deep->is_unique;
    c::write(penetration, out);
  });
}

plumb_status plumb_relate_each(const plumb_figure* a, const plumb_figure* b, std::size_t count,
                               std::int8_t* relations) {
  return each_of("plumb_relate_each", a, b, count, relations,
                 [](const AnyFigure& x, const AnyFigure& y) { return relate(x, y); });
}

plumb_status plumb_intersects_each(const plumb_figure* a, const plumb_figure* b, std::size_t count,
                                   std::int8_t* answers) {
  return each_of("plumb_intersects_each", a, b, count, answers,
                 [](const AnyFigure& x, const AnyFigure& y) { return intersects(x, y); });
}

plumb_status plumb_distance_each(const plumb_figure* a, const plumb_figure* b, std::size_t count, double* distances) {
  return each_of("plumb_distance_each", a, b, count, distances,
                 [](const AnyFigure& x, const AnyFigure& y) { return distance(x, y); });
}

plumb_status plumb_contact_cache_create(plumb_contact_cache** cache) {
  return guarded("plumb_contact_cache_create", [&] {
    need(cache, "cache");
    *cache = new plumb_contact_cache{};
  });
}

void plumb_contact_cache_destroy(plumb_contact_cache* cache) { delete cache; }

plumb_status plumb_contact(const plumb_figure* a, const plumb_figure* b, const plumb_contact_options* options,
                           plumb_contact_cache* cache, int* found, plumb_manifold* manifold, plumb_corner* corners,
                           std::size_t capacity) {
  return guarded("plumb_contact", [&] {
    need(found, "found");
    need_size(manifold, "manifold");
    need(corners, capacity, "corners");
    if (options != nullptr) need_size(options, "options");
    const AnyFigure first = figure_of(a, "a"), second = figure_of(b, "b");
    ContactManifoldOptions wanted;
    if (options != nullptr) wanted = {.margin = options->margin, .at_most = options->at_most};
    const std::optional<ContactManifold> m = contact(first, second, wanted, cache == nullptr ? nullptr : &cache->cache);
    *found = m.has_value();
    if (!m) return;
    plumb_manifold out{};
    out.relation = static_cast<std::int32_t>(m->relation);
    c::copy(out.normal, m->normal);
    out.distance = m->distance;
    out.corner_count = m->corners.size();
    for (std::size_t i = 0; i < std::min(capacity, out.corner_count); ++i) {
      const ContactCorner& from = m->corners[i];
      c::copy(corners[i].on_a, from.on_a);
      c::copy(corners[i].on_b, from.on_b);
      corners[i].distance = from.distance;
      corners[i].feature_a = told(from.id.a);
      corners[i].feature_b = told(from.id.b);
    }
    c::write(manifold, out);
  });
}

plumb_status plumb_locate(const plumb_figure* figure, const double* point, plumb_location* location) {
  return guarded("plumb_locate", [&] {
    need(point, "point");
    need(location, "location");
    const AnyFigure any = figure_of(figure, "figure");
    *location = static_cast<plumb_location>(any.dimension() == 2 ? locate(any, Point2{point[0], point[1]})
                                                                 : locate(any, Point3{point[0], point[1], point[2]}));
  });
}

plumb_status plumb_fit_aabb(const plumb_figure* figure, plumb_aabb3* box) {
  return guarded("plumb_fit_aabb", [&] {
    need(box, "box");
    const Aabb3 found = fit_aabb(figure_of(figure, "figure"));
    c::copy(box->min, found.min);
    c::copy(box->max, found.max);
  });
}

plumb_status plumb_support_point(const plumb_figure* figure, const double* direction, double* point) {
  return guarded("plumb_support_point", [&] {
    need(direction, "direction");
    need(point, "point");
    const AnyFigure any = figure_of(figure, "figure");
    const bool space = any.dimension() == 3;
    const Point3 p = support_point(any, Vector3{direction[0], direction[1], space ? direction[2] : 0}).point;
    const double numbers[3] = {p.x, p.y, p.z};
    std::copy_n(numbers, any.dimension(), point);
  });
}

}  // extern "C"
