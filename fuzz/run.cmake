# Runs one fuzz target for SECONDS and says how many inputs it took; what it said is shown only where it failed.
# Needs PROGRAM NAME SECONDS SEEDS PLACE (where what it finds goes: never into the seeds) and LIMITS.
file(MAKE_DIRECTORY ${PLACE}/found/${NAME})
string(REPLACE "|" ";" limits "${LIMITS}")
execute_process(COMMAND ${PROGRAM} -max_total_time=${SECONDS} -print_final_stats=1 ${limits}
  -artifact_prefix=${PLACE}/${NAME}- ${PLACE}/found/${NAME} ${SEEDS}
  RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE words)
file(WRITE ${PLACE}/${NAME}.log "${words}")
if(NOT status EQUAL 0)
  string(LENGTH "${words}" length)
  math(EXPR start "${length} - 8000")
  if(start LESS 0)
    set(start 0)
  endif()
  string(SUBSTRING "${words}" ${start} -1 end)
  message(FATAL_ERROR "${NAME} ended with ${status}:\n${end}")
endif()
string(REGEX MATCH "number_of_executed_units: ([0-9]+)" found "${words}")
message("fuzz/${NAME}: ${CMAKE_MATCH_1} inputs in ${SECONDS} s, no fault")
