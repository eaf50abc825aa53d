#include "query/body/figure_text.hpp"

#include <cmath>
#include <cstring>
#include <vector>

#include "certify/case_line.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/generated/generated.hpp"

namespace plumb {
namespace {

// A kind by one word, as degenerate/shape.hpp spells it where it has that kind.
template <Figure Shape>
std::string_view word_of_shape() {
  if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
    return "polyhedron";
  } else if constexpr (GeneratedShape<Shape>) {
    return degenerate::name_of(generated_kind<Shape>);
  } else {
    return name_of(figure_kind<Shape>);
  }
}
template <Figure Shape>
std::string name_of_shape() {
  return std::string(word_of_shape<Shape>()) + std::to_string(figure_dimension<Shape>);
}

// Vectors and points have two numbers or three, in order.
template <class Places>
void append(std::vector<double>& to, const Places& places) {
  for (const auto& p : places) {
    to.push_back(p.x), to.push_back(p.y);
    if constexpr (requires { p.z; }) to.push_back(p.z);
  }
}

template <class Shape>
std::vector<double> row_of(const Shape& s) {
  std::vector<double> row;
  const auto count = [&row](std::size_t n) { row.push_back(static_cast<double>(n)); };
  if constexpr (std::is_trivially_copyable_v<Shape>) {
    row.resize(sizeof(Shape) / sizeof(double));
    std::memcpy(row.data(), &s, sizeof(Shape));
  } else if constexpr (requires { s.outer; }) {
    count(1 + s.holes.size());
    const auto chain = [&](const auto& polygon) { count(polygon.vertices.size()), append(row, polygon.vertices); };
    chain(s.outer);
    for (const auto& hole : s.holes) chain(hole);
  } else if constexpr (requires { s.halfspaces; }) {
    for (const auto& h : s.halfspaces) append(row, std::array{h.normal}), row.push_back(h.offset);
  } else if constexpr (requires { s.directions; }) {
    count(s.directions.size());
    append(row, s.directions.all());
    row.insert(row.end(), s.min.begin(), s.min.end());
    row.insert(row.end(), s.max.begin(), s.max.end());
  } else if constexpr (requires { s.mesh; }) {
    count(s.mesh.vertices.size());
    append(row, s.mesh.vertices);
    for (std::size_t f = 0; f + 1 < s.mesh.first.size(); ++f) {
      count(s.mesh.first[f + 1] - s.mesh.first[f]);
      for (std::size_t i = s.mesh.first[f]; i < s.mesh.first[f + 1]; ++i) count(s.mesh.corners[i]);
    }
  } else if constexpr (requires { s.links; }) {
    for (const auto& link : s.links) {
      const std::vector<double> one = row_of(link);
      row.insert(row.end(), one.begin(), one.end());
    }
  } else {
    append(row, s.vertices);
  }
  return row;
}

/// Numbers in order, of which a shape with lists takes as many as it says.
class Row {
 public:
  Row(std::string_view name, std::vector<double> numbers) : name_(name), numbers_(std::move(numbers)) {}

  [[nodiscard]] bool ended() const { return at_ == numbers_.size(); }
  double number() {
    if (ended()) refuse("the line ends too early");
    return numbers_[at_++];
  }
  /// A whole number, below `end`.
  std::size_t count(double end) {
    const double n = number();
    if (!(n >= 0 && n < end && n == std::floor(n))) refuse(hexadecimal(n) + " counts nothing");
    return static_cast<std::size_t>(n);
  }
  /// How many of `size` numbers each follow?
  std::size_t list(std::size_t size) {
    const std::size_t n = count(0x1p32);
    if (n > (numbers_.size() - at_) / size) refuse("the line ends too early");
    return n;
  }
  template <class Place>
  std::vector<Place> places(std::size_t n) {
    std::vector<Place> all(n);
    std::memcpy(all.data(), numbers_.data() + at_, n * sizeof(Place));
    at_ += n * sizeof(Place) / sizeof(double);
    return all;
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw InvalidShape(std::string(name_) + ": " + why + "; query/body/any_figure.hpp says what its numbers are");
  }

