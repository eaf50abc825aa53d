# Do the examples of docs/examples work for who has nothing but an installed library?  Builds each against BUILD, as it
# is, installed; runs it in its own folder, and holds what it prints against its expected.txt.
# Needs SOURCE BUILD WORK COMPILER C_COMPILER GENERATOR CONFIG; FLAGS and LAUNCHER may be empty; WITHOUT names examples
# for which this machine lacks a package.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${words}${errors}")
  endif()
  set(words "${words}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --config ${CONFIG})
file(GLOB examples RELATIVE ${SOURCE}/docs/examples ${SOURCE}/docs/examples/*)
list(LENGTH examples many)
if(many LESS 6)
  message(FATAL_ERROR "docs/examples has ${many} examples: ${examples}")
endif()
foreach(example IN LISTS examples)
  if(example IN_LIST WITHOUT)
    message("skipped: ${example}")
    continue()
  endif()
  set(folder ${SOURCE}/docs/examples/${example})
  set(place ${WORK}/${example})
  run(${CMAKE_COMMAND} -S ${folder} -B ${place} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_C_COMPILER=${C_COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_C_FLAGS=${FLAGS}"
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_PREFIX_PATH=${WORK}/prefix)
  run(${CMAKE_COMMAND} --build ${place})
  run(${place}/${example})
  file(READ ${folder}/expected.txt expected)
  if(NOT words STREQUAL expected)
    message(FATAL_ERROR "${example} prints\n${words}\nand not\n${expected}")
  endif()
endforeach()
