# The program plumb-bench: plumb-lab with the rivals' libraries among the methods of `plumb-lab chart`.  Not installed:
# nothing that is links a rival.
if(NOT TARGET plumb_lab)
  message(FATAL_ERROR "PLUMB_BUILD_RIVALS needs PLUMB_BUILD_PROGRAM and PLUMB_BUILD_LAB")
endif()
# Debian: apt-get install libboost-dev libbullet-dev libccd-dev libembree-dev libfcl-dev libnanoflann-dev, beside what the
# benchmarks need.
find_path(PLUMB_BOOST_INCLUDE boost/geometry/index/rtree.hpp REQUIRED)
find_path(PLUMB_BULLET_INCLUDE btBulletCollisionCommon.h PATH_SUFFIXES bullet REQUIRED)
find_path(PLUMB_CCD_INCLUDE ccd/ccd.h REQUIRED)
find_path(PLUMB_EMBREE_INCLUDE embree3/rtcore.h REQUIRED)
find_path(PLUMB_FCL_INCLUDE fcl/fcl.h REQUIRED)
find_path(PLUMB_NANOFLANN_INCLUDE nanoflann.hpp REQUIRED)
add_library(rival_libraries INTERFACE)
foreach(library BulletCollision-float64 LinearMath-float64 ccd embree3 fcl octomap octomath)
  find_library(PLUMB_${library}_LIBRARY ${library} REQUIRED)
  mark_as_advanced(PLUMB_${library}_LIBRARY)
  target_link_libraries(rival_libraries INTERFACE ${PLUMB_${library}_LIBRARY})
endforeach()
mark_as_advanced(PLUMB_BOOST_INCLUDE PLUMB_BULLET_INCLUDE PLUMB_CCD_INCLUDE PLUMB_EMBREE_INCLUDE PLUMB_FCL_INCLUDE
  PLUMB_NANOFLANN_INCLUDE)

target_link_libraries(rival_libraries INTERFACE ${PLUMB_QHULL_LIBRARY})
target_include_directories(rival_libraries SYSTEM INTERFACE ${PLUMB_BOOST_INCLUDE} ${PLUMB_BULLET_INCLUDE}
  ${PLUMB_CCD_INCLUDE} ${PLUMB_EIGEN_INCLUDE} ${PLUMB_EMBREE_INCLUDE} ${PLUMB_FCL_INCLUDE} ${PLUMB_NANOFLANN_INCLUDE}
  ${PLUMB_QHULL_INCLUDE})
target_compile_definitions(rival_libraries INTERFACE BT_USE_DOUBLE_PRECISION)

add_executable(plumb_bench plumb_bench.cpp ${chart_sources} ${box_pairs_sources} rivals/nearest/cgal.cpp
  rivals/nearest/nanoflann.cpp)
set_target_properties(plumb_bench PROPERTIES OUTPUT_NAME plumb-bench)
target_link_libraries(plumb_bench PRIVATE bench_rivals plumb_lab bench_flags rival_libraries)
if(PLUMB_BENCH_LEVEL)
  target_precompile_headers(plumb_bench REUSE_FROM bench_rivals)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # What GCC sees in CGAL's spheres and TBB's counters is not there.
  set_property(SOURCE rivals/chart_cgal_figures_rival.cpp
    rivals/chart_cgal_triangulations_rival.cpp rivals/meshes/cgal_rival.cpp APPEND PROPERTY COMPILE_OPTIONS
    -Wno-maybe-uninitialized -Wno-stringop-overflow)
endif()

# Their functions by the C signatures of `plumb fuzz`, each library's in one shared library (docs/field_report.md).
foreach(rival bullet ccd fcl qhull)
  add_library(field_${rival} SHARED field/${rival}.cpp)
  target_include_directories(field_${rival} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_features(field_${rival} PRIVATE cxx_std_20)
  target_link_libraries(field_${rival} PRIVATE plumb_own_flags plumb_test_flags rival_libraries)
endforeach()
