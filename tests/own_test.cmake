# add_own_test(SOURCE): tests/<folder>/<name>_test.cpp, or one in a room of a folder, is a program of its own and a test named
# <folder>/<name>.  Who includes this calls precompile_test_headers(PLACE HEADERS...) first, for each folder of the build: its
# headers are its compiler's.

function(use_test_flags target level)
  target_link_libraries(${target} PRIVATE plumb_plumb plumb_degenerate plumb_own_flags plumb_test_flags GTest::gmock_main
    rapidcheck)
  target_compile_options(${target} PRIVATE ${level})
  # Addresses are watched in the tests too, arithmetic only in what they test: that takes a third off their compile time.
  # GCC's sanitized build (preset debug) watches all of it.
  if(PLUMB_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    set_target_properties(${target} PROPERTIES PLUMB_SANITIZE address)
  endif()
endfunction()
# What tests include of others is read once for each set of flags, not once a test.
function(precompile_test_headers place)
  set(PLUMB_TEST_HEADERS test_headers${place} PARENT_SCOPE)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp CONTENT "")
  foreach(headers IN LISTS ARGN)
    string(SUBSTRING ${headers} 0 3 level)
    set(target test_headers${place}${headers})
    add_library(${target} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
    use_test_flags(${target} ${level})
    # Named as tests name it: a full path would hinder what a compiler's cache shares between folders.
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_precompile_headers(${target} PRIVATE <gtest/gtest.h> <gmock/gmock.h> <gmpxx.h> <algorithm> <cmath> <filesystem>
      <fstream> <functional> <iostream> <map> <optional> <random> <set> <sstream> <string> <vector> <instances.hpp>)
    if(headers MATCHES "faces")
      target_precompile_headers(${target} PRIVATE <rapidcheck.h> <plumb/degenerate.hpp> <plumb/figure.hpp> <plumb/query.hpp>)
    endif()
  endforeach()
endfunction()

set(docs_sanitize)
if(PLUMB_SANITIZE)
  set(docs_sanitize -fsanitize=${PLUMB_SANITIZE})
endif()
# What of ours is in headers alone, these instantiate: they are compiled anew where they are to be watched.  What the others
# call is compiled in the libraries.
set(inline_tests "arith|certify|classic")
# Of those the libraries' compiler compiles what it also optimizes (tests/inline).
set(own_compiler_tests "certify|classic")
set(optimized_tests "^certify/[^o]|^figure/(hull/hull3|containment/contains_random)_|^query/(time_of_impact/continuous_contact_|overlap/round_|closest/(batch|cases|closest|pairs)_)")
# Of those these run as long without: what they compile is functions that are called a few times.
set(plain_tests "^certify/(broken_stages|worlds)_")

function(add_own_test source)
  string(REPLACE "_test.cpp" "" name ${source})
  string(REPLACE "/" "_" target ${name})
  set(object)
  if(PLUMB_TESTS_FROM AND NOT source MATCHES "^(${inline_tests})/")
    set(object ${PLUMB_TESTS_FROM}/tests/CMakeFiles/test_${target}.dir/${source}.o)
    set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
    add_executable(test_${target} ${object})
    set_target_properties(test_${target} PROPERTIES LINKER_LANGUAGE CXX)
  else()
    add_executable(test_${target} ${PROJECT_SOURCE_DIR}/tests/${source})
  endif()
  # Internals have tests of their own.
  target_include_directories(test_${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/src)
  set_target_properties(test_${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  # Compiling the tests takes far longer than running them.  What is tested is compiled in the library, optimized, or as
  # users compile it (agreement_*); to optimize the rest pays for few.
  if(source MATCHES "^certify/agreement/" AND NOT PLUMB_SANITIZE)
    set(level "")
  elseif(source MATCHES "${optimized_tests}" AND NOT source MATCHES "${plain_tests}" AND NOT PLUMB_SANITIZE)
    set(level -O1)
  else()
    set(level -O0)
  endif()
  use_test_flags(test_${target} "${level}")
  if(source MATCHES "^(surface|tool)/")  # they write packed files
    target_link_libraries(test_${target} PRIVATE ${PLUMB_ZLIB_LIBRARY})
  endif()
  if(source MATCHES "tool/clash_cli_test")  # reads what is written by another reader than ours
    target_link_libraries(test_${target} PRIVATE ${PLUMB_PUGIXML_LIBRARY})
  endif()
  if(object)
    set(level)
  endif()
  if(level STREQUAL "-O0" AND source MATCHES "^(figure|query|space)/")
    target_precompile_headers(test_${target} REUSE_FROM ${PLUMB_TEST_HEADERS}-O0-faces)
  elseif(level)
    target_precompile_headers(test_${target} REUSE_FROM ${PLUMB_TEST_HEADERS}${level})
  endif()
  if(TARGET plumb_oracle AND NOT source MATCHES "^(house|lab|tool)/")
    target_link_libraries(test_${target} PRIVATE plumb_oracle)
  endif()
  if(source MATCHES "^query/(overlap/|separation/|variant/|ray/hit_laws|time_of_impact/(contact_laws|rigid_))")
    target_link_libraries(test_${target} PRIVATE pair_questions)
  endif()
  target_link_libraries(test_${target} PRIVATE test_instances ${PLUMB_GMPXX_LIBRARY} ${PLUMB_GMP_LIBRARY})
  if(source MATCHES "^classic/")
    target_link_libraries(test_${target} PRIVATE plumb_classic)
  endif()
  if(source MATCHES "^c/")
    target_link_libraries(test_${target} PRIVATE plumb_c)
  endif()
  if(source MATCHES "^house/")
    target_link_libraries(test_${target} PRIVATE house_rules)
  endif()
  target_compile_definitions(test_${target} PRIVATE PLUMB_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    PLUMB_SHARED_DIR="${PROJECT_SOURCE_DIR}/../shared" $<$<BOOL:${PLUMB_LONG_TESTS}>:PLUMB_LONG_TESTS>)
  if(source STREQUAL "figure/basic/eigen_test.cpp")  # the one header that shows Eigen
    target_include_directories(test_${target} SYSTEM PRIVATE ${PLUMB_EIGEN_INCLUDE})
  endif()
  if(source MATCHES "^(lab|tool)/")  # the programs' parts, and the programs themselves as a user runs them
    string(REGEX MATCH "^[a-z]+" folder ${source})
    target_link_libraries(test_${target} PRIVATE plumb_${folder})
    target_compile_definitions(test_${target} PRIVATE PLUMB_PROGRAM="$<TARGET_FILE:plumb_tool_program>"
      $<$<TARGET_EXISTS:plumb_lab_program>:PLUMB_LAB_PROGRAM="$<TARGET_FILE:plumb_lab_program>">)
    add_dependencies(test_${target} plumb_tool_program)
    if(TARGET plumb_lab_program)
      add_dependencies(test_${target} plumb_lab_program)
    endif()
  endif()
  if(source MATCHES "^tool/(fuzz_|json_schema|out_of_memory)")
    target_compile_definitions(test_${target} PRIVATE PLUMB_FOREIGN="${CMAKE_CURRENT_BINARY_DIR}/foreign")
    add_dependencies(test_${target} ${foreign_modules})
  endif()
  if(source MATCHES "^docs/")  # what the documents show is compiled and run as a user would
    set(tests_compiler ${CMAKE_CXX_COMPILER})
    if(PLUMB_TESTS_COMPILER_FOUND)
      set(tests_compiler ${PLUMB_TESTS_COMPILER_FOUND})
    endif()
    target_link_libraries(test_${target} PRIVATE docs_pages)
    add_dependencies(test_${target} plumb_tool_program plumb_lab_program)
    target_compile_definitions(test_${target} PRIVATE PLUMB_PROGRAM="$<TARGET_FILE:plumb_tool_program>"
      PLUMB_LAB_PROGRAM="$<TARGET_FILE:plumb_lab_program>"
      PLUMB_BINARY_DIR="${PROJECT_BINARY_DIR}" PLUMB_CXX="${CMAKE_CXX_COMPILER}"
      PLUMB_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER}" PLUMB_UNITY="${PLUMB_UNITY_BUILD}"
      PLUMB_SANITIZE_FLAGS="${docs_sanitize}"
      PLUMB_COMPILE="${tests_compiler} -std=c++20 -O0 -ffp-contract=off $<$<BOOL:${PLUMB_LLD}>:-fuse-ld=lld> ${docs_sanitize}"
      PLUMB_INCLUDES="-I${PROJECT_SOURCE_DIR}/include"
      PLUMB_LIBRARY_GMP="${PLUMB_GMP_LIBRARY}"
      PLUMB_LIBRARIES="-Wl,-rpath,$<TARGET_FILE_DIR:plumb_plumb> $<TARGET_FILE:plumb_plumb> $<TARGET_FILE:plumb_degenerate> $<TARGET_FILE:plumb_batch> $<TARGET_FILE:plumb_predicates> ${PLUMB_plumb_NEEDS} $<TARGET_FILE:GTest::gtest>")
  endif()
  add_test(NAME ${name} COMMAND test_${target})
  if(object AND source MATCHES "^(lab|tool)/")
    set_tests_properties(${name} PROPERTIES ENVIRONMENT
      "PLUMB_TESTED_PROGRAM=$<TARGET_FILE:plumb_tool_program>;PLUMB_TESTED_LABORATORY=$<TARGET_FILE:plumb_lab_program>")
  endif()
  # Batches of figures, once more without vectors; the other batches go through all instruction sets by themselves.
  if(source MATCHES "^query/(closest/batch|overlap/batch|ray/mesh)_")
    set(batches)
    if(source MATCHES "^query/ray/mesh_")  # most of it asks no batch
      set(batches --gtest_filter=Batch.*:Watertight.*)
    endif()
    add_test(NAME ${name}_without_vectors COMMAND test_${target} ${batches})
    set_tests_properties(${name}_without_vectors PROPERTIES ENVIRONMENT PLUMB_INSTRUCTION_SET=none)
  endif()
endfunction()
