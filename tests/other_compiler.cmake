# Who includes this has the files of its folder of the build compiled by PLUMB_TESTS_COMPILER, where that is found: CMake has
# one compiler of each language, but a rule for each folder.
set(PLUMB_TESTS_COMPILER "" CACHE STRING
  "Compiles the tests of what the libraries compile, where GCC compiles the libraries; Clang takes a third of its time")
find_program(PLUMB_TESTS_COMPILER_FOUND NAMES ${PLUMB_TESTS_COMPILER})
mark_as_advanced(PLUMB_TESTS_COMPILER PLUMB_TESTS_COMPILER_FOUND)
if(PLUMB_TESTS_COMPILER_FOUND AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(REPLACE "<CMAKE_CXX_COMPILER>" "${PLUMB_TESTS_COMPILER_FOUND}" CMAKE_CXX_COMPILE_OBJECT "${CMAKE_CXX_COMPILE_OBJECT}")
  set(CMAKE_CXX_COMPILER_ID Clang)
  set(CMAKE_PCH_EXTENSION .pch)
  set(CMAKE_CXX_COMPILE_OPTIONS_CREATE_PCH -Xclang -emit-pch -Xclang -fno-pch-timestamp -Xclang -include -Xclang
    <PCH_HEADER> -x c++-header)
  set(CMAKE_CXX_COMPILE_OPTIONS_USE_PCH -Xclang -include-pch -Xclang <PCH_FILE> -Xclang -include -Xclang <PCH_HEADER>)
  set(CMAKE_CXX_COMPILE_OPTIONS_INSTANTIATE_TEMPLATES_PCH -fpch-instantiate-templates)
endif()