 private:
  std::string_view name_;
  std::vector<double> numbers_;
  std::size_t at_ = 0;
};

template <class Vector>
KDop<Vector> k_dop_of(Row& row) {
  constexpr std::size_t size = sizeof(Vector) / sizeof(double);
  const std::size_t n = row.list(size + 2);
  return {Directions<Vector>(row.places<Vector>(n)), row.places<double>(n), row.places<double>(n)};
}

ConvexPolyhedron3 polyhedron_of(Row& row) {
  PolygonMesh mesh;
  mesh.vertices = row.places<Point3>(row.list(3));
  while (!row.ended()) {
    for (std::size_t n = row.list(1); n-- > 0;)
      mesh.corners.push_back(static_cast<std::uint32_t>(row.count(static_cast<double>(mesh.vertices.size()))));
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return convex_polyhedron(std::move(mesh));
}

template <class Shape>
Shape shape_of(std::string_view name, std::vector<double> numbers) {
  if constexpr (std::is_same_v<Shape, SphericalCap3>) {
    if (numbers.size() != 8) Row(name, numbers).refuse(std::to_string(numbers.size()) + " numbers, not 8");
    Shape cap;
    std::memcpy(&cap, numbers.data(), sizeof cap);
    return cap;
  } else if constexpr (std::is_same_v<Shape, ConvexPolyhedron3> || requires(Shape s) { s.directions; }) {
    Row row(name, std::move(numbers));
    Shape shape = [&row] {
      if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
        return polyhedron_of(row);
      } else if constexpr (figure_dimension<Shape> == 2) {
        return k_dop_of<Vector2>(row);
      } else {
        return k_dop_of<Vector3>(row);
      }
    }();
    if (!row.ended()) row.refuse("numbers are left over");
    return shape;
  } else {
    return shape_from<Shape>(numbers);
  }
}

template <class Shape>
void tell_numbers(const Shape& s, query::LineParts& line) {
  if constexpr (std::is_trivially_copyable_v<Shape>) {
    line.numbers_of(s);
  } else {
    line.numbers(row_of(s));
  }
}

/// The word tells how a figure stands.
template <class By>
std::string_view word_of_pose() {
  if constexpr (requires(const By& by) { by.columns; }) {
    return "pose";
  } else if constexpr (requires(const By& by) { by.turn; }) {
    return "rigid";
  } else {
    return "chain";
  }
}
bool says_how_it_stands(std::string_view word) {
  return word == word_of_pose<Pose>() || word == word_of_pose<RigidPose>() || word == word_of_pose<RigidChain>();
}

/// Numbers, up to the end of the line or a word that is none.
std::vector<double> next_numbers(std::string_view& line) {
  std::vector<double> numbers;
  for (std::string_view rest = line, word = next_word(rest); !word.empty() && !says_how_it_stands(word);
       word = next_word(rest)) {
    numbers.push_back(parse_double(word));
    line = rest;
  }
  return numbers;
}

/// As many as `numbers` are.
template <class By>
std::vector<By> poses_of(const std::vector<double>& numbers) {
  std::vector<By> poses(numbers.size() / (sizeof(By) / sizeof(double)));
  if (!poses.empty()) std::memcpy(static_cast<void*>(poses.data()), numbers.data(), numbers.size() * sizeof(double));
  return poses;
}
template <class By>
AnyPose pose_of(std::string_view name, const std::vector<double>& numbers) {
  const auto require = [&](bool is_right, std::string_view what, const std::string& wanted) {
    if (is_right) return;
    throw InvalidShape(std::string(name) + ": " + std::to_string(numbers.size()) + " numbers are no " +
                       std::string(what) + "; give " + wanted + " and then the translation");
  };
  if constexpr (requires(const By& by) { by.links; }) {
    using Link = typename decltype(By::links)::value_type;
    constexpr std::size_t size = sizeof(Link) / sizeof(double);
    require(numbers.size() % size == 0, "chain", std::to_string(size) + " for each link, the quaternion");
    return By{poses_of<Link>(numbers)};
  } else {
    constexpr std::size_t size = sizeof(By) / sizeof(double);
    constexpr bool is_matrix = requires(const By& by) { by.columns; };
    require(numbers.size() == size, is_matrix ? "pose" : "rigid pose",
            std::to_string(size) + (is_matrix ? ", the columns" : ", the quaternion"));
    return poses_of<By>(numbers).front();
  }
}
template <class Matrix, class Rigid, class Chain>
AnyPose pose_by(std::string_view word, std::string_view name, const std::vector<double>& numbers) {
  if (word == word_of_pose<Matrix>()) return pose_of<Matrix>(name, numbers);
  if (word == word_of_pose<Rigid>()) return pose_of<Rigid>(name, numbers);
  return pose_of<Chain>(name, numbers);
}

struct Reader {
  std::string name;
  AnyFigure (*read)(std::string_view name, std::vector<double> numbers);
};
template <Figure Shape>
Reader reader() {
  return {name_of_shape<Shape>(), [](std::string_view name, std::vector<double> numbers) {
            return AnyFigure(shape_of<Shape>(name, std::move(numbers)));
          }};
}

/// Of every kind that there is.
const std::vector<Reader>& readers() {
  static const std::vector<Reader> all = [] {
    std::vector<Reader> found;
    for (const int dimension : {2, 3}) {
      for (std::size_t k = 0; k < figure_kinds; ++k) {
        const query::FigureView v{static_cast<FigureKind>(k), dimension, nullptr};
        query::with_figure_type(v, [&]<class Shape>(const Shape*) {
          if (figure_dimension<Shape> == dimension) found.push_back(reader<Shape>());
        });
      }
    }
    return found;
  }();
  return all;
}

const Reader& reader_named(std::string_view word) {
  std::string names;
  for (const Reader& r : readers()) {
    if (r.name == word) return r;
    names += (names.empty() ? "" : ", ") + r.name;
  }
  throw Error("there is no figure " + quoted_word(word) + "; there are " + names);
}

}  // namespace

