# Can people use the library?  Builds and runs tests/consumer in one WAY:
#   installed         BUILD, as it is, installed, then moved, then found by find_package; its program runs there, and
#                     under valgrind where there is one
#   examples          the same for docs/examples, each of which prints its expected.txt; but for those WITHOUT names, for
#                     which this machine lacks a package
#   add_subdirectory  the sources beside the consumer's; installs what it built to WORK/prefix_LINKAGE
#   find_package      from WORK/prefix_LINKAGE
#   pkg_config        from WORK/prefix_LINKAGE, by the compiler alone
# Needs SOURCE BUILD WORK COMPILER C_COMPILER GENERATOR PKG_CONFIG LIBDIR CONFIG PROGRAM; FLAGS, LAUNCHER, UNITY and
# WITHOUT may be empty.
cmake_minimum_required(VERSION 3.25)
set(consumer ${SOURCE}/tests/consumer)
set(place ${WORK}/${WAY}${LINKAGE})
if(WAY STREQUAL "add_subdirectory")
  set(place ${WORK}/${WAY})
endif()
set(prefix ${WORK}/prefix_${LINKAGE})
if(NOT LINKAGE)
  set(prefix ${place}/moved)
endif()
file(REMOVE_RECURSE ${place})
file(MAKE_DIRECTORY ${place})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${words}${errors}")
  endif()
  set(words "${words}" PARENT_SCOPE)
endfunction()

# must_print(EXPECTED PROGRAM...)
function(must_print expected)
  foreach(program IN LISTS ARGN)
    run(${program})
    if(NOT words STREQUAL expected)
      message(FATAL_ERROR "${program} prints\n${words}\nand not\n${expected}")
    endif()
  endforeach()
endfunction()

function(build_project folder)
  run(${CMAKE_COMMAND} -S ${folder} -B ${place}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -DCMAKE_UNITY_BUILD=${UNITY} ${ARGN})
  run(${CMAKE_COMMAND} --build ${place}/build)
endfunction()

function(build_consumer)
  build_project(${consumer} ${ARGN})
  must_print("as expected\n" ${place}/build/consumer ${place}/build/signs_only ${place}/build/classic)
endfunction()

# As a package's user gets it: installed, then moved.
function(install_build)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${place}/first --config ${CONFIG})
  file(RENAME ${place}/first ${prefix})
endfunction()

function(must_exist)
  foreach(path IN LISTS ARGN)
    if(NOT EXISTS ${prefix}/${path})
      message(FATAL_ERROR "${prefix} lacks ${path}")
    endif()
  endforeach()
endfunction()

if(WAY STREQUAL "installed")
  install_build()
  must_exist(include/plumb/predicates.hpp include/plumb/classic.h include/plumb/predicates/orient.hpp
    ${LIBDIR}/cmake/plumb/plumb-config.cmake)
  file(GLOB_RECURSE installed RELATIVE ${prefix} ${prefix}/*)
  foreach(path IN LISTS installed)
    if(path MATCHES "_test|_fuzz|_bench|oracle|house|tool")
      message(FATAL_ERROR "${path} is not for users")
    endif()
    if(path MATCHES "\\.(cmake|pc)$")
      file(READ ${prefix}/${path} words)
      string(FIND "${words}" ${SOURCE} source_named)
      if(NOT source_named EQUAL -1 OR words MATCHES "-Werror|-Wall|plumb_own_flags")
        message(FATAL_ERROR "${path} names our tree or our flags:\n${words}")
      endif()
    endif()
  endforeach()
  if(PROGRAM)
    run(${prefix}/bin/plumb --version)
  endif()
  build_consumer(-DCMAKE_PREFIX_PATH=${prefix})
  find_program(valgrind valgrind)
  if(valgrind AND NOT FLAGS)  # sanitizers and valgrind exclude each other
    run(${valgrind} --quiet --error-exitcode=1 ${place}/build/consumer)
    if(NOT words STREQUAL "as expected\n")
      message(FATAL_ERROR "under valgrind the consumer prints\n${words}")
    endif()
  endif()

elseif(WAY STREQUAL "examples")
  set(examples ${SOURCE}/docs/examples)
  install_build()
  build_project(${examples} -DCMAKE_PREFIX_PATH=${prefix})
  file(GLOB expected RELATIVE ${examples} ${examples}/*/expected.txt)
  list(LENGTH expected many)
  if(many LESS 6)
    message(FATAL_ERROR "docs/examples has ${many} examples: ${expected}")
  endif()
  foreach(path IN LISTS expected)
    cmake_path(GET path PARENT_PATH example)
    if(example IN_LIST WITHOUT)
      message("skipped: ${example}")
      continue()
    endif()
    file(READ ${examples}/${path} words)
    must_print("${words}" ${place}/build/${example})
  endforeach()

elseif(WAY STREQUAL "add_subdirectory")
  set(build_shared OFF)
  if(LINKAGE STREQUAL "shared")
    set(build_shared ON)
  endif()
  # The smaller libraries are compiled as the consumer's flags have it; the largest is taken from BUILD where its commands
  # are the same.
  file(WRITE ${place}/launcher
    "#!/bin/sh\nexec bash ${CMAKE_CURRENT_LIST_DIR}/take_over.sh '${BUILD}' plumb '${LAUNCHER}' \"$@\"\n")
  file(CHMOD ${place}/launcher PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  set(LAUNCHER ${place}/launcher)
  build_consumer(-DPLUMB_BESIDE=${SOURCE} -DBUILD_SHARED_LIBS=${build_shared} -DPLUMB_INSTALL=ON)
  file(REMOVE_RECURSE ${prefix})
  run(${CMAKE_COMMAND} --install ${place}/build --prefix ${prefix})

elseif(WAY STREQUAL "find_package")
  build_consumer(-DCMAKE_PREFIX_PATH=${prefix})

elseif(WAY STREQUAL "pkg_config")
  set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
  set(ENV{LD_LIBRARY_PATH} ${prefix}/${LIBDIR})
  foreach(source_packages "consumer.cpp plumb plumb-degenerate" "signs_only.cpp plumb-predicates"
      "classic.c plumb-classic")
    separate_arguments(packages UNIX_COMMAND ${source_packages})
    list(POP_FRONT packages source)
    run(${PKG_CONFIG} --cflags --libs ${packages})
    separate_arguments(flags UNIX_COMMAND ${words})
    set(compile ${COMPILER} -std=c++20)
    if(source MATCHES "[.]c$")
      set(compile ${C_COMPILER} -std=c99)
    endif()
    cmake_path(GET source STEM program)
    run(${compile} ${FLAGS} ${consumer}/${source} ${flags} -o ${place}/${program})
    must_print("as expected\n" ${place}/${program})
  endforeach()
endif()

# Static libraries are static, and shared ones carry their version.
if(LINKAGE)
  file(GLOB versioned ${prefix}/${LIBDIR}/libplumb_predicates.so.*.*.*)
  file(GLOB archived ${prefix}/${LIBDIR}/libplumb_predicates.a)
  if((LINKAGE STREQUAL "shared" AND (NOT versioned OR archived)) OR (LINKAGE STREQUAL "static" AND NOT archived))
    message(FATAL_ERROR "${prefix}/${LIBDIR} does not hold ${LINKAGE} libraries")
  endif()
endif()
