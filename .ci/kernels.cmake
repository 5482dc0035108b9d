# SPDX-License-Identifier: GPL-3.0-or-later
# refitlab_kernels(TARGET): how the SIMD kernels (*_kernel.cpp) of a library are compiled, and once more for each wider
# target (algorithms/runtime/packs/targets.hpp).
function(refitlab_kernels library)
  # Their loops over the joints of a set are worth unrolling, which -O2 does not do.
  file(GLOB_RECURSE kernels CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/runtime/*_kernel.cpp)
  set_source_files_properties(${kernels} PROPERTIES COMPILE_OPTIONS -O3)
  # Products and sums may be fused where nothing but the size of what rounding loses is counted on: fused ones lose less.
  foreach(kernel batch/refit_kernel batch/float_skin_kernel collide/cluster_pair_kernel collide/motion_bound_kernel
                 collide/motion_bound_piece_kernel collide/pose_change_kernel)
    set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/runtime/${kernel}.cpp PROPERTIES
                                COMPILE_OPTIONS "-O3;-ffp-contract=fast")
  endforeach()
  if(NOT (REFITLAB_WIDE_TARGETS AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64"))
    return()
  endif()
  target_compile_definitions(${library} PUBLIC REFITLAB_X86_TARGETS)
  refitlab_wide_kernels(${library} refitlab ${kernels})
endfunction()

# refitlab_wide_kernels(TARGET NAME FILE...): the kernels once more for each wider target, as object libraries that are named NAME_avx2
# and NAME_avx512, and that several targets may share.
function(refitlab_wide_kernels user name)
  foreach(row avx2:x86-64-v3 avx512:x86-64-v4)
    string(REPLACE ":" ";" row ${row})
    list(GET row 0 target)
    list(GET row 1 architecture)
    if(NOT TARGET ${name}_${target})
      add_library(${name}_${target} OBJECT ${ARGN})
      target_compile_definitions(${name}_${target} PRIVATE REFITLAB_TARGET=${target} EIGEN_MAX_ALIGN_BYTES=16)
      target_compile_options(${name}_${target} PRIVATE -march=${architecture})
      if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        target_compile_options(${name}_${target} PRIVATE -Wno-maybe-uninitialized)  # in its own intrinsics (GCC bug 105593)
        # GCC copies packs of 256 bits in halves otherwise, and a pack that was stored in halves is loaded late.
        if(target STREQUAL avx2 AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12)
          target_compile_options(${name}_${target} PRIVATE -mmove-max=256 -mstore-max=256)
        endif()
      else()
        # Clang's flatten inlines what an entry point calls, and leaves what that calls to these limits.
        target_compile_options(${name}_${target} PRIVATE "SHELL:-mllvm -inline-threshold=100000"
                               "SHELL:-mllvm -locally-hot-callsite-threshold=100000" -Wno-pass-failed)
      endif()
      target_link_libraries(${name}_${target} PRIVATE refitlab::lemmas refitlab_flags)
    endif()
    target_sources(${user} PRIVATE $<TARGET_OBJECTS:${name}_${target}>)
    add_custom_command(TARGET ${user} POST_BUILD VERBATIM
                       COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DTARGET=${target}
                               "-DOBJECTS=$<JOIN:$<TARGET_OBJECTS:${name}_${target}>,$<SEMICOLON>>"
                               -P ${PROJECT_SOURCE_DIR}/.ci/lone_kernels.cmake)
  endforeach()
endfunction()

# refitlab_engine_kernels(TARGET): those of the experiment on what engines ship, for the programs that are made of it.
function(refitlab_engine_kernels user)
  set(kernel ${PROJECT_SOURCE_DIR}/experiments/engines/joint_kernel.cpp)
  set_source_files_properties(${kernel} PROPERTIES COMPILE_OPTIONS "-O3;-ffp-contract=fast")
  if(REFITLAB_WIDE_TARGETS AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    refitlab_wide_kernels(${user} refitlab_engine ${kernel})
  endif()
endfunction()
