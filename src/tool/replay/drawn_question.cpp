#include "tool/replay/drawn_question.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "plumb/query/contact/contact.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/separation/corners.hpp"
#include "tool/drawing/drawn_hull.hpp"

namespace plumb::tool {
namespace {

Point3 in_space(const Point3& p) { return p; }
Point3 in_space(const Point2& p) { return {p.x, p.y, 0}; }
Point3 moved(const Point3& p, const Vector3& by) { return {p.x + by.x, p.y + by.y, p.z + by.z}; }

/// They lead along all axes and diagonals, and turn around an axis from pole to pole.
std::vector<Vector3> many_directions() {
  constexpr std::size_t turning = 300;
  std::vector<Vector3> all;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) all.push_back({double(x), double(y), double(z)});
  for (std::size_t i = 0; i < turning; ++i) {
    const double height = 1 - 2 * (static_cast<double>(i) + 0.5) / turning, radius = std::sqrt(1 - height * height);
    const double angle = 2.399963229728653 * static_cast<double>(i);
    all.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
  }
  return all;
}

/// What a figure has along these before its pose, as far as it ends there.
struct Extremes {
  std::vector<Point3> points;
  bool are_all = true;
  std::string why_not;
};
Extremes extremes_of(const AnyFigure& figure) {
  static const std::vector<Vector3> directions = many_directions();
  if (const auto* p = get_if<Point2>(figure)) return {{in_space(*p)}, true, {}};
  if (const auto* p = get_if<Point3>(figure)) return {{*p}, true, {}};
  const AnyFigure as_it_stands = visit([](const auto& shape) { return AnyFigure(shape); }, figure);
  Extremes found;
  for (const Vector3& d : directions) {
    if (figure.dimension() == 2 && d.z != 0) continue;
    try {
      found.points.push_back(support_point(as_it_stands, d).point);
    } catch (const Error& e) {
      found.are_all = false, found.why_not = e.what();
    }
  }
  return found;
}

std::vector<Point3> corners_of(const AnyIntersection& common) {
  std::vector<Point3> corners;
  std::visit(
      [&](const auto& is) {
        if constexpr (requires { is.vertices; }) {
          for (const auto& p : is.vertices) corners.push_back(in_space(approximate(p)));
        } else if (is.point) {
          corners.push_back(in_space(approximate(*is.point)));
        }
      },
      common);
  return corners;
}

void draw_hull(std::vector<Point3> points, DrawnFigure& to) {
  DrawnHull drawn = drawn_hull(convex_hull(points), points);
  to.points = std::move(drawn.points), to.edges = std::move(drawn.edges);
}

/// The hull is that before the pose, of which rounded images would divide the faces.
void draw_posed(std::vector<Point3> points, const AnyFigure& figure, DrawnFigure& to) {
  draw_hull(std::move(points), to);
  if (!figure.is_posed()) return;
  const auto pose = query::weighted_pose<double>(figure.pose());
  for (Point3& p : to.points) {
    const auto q = pose.image({p.x, p.y, p.z});
    p = {q.x / pose.weight, q.y / pose.weight, q.z / pose.weight};
  }
}

/// It reaches twice as far as the points do around their middle.
Aabb3 around(const std::vector<Point3>& points) {
  std::array<double, 3> least{-1, -1, -1}, most{1, 1, 1};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<double, 3> p{points[i].x, points[i].y, points[i].z};
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = i == 0 ? p[k] : std::min(least[k], p[k]);
      most[k] = i == 0 ? p[k] : std::max(most[k], p[k]);
    }
  }
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k) reach = std::max(reach, most[k] - least[k]);
  if (reach == 0) reach = 1;
  return {{least[0] - reach, least[1] - reach, least[2] - reach}, {most[0] + reach, most[1] + reach, most[2] + reach}};
}

void draw_clipped(const AnyFigure& figure, const Aabb3& box, const std::string& why_not, DrawnFigure& to) {
  try {
    const AnyIntersection common =
        figure.dimension() == 3
            ? intersection(figure, AnyFigure(box))
            : intersection(figure, AnyFigure(Aabb2{{box.min.x, box.min.y}, {box.max.x, box.max.y}}));
    std::vector<Point3> corners = corners_of(common);
    if (corners.empty()) {
      to.why_not = "it passes by all others";
    } else {
      draw_hull(std::move(corners), to);
    }
  } catch (const Error&) {
    to.why_not = why_not;
  }
}

std::vector<DrawnFigure> drawn_figures(const QuestionLine& line) {
  static constexpr std::array<const char*, 4> of_two{"a", "b"}, in_motion{"a before", "a after", "b before", "b after"};
  const auto& names = line.figures.size() == 4 ? in_motion : of_two;
  std::vector<DrawnFigure> drawn;
  std::vector<Extremes> extremes;
  std::vector<Point3> all;
  for (std::size_t i = 0; i < line.figures.size(); ++i) {
    drawn.push_back({});
    drawn.back().name = names[i], drawn.back().text = to_string(line.figures[i]);
    extremes.push_back(extremes_of(line.figures[i]));
    if (!extremes.back().are_all) continue;
    draw_posed(std::move(extremes.back().points), line.figures[i], drawn.back());
    all.insert(all.end(), drawn.back().points.begin(), drawn.back().points.end());
  }
  const Aabb3 box = around(all);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (!extremes[i].are_all) draw_clipped(line.figures[i], box, extremes[i].why_not, drawn[i]);
  return drawn;
}

/// What answers tell of places; nothing where the question has no answer.
class Marks {
 public:
  explicit Marks(const QuestionLine& line) : line_(line) {}

