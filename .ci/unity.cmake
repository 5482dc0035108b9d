# SPDX-License-Identifier: GPL-3.0-or-later
# refitlab_unite(TARGET SIZE FILE...) compiles the files of a folder together, so many at a time: headers and what they instantiate are
# most of what a file costs, and are then paid for once. Files that have options of their own are compiled alone all the same.
option(REFITLAB_UNITY "Compile several files of a folder at a time, for a third of the processor time" ON)

function(refitlab_unite target size)
  if(NOT REFITLAB_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(file ${ARGN})
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(GET folder FILENAME folder)
    if(NOT DEFINED count_${folder})
      set(count_${folder} 0)
    endif()
    math(EXPR group "${count_${folder}} / ${size}")
    math(EXPR count_${folder} "${count_${folder}} + 1")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
endfunction()
