# SPDX-License-Identifier: GPL-3.0-or-later
# refitlab_unite(TARGET SIZE FILE...) compiles the files together, in groups of at most so many, which are as large as each other: headers
# and what they instantiate are most of what a file costs, and are then paid for once. Files that have options of their own are compiled
# alone all the same.
option(REFITLAB_UNITY "Compile many files at a time, for a third of the processor time" ON)

function(refitlab_unite target size)
  if(NOT REFITLAB_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  list(LENGTH ARGN count)
  math(EXPR groups "(${count} + ${size} - 1) / ${size}")
  set(index 0)
  foreach(file ${ARGN})
    math(EXPR group "${index} * ${groups} / ${count}")
    math(EXPR index "${index} + 1")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()
