#include "bench/rivals/chart_rival.hpp"
#include "bench/rivals/stability/rival.hpp"
#include "lab/program/program.hpp"

int main(int argc, char** argv) {
  plumb::bench::Rivals rivals;
  for (const auto add :
       {plumb::bench::add_cgal_predicates, plumb::bench::add_cgal_figures, plumb::bench::add_cgal_meshes,
        plumb::bench::add_cgal_triangulations, plumb::bench::add_embree, plumb::bench::add_embree_meshes,
        plumb::bench::add_fcl, plumb::bench::add_fcl_meshes, plumb::bench::add_ccd, plumb::bench::add_bullet,
        plumb::bench::add_bullet_meshes, plumb::bench::add_qhull, plumb::bench::add_eigen, plumb::bench::add_crowds})
    add(rivals);
  return plumb::tool::run_program(plumb::lab::laboratory_facts(rivals, plumb::bench::world_rivals()), argc, argv);
}
