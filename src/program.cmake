# plumb_add_program(NAME FOLDER OUTPUT timed [alone...]): the program OUTPUT of the rooms of src/FOLDER, as a library plumb_NAME
# that tests can link and a target plumb_NAME_program.  Rooms whose path the regex `timed` matches are optimized as the libraries
# are, for they are timed; what reads arguments and writes pages does so once a run.  What `alone` match is no part of a group.
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)

function(plumb_add_program name folder output timed_rooms)
  set(target plumb_${name})
  # All but main.cpp is a library of its own, so that the tests can link it.
  file(GLOB rooms CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*/*.cpp)
  list(FILTER rooms EXCLUDE REGEX "/program/main\\.cpp$")
  set(timed ${rooms})
  list(FILTER timed INCLUDE REGEX "/${folder}/(${timed_rooms})/")
  list(FILTER timed EXCLUDE REGEX "options\\.cpp$")
  set(untimed ${rooms})
  list(REMOVE_ITEM untimed ${timed})
  add_library(${target}_untimed OBJECT ${untimed})
  add_library(${target} STATIC ${timed} $<TARGET_OBJECTS:${target}_untimed>)
  target_compile_options(${target}_untimed PRIVATE -O1)
  plumb_group(${target} ${ARGN})
  plumb_group(${target}_untimed ${ARGN})
  # Each room has one parser, and all need the same: CLI11.
  set(parsers ${untimed})
  list(FILTER parsers INCLUDE REGEX "options\\.cpp$|/program/[a-z]+\\.cpp$")
  list(LENGTH parsers count)
  set(number 0)
  foreach(parser IN LISTS parsers)
    math(EXPR half "2 * ${number} / ${count}")
    set_source_files_properties(${parser} PROPERTIES UNITY_GROUP parsers_${half})
    math(EXPR number "${number} + 1")
  endforeach()

  foreach(part ${target} ${target}_untimed)
    target_include_directories(${part} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${part} PUBLIC plumb_plumb plumb_degenerate CLI11::CLI11 fmt::fmt nlohmann_json::nlohmann_json
      PRIVATE gmp PNG::PNG plumb_own_flags)
    if(PLUMB_SANITIZE)
      target_compile_options(${part} PRIVATE -O0)
    endif()
    if(PLUMB_SANITIZE MATCHES "^fuzzer-no-link,(.*)")  # no fuzz target asks the program
      set_target_properties(${part} PROPERTIES PLUMB_SANITIZE ${CMAKE_MATCH_1})
    endif()
    if(PLUMB_PRECOMPILE)
      target_precompile_headers(${part} PRIVATE <algorithm> <array> <cmath> <filesystem> <fmt/format.h> <functional> <map>
        <nlohmann/json.hpp> <optional> <span> <string> <vector>)
    endif()
  endforeach()

  add_executable(${target}_program ${PROJECT_SOURCE_DIR}/src/${folder}/program/main.cpp)
  set_target_properties(${target}_program PROPERTIES OUTPUT_NAME ${output})
  target_link_libraries(${target}_program PRIVATE ${target} plumb_own_flags)

  # Manual pages, and what shells complete by, as the program itself writes them.
  if(NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
    set(page ${PROJECT_BINARY_DIR}/share/man/man1/${output}.1)
    add_custom_command(OUTPUT ${page} COMMAND ${target}_program help --quiet --write-pages ${PROJECT_BINARY_DIR}/share
      DEPENDS ${target}_program VERBATIM)
    add_custom_target(${target}_pages ALL DEPENDS ${page})
  endif()
endfunction()
