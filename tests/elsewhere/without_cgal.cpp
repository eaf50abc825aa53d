// What CGAL says, where it is not asked: nothing.
#include "oracle/oracle.hpp"

namespace plumb::oracle {

std::optional<Sign> cgal_sign(std::string_view, std::span<const double>) { return {}; }
std::optional<Sign> face_by_cgal(std::string_view, std::span<const double>) { return {}; }

}  // namespace plumb::oracle
