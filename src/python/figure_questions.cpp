#include "certify/batch/all_threads.hpp"
#include "plumb/query/variant/question_line.hpp"
#include "python/figure_answers.hpp"
#include "python/figure_class.hpp"
#include "python/rooms.hpp"

namespace plumb::python {
namespace {

/// The two figures of a question, which a row of numbers may stand for.
struct Two {
  AnyFigure a, b;
  Two(std::string_view function, const py::object& first, const py::object& second, const char* name_a = "a",
      const char* name_b = "b")
      : a(figure_or_point(first, {function, name_a})), b(figure_or_point(second, {function, name_b})) {}
  [[nodiscard]] int dimension() const { return a.dimension(); }
};

/// Without the interpreter's lock.
template <class Ask>
auto asked(const Ask& ask) {
  const py::gil_scoped_release released;
  return ask();
}

template <class Answer, class Shown>
py::object or_none(const std::optional<Answer>& answer, const Shown& shown) {
  return answer ? py::object(shown(*answer)) : py::none();
}

Vector3 motion_of(const py::object& given, const Asked& asked, int dimension) {
  Vector3 by{0, 0, 0};
  if (given.is_none()) return by;
  if (dimension == 3) {
    read_member(by, given, asked);
  } else {
    Vector2 flat{};
    read_member(flat, given, asked);
    by = {flat.x, flat.y, 0};
  }
  return by;
}

py::object distance_of(const py::object& a, const py::object& b, bool exact) {
  const Two two("distance", a, b);
  if (!exact) return py::float_(asked([&] { return distance(two.a, two.b); }));
  const ExactDistance d = asked([&] { return exact_distance(two.a, two.b); });
  return answer("ExactDistance", fraction_of(d.square), fraction_of(d.inset));
}

py::object hit_of(const py::object& ray, const py::object& figure, bool exact) {
  const Two two("first_hit", ray, figure, "ray", "figure");
  std::optional<RayParameter> t;
  const std::optional<Hit> hit = asked([&] {
    if (exact) t = first_hit_parameter(two.a, two.b);
    return first_hit(two.a, two.b);
  });
  return or_none(hit, [&](const Hit& h) {
    return answer("Hit", t ? number_of_parameter(*t) : py::object(py::float_(h.t)), row_of(h.point, two.dimension()),
                  answer_of(h.feature), row_of(h.normal, two.dimension()));
  });
}

struct TwoInMotion : Two {
  Translating<AnyFigure> first, second;
  TwoInMotion(std::string_view function, const py::object& x, const py::object& y, const py::object& by,
              const py::object& other_by)
      : Two(function, x, y),
        first{a, motion_of(by, {function, "by"}, dimension())},
        second{b, motion_of(other_by, {function, "other_by"}, dimension())} {}
};

py::object contact_time(const py::object& a, const py::object& b, const py::object& by, const py::object& other_by,
                        bool exact) {
  const TwoInMotion two("first_contact", a, b, by, other_by);
  std::optional<Root> t;
  const std::optional<Contact> contact = asked([&] {
    if (exact) t = first_contact_time(two.first, two.second);
    return first_contact(two.first, two.second);
  });
  return or_none(contact, [&](const Contact& c) {
    return answer("FirstContact", t ? number_of_root(*t) : py::object(py::float_(c.time)), answer_of(c.feature_a),
                  answer_of(c.feature_b));
  });
}

bool do_meet(const py::object& a, const py::object& b, const py::object& by, const py::object& other_by) {
  if (by.is_none() && other_by.is_none()) {
    const Two two("intersects", a, b);
    return asked([&] { return intersects(two.a, two.b); });
  }
  const TwoInMotion two("intersects", a, b, by, other_by);
  return asked([&] { return intersects(two.first, two.second); });
}

py::object parted(const py::object& a, const py::object& b, bool exact) {
  const Two two("penetration", a, b);
  const auto shown = [](const auto& p) { return answer_of(p); };
  if (exact) return or_none(asked([&] { return exact_penetration(two.a, two.b); }), shown);
  return or_none(asked([&] { return penetration(two.a, two.b); }), shown);
}

py::object touched(const py::object& a, const py::object& b, double margin, std::size_t at_most, bool exact) {
  const Two two("contact", a, b);
  const auto shown = [](const auto& c) { return answer_of(c); };
  if (exact) return or_none(asked([&] { return exact_contact(two.a, two.b, margin); }), shown);
  return or_none(asked([&] { return contact(two.a, two.b, {.margin = margin, .at_most = at_most}); }), shown);
}

/// Each row's answer, on all threads; one answer for one row.
template <class Answer, class Ask>
py::object of_each(std::string_view function, const AnyFigure& figure, const py::object& points, const Ask& ask) {
  bool single = false;
  const py::array_t<double> rows = row_or_rows_of(points, {function, "points"}, figure.dimension(), single);
  const auto n = static_cast<std::size_t>(rows.size() / figure.dimension());
  py::array_t<Answer> out(static_cast<py::ssize_t>(n));
  Answer* to = out.mutable_data();
  asked([&] {
    constexpr std::size_t part = 256;
    certify::batch::for_each_part(Execution::parallel, (n + part - 1) / part, [&](std::size_t number) {
      for (std::size_t i = number * part; i < std::min(n, (number + 1) * part); ++i) {
        to[i] = static_cast<Answer>(figure.dimension() == 2 ? ask(figure, points_of<Point2>(rows)[i])
                                                            : ask(figure, points_of<Point3>(rows)[i]));
      }
    });
  });
  return single ? py::object(out[py::int_(0)]) : py::object(out);
}

py::object does_contain(const py::object& outer, const py::object& inner) {
  const AnyFigure container = figure_or_point(outer, {"contains", "outer"});
  if (py::isinstance<AnyFigure>(inner)) {
    const AnyFigure held = inner.cast<const AnyFigure&>();
    return py::bool_(asked([&] { return contains(container, held); }));
  }
  const py::object each =
      of_each<bool>("contains", container, inner, [](const AnyFigure& f, const auto& p) { return contains(f, p); });
  return each;
}

py::object where(const py::object& figure, const py::object& points) {
  const py::object all = of_each<std::int8_t>("locate", figure_or_point(figure, {"locate", "figure"}), points,
                                              [](const AnyFigure& f, const auto& p) { return locate(f, p); });
  return py::isinstance<py::array>(all) ? all : py::cast(static_cast<Location>(all.cast<int>()));
}

py::object farthest(const py::object& figure, const py::object& direction) {
  const AnyFigure f = figure_or_point(figure, {"support_point", "figure"});
  const Vector3 along = motion_of(direction, {"support_point", "direction"}, f.dimension());
  return answer_of(asked([&] { return support_point(f, along); }), f.dimension());
}

double extent(const py::object& figure, const py::object& direction) {
  const AnyFigure f = figure_or_point(figure, {"support_value", "figure"});
  const Vector3 along = motion_of(direction, {"support_value", "direction"}, f.dimension());
  return asked([&] { return support_value(f, along); });
}

py::object boxed(const py::object& figure) {
  const AnyFigure f = figure_or_point(figure, {"fit_aabb", "figure"});
  const Aabb3 box = asked([&] { return fit_aabb(f); });
  if (f.dimension() == 3) return object_of(box);
  return object_of(Aabb2{{box.min.x, box.min.y}, {box.max.x, box.max.y}});
}

const std::string about_two =
    "\n\nParameters\n----------\na, b : Figure, or array_like of shape (2,) or (3,), which is a point; both of the "
    "plane "
    "or both of space\n";
const std::string about_exact = "exact : bool; numbers are then fractions.Fraction, and nothing is rounded\n";
const std::string about_errors =
    "\nRaises\n------\nValueError\n    If the library has no answer for such a pair, or a figure is none; the text "
    "says "
    "why.\nTypeError\n    If an argument is no figure.\n";

void add_enumerations(py::module_& module) {
  py::enum_<Relation>(module, "Relation", "How two closed sets lie to one another; touching is told from overlapping.")
      .value("disjoint", Relation::disjoint)
      .value("touching", Relation::touching)
      .value("overlapping", Relation::overlapping);
  py::enum_<Location>(module, "Location", "Where a point lies to a closed set; its boundary is part of the set.")
      .value("outside", Location::outside)
      .value("boundary", Location::boundary)
      .value("inside", Location::inside);
}

void add_questions_at_rest(py::module_& module) {
  const py::arg a("a"), b("b");
  const py::arg_v exact = py::arg("exact") = false;
  module.def(
      "relate",
      [](const py::object& x, const py::object& y) {
        const Two two("relate", x, y);
        return asked([&] { return relate(two.a, two.b); });
      },
      a, b,
      ("relate(a, b)\n--\n\nAre two figures disjoint, do they touch, or do they overlap?" + about_two +
       "\nReturns\n-------\nRelation\n" + about_errors)
          .c_str());
  module.def("distance", distance_of, a, b, py::kw_only(), exact,
             ("distance(a, b, *, exact=False)\n--\n\nHow far are two figures apart?  Rounded once; 0 where they meet." +
              about_two + about_exact + "\nReturns\n-------\nfloat; where exact: ExactDistance\n" + about_errors)
                 .c_str());
  module.def(
      "squared_distance",
      [](const py::object& x, const py::object& y) {
        const Two two("squared_distance", x, y);
        return fraction_of(asked([&] { return squared_distance_exact(two.a, two.b); }));
      },
      a, b,
      ("squared_distance(a, b)\n--\n\nThe square of the distance of two figures neither of which is round, exactly." +
       about_two + "\nReturns\n-------\nfractions.Fraction\n" + about_errors)
          .c_str());
  module.def(
      "closest_points",
      [](const py::object& x, const py::object& y) {
        const Two two("closest_points", x, y);
        return answer_of(asked([&] { return closest_points(two.a, two.b); }), two.dimension());
      },
      a, b,
      ("closest_points(a, b)\n--\n\nWhich points of two figures are nearest to one another?" + about_two +
       "\nReturns\n-------\nClosestPoints: coordinates and distance are rounded once, features are exact\n" +
       about_errors)
          .c_str());
  module.def(
      "intersection",
      [](const py::object& x, const py::object& y, bool unrounded) {
        const Two two("intersection", x, y);
        return answer_of(asked([&] { return intersection(two.a, two.b); }), unrounded);
      },
      a, b, py::kw_only(), exact,
      ("intersection(a, b, *, exact=False)\n--\n\nWhich points have two flat figures in common?" + about_two +
       about_exact + "\nReturns\n-------\nIntersection: its corners\n" + about_errors)
          .c_str());
  module.def(
      "contains", does_contain, py::arg("outer"), py::arg("inner"),
      ("contains(outer, inner)\n--\n\nIs a figure, or is each point, part of a closed set?\n\nParameters\n"
       "----------\nouter : Figure\ninner : Figure, or array_like of points, shape (d,) or (n, d) for a figure of "
       "d dimensions\n\nReturns\n-------\nbool, or bool of shape (n,)\n" +
       about_errors)
          .c_str());
  module.def("locate", where, py::arg("figure"), py::arg("points"),
             ("locate(figure, points)\n--\n\nIs a point outside of a figure, on its boundary or inside?\n\nParameters\n"
              "----------\nfigure : Figure\npoints : array_like, shape (d,) or (n, d) for a figure of d dimensions\n\n"
              "Returns\n-------\nLocation, or int8 of shape (n,): -1 outside, 0 on the boundary, 1 inside\n" +
              about_errors)
                 .c_str());
  module.def("penetration", parted, a, b, py::kw_only(), exact,
             ("penetration(a, b, *, exact=False)\n--\n\nWhat is the least translation of a that parts it from b?" +
              about_two + about_exact +
              "\nBoth are convex bodies of space.\n\nReturns\n-------\nPenetration, where exact ExactPenetration; None "
              "where they are disjoint\n" +
              about_errors)
                 .c_str());
  module.def(
      "contact", touched, a, b, py::arg("margin") = 0.0, py::arg("at_most") = 0, py::kw_only(), exact,
      ("contact(a, b, margin=0.0, at_most=0, *, exact=False)\n--\n\nWhere do two convex bodies of space touch, or "
       "nearly touch?" +
       about_two +
       "margin : float, not negative; bodies no farther apart have a contact\nat_most : int; so many corners are "
       "kept, 0 for all of them\n" +
       about_exact +
       "\nReturns\n-------\nContact, where exact ExactContact with all corners; None where they are farther "
       "apart\n" +
       about_errors)
          .c_str());
}

void add_questions_of_one(py::module_& module) {
  const std::string about =
      "\n\nParameters\n----------\nfigure : Figure\ndirection : array_like, shape (3,), or (2,) of a figure of the "
      "plane\n";
  module.def("support_point", farthest, py::arg("figure"), py::arg("direction"),
             ("support_point(figure, direction)\n--\n\nWhich point of a figure is farthest along a direction?" + about +
              "\nReturns\n-------\nSupport\n" + about_errors)
                 .c_str());
  module.def("support_value", extent, py::arg("figure"), py::arg("direction"),
             ("support_value(figure, direction)\n--\n\nWhat is the greatest product of a direction and a point of a "
              "figure?  Rounded up." +
              about + "\nReturns\n-------\nfloat\n" + about_errors)
                 .c_str());
  module.def(
      "fit_aabb", boxed, py::arg("figure"),
      ("fit_aabb(figure)\n--\n\nThe least box along the axes that holds a figure, rounded outward.\n\nParameters\n"
       "----------\nfigure : Figure\n\nReturns\n-------\nAabb3, or Aabb2 of a figure of the plane\n" +
       about_errors)
          .c_str());
}

void add_questions_in_motion(py::module_& module) {
  const std::string about =
      "by, other_by : array_like, shape (3,), or (2,) in the plane; so far a and b move from time 0 to time 1, or not "
      "at "
      "all\n";
  const py::arg_v none = py::arg("other_by") = py::none();
  module.def("intersects", do_meet, py::arg("a"), py::arg("b"), py::arg("by") = py::none(), none,
             ("intersects(a, b, by=None, other_by=None)\n--\n\nDo two figures have a point in common, at rest or while "
              "they move?" +
              about_two + about + "\nReturns\n-------\nbool\n" + about_errors)
                 .c_str());
  module.def("first_contact", contact_time, py::arg("a"), py::arg("b"), py::arg("by"), none, py::kw_only(),
             py::arg("exact") = false,
             ("first_contact(a, b, by, other_by=None, *, exact=False)\n--\n\nWhen do two moving figures first meet?" +
              about_two + about + about_exact +
              "\nReturns\n-------\nFirstContact, its time from 0 to 1 rounded down; None where they do not meet\n" +
              about_errors)
                 .c_str());
  module.def("first_hit", hit_of, py::arg("ray"), py::arg("figure"), py::kw_only(), py::arg("exact") = false,
             ("first_hit(ray, figure, *, exact=False)\n--\n\nWhere does a ray, a segment or a line first meet a figure?"
              "\n\nParameters\n----------\nray : Ray3, Segment3 or Line3, or those of the plane\nfigure : Figure\n" +
              about_exact + "\nReturns\n-------\nHit, or None\n" + about_errors)
                 .c_str());
}

std::string answer_to_line(const std::string& line) {
  const std::optional<QuestionLine> asked_line = parse_question_line(line);
  if (!asked_line) throw py::value_error("ask: the line is blank or a remark");
  return asked([&] { return answer_of(*asked_line); });
}

void add_question_lines(py::module_& module) {
  module.def("ask", answer_to_line, py::arg("line"),
             "ask(line)\n--\n\nThe answer to a question that is a line of text, as the program `plumb replay` reads "
             "it.\n\nParameters\n----------\nline : str\n    The question, its figures and numbers between bars; an "
             "answer behind '=' is not looked at.\n\nReturns\n-------\nstr, in words and hexadecimal numbers; "
             "'refused: ' and why, where the question has no answer\n\nRaises\n------\nValueError : the line is "
             "no question\n\nExamples\n--------\n>>> plumb.ask('relate | ball3 0 0 0 1 | ball3 2 0 0 1')\n"
             "'touching'\n");
}

}  // namespace

void add_figure_questions(py::module_& module) {
  add_enumerations(module);
  add_questions_at_rest(module);
  add_questions_of_one(module);
  add_questions_in_motion(module);
  add_question_lines(module);
}

}  // namespace plumb::python
