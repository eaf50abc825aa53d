# How much does a face bring along?  Lines after the preprocessor, which no clock disturbs; a second of GCC's front end is
# some 150,000 of them.
#   COMPILER, INCLUDES (separated by |), LIMITS: face=lines, separated by |
string(REPLACE "|" ";-I" includes "-I${INCLUDES}")
string(REPLACE "|" ";" limits "${LIMITS}")
foreach(limit IN LISTS limits)
  string(REGEX MATCH "^(.*)=(.*)$" found ${limit})
  set(face ${CMAKE_MATCH_1})
  set(most ${CMAKE_MATCH_2})
  execute_process(COMMAND ${COMPILER} -std=c++20 ${includes} -E -include ${face} -x c++ /dev/null
    COMMAND wc -l OUTPUT_VARIABLE lines OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "${face}: ${lines} lines, at most ${most}")
  if(lines LESS 1000 OR lines GREATER most)
    message(SEND_ERROR "${face} has ${lines} lines; include less, or say here why it takes more")
  endif()
endforeach()
