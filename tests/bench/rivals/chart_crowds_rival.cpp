// Others asked of many things: all pairs of boxes, from boxes of doubles, and the nearest of points.
#include "bench/rivals/box_pairs/rival.hpp"
#include "bench/rivals/chart_rival.hpp"
#include "bench/rivals/nearest/rival.hpp"
#include "lab/crowd/crowds.hpp"

namespace plumb::bench {
namespace {

using namespace lab::trial;

template <class Tree>
Method by_tree(std::string name, std::string about) {
  return of_point_crowds(std::move(name), std::move(about), [](const std::vector<Point3>& points) -> FindNearest {
    return [tree = std::make_shared<const Tree>(points)](const Point3& p) {
      std::uint32_t number = 0;
      tree->nearest(p, 1, &number);
      return number;
    };
  });
}

}  // namespace

void add_crowds(Rivals& all) {
  struct Named {
    const char *name, *about;
    ToldPairs (*find)(std::span<const Aabb3> boxes);
  };
  for (const Named& named :
       {Named{"embree", "Embree's rtcCollide of boxes in floats, rounded outward", embree_told_pairs},
        Named{"cgal", "CGAL's box_self_intersection_d", cgal_told_pairs},
        Named{"bullet", "Bullet's btDbvtBroadphase, in doubles", bullet_told_pairs},
        Named{"fcl", "FCL's DynamicAABBTreeCollisionManager", fcl_told_pairs},
        Named{"boost", "Boost.Geometry's rtree, packed, asked for each box", boost_told_pairs}}) {
    all.push_back({"box-pairs", of_box_crowds(named.name, named.about,
                                              [find = named.find](const std::vector<Aabb3>& boxes) -> FindPairs {
                                                return [boxes, find] { return find(boxes); };
                                              })});
  }
  all.push_back({"nearest-point", by_tree<NanoflannTree>("nanoflann", "nanoflann's KDTreeSingleIndexAdaptor")});
  all.push_back({"nearest-point", by_tree<CgalTree>("cgal", "CGAL's Orthogonal_k_neighbor_search")});
}

}  // namespace plumb::bench
