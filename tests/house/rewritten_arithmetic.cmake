# Does check_environment() see each option that lets the compiler rewrite arithmetic and that its preprocessor keeps to
# itself?  SOURCE, compiled by COMPILER with INCLUDES, must end with 1 for these and with 0 for harmless ones.
function(must_end_with expected)
  execute_process(COMMAND ${COMPILER} -std=c++20 -O2 -ffp-contract=off ${ARGN} -I${INCLUDES} ${SOURCE} -o ${PROGRAM}
    RESULT_VARIABLE status ERROR_VARIABLE words)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: does not compile:\n${words}")
  endif()
  execute_process(COMMAND ${PROGRAM} RESULT_VARIABLE status)
  if(NOT status EQUAL ${expected})
    message(FATAL_ERROR "${ARGN}: ends with ${status}, not with ${expected}")
  endif()
endfunction()

must_end_with(0)
must_end_with(0 -frounding-math)
must_end_with(0 -fno-trapping-math)
must_end_with(0 -fno-math-errno)
must_end_with(1 -fassociative-math -fno-signed-zeros -fno-trapping-math)
must_end_with(1 -funsafe-math-optimizations)
must_end_with(1 -freciprocal-math)
must_end_with(1 -fno-signed-zeros)
must_end_with(1 -fno-honor-nans)
must_end_with(1 -fno-honor-infinities)