void query::tell_figure(const PosedView& posed, LineParts& line) {
  query::with_figure(posed.figure, [&line]<class Shape>(const Shape& s) {
    static const std::string name = name_of_shape<Shape>();
    line.text(name);
    tell_numbers(s, line);
  });
  std::visit(
      [&line]<class By>(const By& pose) {
        if constexpr (!std::is_same_v<By, std::monostate>) {
          line.word(word_of_pose<std::remove_cvref_t<decltype(*pose)>>());
          tell_numbers(*pose, line);
        }
      },
      posed.pose.by);
}

std::string query::figure_line(const PosedView& posed) {
  LineParts line;
  tell_figure(posed, line);
  return LineParts::written(line.kept());
}

std::string to_string(const AnyFigure& figure) { return query::figure_line(figure.view()); }

std::optional<AnyFigure> parse_figure(std::string_view line) {
  const std::string_view word = next_word(line);
  if (word.empty()) return std::nullopt;
  const Reader& reader = reader_named(word);
  AnyFigure figure = reader.read(reader.name, next_numbers(line));
  const std::string_view how = next_word(line);
  if (how.empty()) return figure;
  const std::vector<double> pose = next_numbers(line);
  if (const std::string_view more = next_word(line); !more.empty())
    throw Error(reader.name + ": nothing may follow the pose, but here comes " + quoted_word(more));
  return figure.under(figure.dimension() == 2 ? pose_by<Pose2, RigidPose2, RigidChain2>(how, reader.name, pose)
                                              : pose_by<Pose, RigidPose, RigidChain>(how, reader.name, pose));
}

}  // namespace plumb
