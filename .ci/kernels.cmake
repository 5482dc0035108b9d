# SPDX-License-Identifier: GPL-3.0-or-later
# refitlab_kernels(TARGET): how the SIMD kernels (*_kernel.cpp) of a library are compiled, and once more for each wider
# target (algorithms/runtime/packs/targets.hpp).
function(refitlab_kernels library)
  # Their loops over the joints of a set are worth unrolling, which -O2 does not do.
  file(GLOB_RECURSE kernels CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/runtime/*_kernel.cpp)
  set_source_files_properties(${kernels} PROPERTIES COMPILE_OPTIONS -O3)
  # Products and sums may be fused where nothing but the size of what rounding loses is counted on: fused ones lose less.
  foreach(kernel batch/refit_kernel batch/float_skin_kernel collide/cluster_pair_kernel collide/motion_bound_kernel
                 collide/motion_bound_piece_kernel)
    set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/runtime/${kernel}.cpp PROPERTIES
                                COMPILE_OPTIONS "-O3;-ffp-contract=fast")
  endforeach()
  if(NOT (REFITLAB_WIDE_TARGETS AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64"))
    return()
  endif()
  target_compile_definitions(${library} PUBLIC REFITLAB_X86_TARGETS)
  foreach(row avx2:x86-64-v3 avx512:x86-64-v4)
    string(REPLACE ":" ";" row ${row})
    list(GET row 0 target)
    list(GET row 1 architecture)
    add_library(refitlab_${target} OBJECT ${kernels})
    target_compile_definitions(refitlab_${target} PRIVATE REFITLAB_TARGET=${target} EIGEN_MAX_ALIGN_BYTES=16)
    target_compile_options(refitlab_${target} PRIVATE -march=${architecture})
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
      target_compile_options(refitlab_${target} PRIVATE -Wno-maybe-uninitialized)  # in its own intrinsics (GCC bug 105593)
    else()
      # Clang's flatten inlines what an entry point calls, and leaves what that calls to these limits.
      target_compile_options(refitlab_${target} PRIVATE "SHELL:-mllvm -inline-threshold=100000"
                             "SHELL:-mllvm -locally-hot-callsite-threshold=100000" -Wno-pass-failed)
    endif()
    target_link_libraries(refitlab_${target} PRIVATE refitlab::lemmas refitlab_flags)
    target_sources(${library} PRIVATE $<TARGET_OBJECTS:refitlab_${target}>)
    add_custom_command(TARGET ${library} POST_BUILD VERBATIM
                       COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DTARGET=${target}
                               "-DOBJECTS=$<JOIN:$<TARGET_OBJECTS:refitlab_${target}>,$<SEMICOLON>>"
                               -P ${PROJECT_SOURCE_DIR}/.ci/lone_kernels.cmake)
  endforeach()
endfunction()