  std::vector<DrawnMark> run() {
    const auto& f = line_.figures;
    const auto& n = line_.numbers;
    const std::string& question = line_.question;
    if (f.size() == 1) {
      if (question == "fit_aabb") ask([&] { tell_box(fit_aabb(f[0])); });
      if (n.size() >= 3) ask([&] { tell("the support point", support_point(f[0], {n[0], n[1], n[2]}).point); });
    } else if (f.size() == 2 && n.size() == 6) {
      ask([&] { tell_way("a moves", f[0], {n[0], n[1], n[2]}); });
      ask([&] { tell_way("b moves", f[1], {n[3], n[4], n[5]}); });
    } else if (question == "contact") {
      ask([&] { tell_contact(contact(f[0], f[1], {.margin = n[0], .at_most = static_cast<std::size_t>(n[1])})); });
    } else if (f.size() == 2) {
      tell_of_pair(question, f[0], f[1]);
    }
    return std::move(marks_);
  }

 private:
  template <class Ask>
  void ask(const Ask& asked) {
    try {
      asked();
    } catch (const Error&) {  // what refuses it is its answer
    }
  }
  void tell(std::string title, const Point3& p) { marks_.push_back({std::move(title), {p}}); }
  void tell(std::string title, const Point3& p, const Point3& q) { marks_.push_back({std::move(title), {p, q}}); }

  void tell_of_pair(const std::string& question, const AnyFigure& a, const AnyFigure& b) {
    if (question.starts_with("first_hit") || question == "hits") return ask([&] { tell_hit(a, b); });
    if (question == "intersection") {
      return ask([&] {
        for (const Point3& p : corners_of(intersection(a, b))) tell("a corner of what is in common", p);
      });
    }
    if (question == "penetration") {
      return ask([&] {
        if (const auto p = penetration(a, b)) tell_way("the least way that parts b from a", b, p->translation);
      });
    }
    ask([&] {
      const Closest c = closest_points(a, b);
      tell("the closest points", in_space(c.on_a), in_space(c.on_b));
    });
  }
  void tell_hit(const AnyFigure& line, const AnyFigure& figure) {
    const auto hit = first_hit(line, figure);
    if (!hit) return;
    tell("the first hit, and the normal there", hit->point, moved(hit->point, hit->normal));
  }
  void tell_contact(const std::optional<ContactManifold>& m) {
    if (!m) return;
    for (const ContactCorner& c : m->corners) tell("a corner of the contact, on either body", c.on_a, c.on_b);
  }
  void tell_box(const Aabb3& box) {
    tell("the box's least corner", box.min);
    tell("the box's greatest corner", box.max);
  }
  void tell_way(std::string title, const AnyFigure& from, const Vector3& by) {
    const Aabb3 box = fit_aabb(from);
    const Point3 middle{box.min.x / 2 + box.max.x / 2, box.min.y / 2 + box.max.y / 2, box.min.z / 2 + box.max.z / 2};
    tell(std::move(title), middle, moved(middle, by));
  }

  const QuestionLine& line_;
  std::vector<DrawnMark> marks_;
};

/// Tells the corners of a convex body's core, and none of what has no core.
std::vector<Point3> core_corners(const AnyFigure& figure) {
  std::vector<Point3> corners;
  if (const auto core = query::CoreCorners::of(query::body_view(figure))) {
    for (std::size_t i = 0; i < core->size(); ++i) {
      const auto p = core->at<mpq_class>(i);
      corners.push_back({p.x.get_d(), p.y.get_d(), p.z.get_d()});
    }
  }
  return corners;
}

void add_steps(const QuestionLine& line, DrawnQuestion& to) {
  if (line.figures.size() != 2 || !line.numbers.empty()) return;
  try {
    std::vector<GjkStep> steps;
    (void)gjk(line.figures[0], line.figures[1], {.history = &steps});
    for (const std::size_t i : {0U, 1U}) to.figures[i].corners = core_corners(line.figures[i]);
    to.steps = std::move(steps);
  } catch (const Error&) {  // one is no convex body, or no figure at all
  }
}

/// Scales all by one power of two, so that a script's doubles neither vanish nor overflow.
void bring_near_one(DrawnQuestion& q) {
  std::vector<std::vector<Point3>*> all;
  for (DrawnFigure& f : q.figures) all.push_back(&f.points), all.push_back(&f.corners);
  for (DrawnMark& m : q.marks) all.push_back(&m.points);
  double most = 0;
  for (const auto* points : all)
    for (const Point3& p : *points) most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (most == 0 || !std::isfinite(most)) return;
  const int by = -std::ilogb(most);
  for (auto* points : all)
    for (Point3& p : *points) p = {std::ldexp(p.x, by), std::ldexp(p.y, by), std::ldexp(p.z, by)};
}

}  // namespace

DrawnQuestion drawn_question(const QuestionLine& line) {
  DrawnQuestion q{drawn_figures(line), Marks(line).run(), {}};
  add_steps(line, q);
  const auto is_finite = [](const Point3& p) { return p.x - p.x == 0 && p.y - p.y == 0 && p.z - p.z == 0; };
  std::erase_if(q.marks, [&](const DrawnMark& m) { return !std::ranges::all_of(m.points, is_finite); });
  for (DrawnFigure& f : q.figures) {
    if (std::ranges::all_of(f.points, is_finite)) continue;
    f.points.clear(), f.edges.clear();
    f.why_not = "it reaches beyond the largest double";
  }
  bring_near_one(q);
  return q;
}

}  // namespace plumb::tool
