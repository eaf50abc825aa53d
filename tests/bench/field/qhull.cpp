// Qhull's hulls by the C signature of `plumb fuzz --list`: facets in triangles (option Qt).
#include "bench/rivals/qhull_calls.hpp"

extern "C" std::size_t qhull_hull(const double* points, std::size_t n, std::size_t* triangles, std::size_t capacity) {
  std::size_t count = 0;
  const bool done = plumb::bench::with_qhull(3, points, n, "qhull Qt", [&](qhT& state) {
    for (facetT* facet = state.facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next) {
      setT* corners = qh_facet3vertex(&state, facet);  // clockwise seen from outside
      if (count < capacity) {
        for (int k = 0; k < 3; ++k) {
          triangles[3 * count + static_cast<std::size_t>(2 - k)] =
              static_cast<std::size_t>(qh_pointid(&state, static_cast<vertexT*>(corners->e[k].p)->point));
        }
      }
      qh_settempfree(&state, &corners);
      ++count;
    }
  });
  return done ? count : static_cast<std::size_t>(-1);
}
