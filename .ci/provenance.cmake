# SPDX-License-Identifier: GPL-3.0-or-later
# Writes refitlab_build.hpp (commit, dirty flag, compiler, flags) if it changed: run at every build.
execute_process(COMMAND git rev-parse --short=12 HEAD WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git status --porcelain --untracked-files=no WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE changes
                ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
endif()
set(dirty clean)
if(changes)
  set(dirty dirty)
endif()
set(text "#pragma once
#define REFITLAB_COMMIT \"${commit}\"
#define REFITLAB_DIRTY \"${dirty}\"
#define REFITLAB_COMPILER \"${COMPILER}\"
#define REFITLAB_FLAGS \"${FLAGS}\"
")
set(old "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} old)
endif()
if(NOT old STREQUAL text)
  file(WRITE ${HEADER} "${text}")
endif()
