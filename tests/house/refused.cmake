# Is SOURCE refused by the compiler, and for the reason it names?  Its comments say how:
#   // refused: REGEX    what the compiler must say
#   // flags: FLAGS      flags for the refused form alone
# The same file compiled with -DMENDED must be accepted, so that it is refused for that reason and no other.
file(STRINGS ${SOURCE} reason_line REGEX "^// refused: ")
file(STRINGS ${SOURCE} flags_line REGEX "^// flags: ")
string(REGEX REPLACE "^// refused: " "" reason "${reason_line}")
string(REGEX REPLACE "^// flags: " "" flags "${flags_line}")
if(NOT reason)
  message(FATAL_ERROR "${SOURCE}: no line '// refused: REGEX'")
endif()
string(REPLACE "|" ";-I" includes "-I${INCLUDES}")
separate_arguments(flags)

set(compile ${COMPILER} -std=c++20 -ffp-contract=off -fsyntax-only -Wall -Wextra -Werror ${includes} ${SOURCE})
execute_process(COMMAND ${compile} -DMENDED RESULT_VARIABLE status ERROR_VARIABLE words)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the mended form must compile, but:\n${words}")
endif()
execute_process(COMMAND ${compile} ${flags} RESULT_VARIABLE status ERROR_VARIABLE words)
if(status EQUAL 0)
  message(FATAL_ERROR "compiles, but must not")
endif()
if(NOT words MATCHES "${reason}")
  message(FATAL_ERROR "refused, but the compiler does not say '${reason}':\n${words}")
endif()
