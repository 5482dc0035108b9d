# SPDX-License-Identifier: GPL-3.0-or-later
# Fails if the OBJECTS compiled for a wider TARGET define a symbol that other code could be linked with in place of its own
# (algorithms/runtime/packs/targets.hpp): all that they may define lies in the target's namespace. (DW.ref.* are
# pointers to the handlers of exceptions, the same everywhere.)
execute_process(COMMAND ${NM} --defined-only --extern-only --format=posix ${OBJECTS} OUTPUT_VARIABLE symbols
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n ]+ [A-Zuvw] " defined "${symbols}")
if(NOT defined)
  message(FATAL_ERROR "no symbols found in the kernels for ${TARGET}: ${OBJECTS}")
endif()
string(LENGTH ${TARGET} length)
foreach(symbol ${defined})
  if(NOT symbol MATCHES "^_ZN8refitlab${length}${TARGET}" AND NOT symbol MATCHES "^DW[.]ref[.]")
    message(FATAL_ERROR "a kernel for ${TARGET} defines ${symbol}: inline functions of common types must be inlined there")
  endif()
endforeach()
