# What `cmake --install` puts where: libraries, headers, a CMake package, pkg-config files, the program with its manual
# pages and completions.  The tree may be moved afterwards: nothing in it knows its own place.
include(CMakePackageConfigHelpers)

install(TARGETS plumb_predicates plumb_batch plumb_classic plumb_degenerate plumb_plumb EXPORT plumb_targets)
if(PLUMB_BUILD_C)
  install(TARGETS plumb_c EXPORT plumb_targets)
endif()
set(headers_of_no_library PATTERN gpu_filter.hpp EXCLUDE)
if(PLUMB_BUILD_GPU)
  install(TARGETS plumb_gpu EXPORT plumb_targets)
  set(headers_of_no_library)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/plumb DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h" PATTERN predicates EXCLUDE ${headers_of_no_library})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/predicates/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumb/predicates
  FILES_MATCHING PATTERN "*.hpp")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(PLUMB_BUILD_PROGRAM)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/plumb.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/plumb)
  file(RELATIVE_PATH from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  foreach(program IN ITEMS plumb_tool_program plumb_lab_program)
    if(TARGET ${program})
      set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/${from_program}")
      install(TARGETS ${program})
    endif()
  endforeach()
  install(DIRECTORY ${PROJECT_BINARY_DIR}/share/man/ DESTINATION ${CMAKE_INSTALL_MANDIR} OPTIONAL)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/share/ DESTINATION ${CMAKE_INSTALL_DATAROOTDIR} OPTIONAL
    PATTERN man EXCLUDE)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/plumb)
install(EXPORT plumb_targets NAMESPACE plumb:: FILE plumb-targets.cmake DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/src/plumb-config.cmake.in
  ${PROJECT_BINARY_DIR}/plumb-config.cmake INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plumb-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plumb-config.cmake ${PROJECT_BINARY_DIR}/plumb-config-version.cmake
  DESTINATION ${package_dir})

# pkg-config: one file a library.  Paths are relative to the file's own folder.
set(pc_dir ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pc_libdir ${pc_dir} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH pc_includedir ${pc_dir} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
# plumb_write_pc(NAME DESCRIPTION LIBRARY REQUIRES NEEDS): needs are other people's libraries.  A static library brings
# nothing along, so what it needs goes on every link line; a shared one knows it already.
function(plumb_write_pc pc_name pc_description pc_library pc_requires pc_needs)
  string(STRIP "-L\${libdir} -l${pc_library}" pc_libs)
  set(pc_private_libs ${pc_needs})
  if(NOT BUILD_SHARED_LIBS)
    string(STRIP "${pc_libs} ${pc_needs}" pc_libs)
    set(pc_private_libs)
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/src/plumb.pc.in ${PROJECT_BINARY_DIR}/${pc_name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc_name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
set(needs_cxx20 " (C++20: compile with -std=c++20 or later)")
plumb_write_pc(plumb-predicates "Exact signs of geometric predicates${needs_cxx20}" plumb_predicates ""
  "${PLUMB_predicates_NEEDS}")
# For C's linkers, which know nothing of C++: its library comes last.
plumb_write_pc(plumb-classic "The classic C interface of robust predicates" plumb_classic ""
  "-lplumb_predicates ${PLUMB_predicates_NEEDS} -lstdc++ -lm")
plumb_write_pc(plumb-batch "Exact signs of many cases at once${needs_cxx20}" plumb_batch
  "plumb-predicates = ${PROJECT_VERSION}" "${PLUMB_batch_NEEDS}")
plumb_write_pc(plumb-degenerate "Hard inputs for geometric code${needs_cxx20}" plumb_degenerate
  "plumb-predicates = ${PROJECT_VERSION}" "")
plumb_write_pc(plumb "${PROJECT_DESCRIPTION}${needs_cxx20}" plumb
  "plumb-batch = ${PROJECT_VERSION}, plumb-degenerate = ${PROJECT_VERSION}, plumb-predicates = ${PROJECT_VERSION}"
  "${PLUMB_plumb_NEEDS}")
if(PLUMB_BUILD_C)  # shared whatever the others are, so that its needs are its own
  set(others_shared ${BUILD_SHARED_LIBS})
  set(BUILD_SHARED_LIBS ON)
  plumb_write_pc(plumb-c "Figures, meshes and signs for C and what calls C" plumb_c "" "")
  set(BUILD_SHARED_LIBS ${others_shared})
endif()
