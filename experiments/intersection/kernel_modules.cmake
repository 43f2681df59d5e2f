# The study's formulas compiled in other ways than the program, each a module of its own that is loaded on demand: functions of
# templates would otherwise be shared between files whose processors or flags differ.
set(kernel_source ${CMAKE_CURRENT_SOURCE_DIR}/kernel_module.cpp)

if(RAYSWEEP_SANITIZE)
  target_compile_definitions(intersection PRIVATE RAYSWEEP_CALLS_STAY)
endif()

# They take as long to compile as a third of the rest.
option(RAYSWEEP_KERNEL_MODULES "Build the study's formulas in lanes, with contraction and by the other compiler" ON)
if(NOT RAYSWEEP_KERNEL_MODULES)
  file(GLOB left_behind ${RAYSWEEP_MODULE_DIR}/kernels_*.so)
  if(left_behind)
    file(REMOVE ${left_behind})
  endif()
  return()
endif()

# Linked last, since what is linked comes behind a target's own options: it takes back what all else is compiled with.
add_library(raysweep_contraction INTERFACE)
target_compile_options(raysweep_contraction INTERFACE -ffp-contract=fast)

# How the kernels of `target` are compiled.
function(raysweep_kernel_flags target isa lanes contracted)
  target_link_libraries(${target} PRIVATE raysweep_flags PkgConfig::HWY $<$<BOOL:${contracted}>:raysweep_contraction>)
  target_compile_definitions(${target} PRIVATE
    RAYSWEEP_KERNELS_NAME="${isa}" RAYSWEEP_KERNELS_LANES=${lanes} RAYSWEEP_KERNELS_CONTRACTED=${contracted})
  target_compile_options(${target} PRIVATE ${ARGN} -fvisibility=hidden)
  if(RAYSWEEP_SANITIZE)
    target_compile_definitions(${target} PRIVATE RAYSWEEP_CALLS_STAY)
    target_compile_options(${target} PRIVATE -Og)
  endif()
endfunction()

# raysweep_kernels(NAME isa lanes contracted FLAGS…): a module by this project's own compiler.
function(raysweep_kernels name isa lanes contracted)
  add_library(kernels_${name} MODULE ${kernel_source})
  raysweep_kernel_flags(kernels_${name} ${isa} ${lanes} ${contracted} ${ARGN})
  set_target_properties(kernels_${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${RAYSWEEP_MODULE_DIR})
  add_dependencies(raysweep kernels_${name})
endfunction()

# raysweep_combined_kernels(NAME isa lanes FLAGS…): the module of all that the factors of the tracer's methods can be at once, the
# methods beside each other.
function(raysweep_combined_kernels name isa lanes)
  add_library(kernels_${name} MODULE combined_module.cpp)
  raysweep_kernel_flags(kernels_${name} ${isa} ${lanes} 0 ${ARGN})
  foreach(method MollerTrumbore Morozov WoopWatertight)
    add_library(kernels_${name}_${method} OBJECT combined_kernels.cpp)
    set_target_properties(kernels_${name}_${method} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    raysweep_kernel_flags(kernels_${name}_${method} ${isa} ${lanes} 0 ${ARGN})
    target_compile_definitions(kernels_${name}_${method} PRIVATE RAYSWEEP_METHOD=${method})
    target_link_libraries(kernels_${name} PRIVATE kernels_${name}_${method})
  endforeach()
  set_target_properties(kernels_${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${RAYSWEEP_MODULE_DIR})
  add_dependencies(raysweep kernels_${name})
endfunction()

# Under sanitizers one module is enough, compiled as it goes quickest.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(avx2 -march=x86-64-v3 -maes -mpclmul)
  if(NOT RAYSWEEP_SANITIZE)
    raysweep_kernels(avx512 avx512 1 0 -march=x86-64-v4 -maes -mpclmul)
    raysweep_kernels(sse4 sse4 1 0 -march=x86-64-v2 -maes -mpclmul)
    raysweep_kernels(contracted avx2 0 1 ${avx2})
  endif()
  raysweep_kernels(avx2 avx2 1 0 ${avx2})
else()
  raysweep_kernels(neon neon 1 0)
  raysweep_kernels(contracted baseline 0 1)
endif()

# Some thousand kernels.
option(RAYSWEEP_COMBINED_KERNELS "Build the tracer's methods with all factors changed at once, too: some minutes" OFF)
if(RAYSWEEP_COMBINED_KERNELS)
  raysweep_combined_kernels(combined baseline 0)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    raysweep_combined_kernels(combined_lanes avx2 1 ${avx2})
  else()
    raysweep_combined_kernels(combined_lanes neon 1)
  endif()
endif()

# By the other compiler, without sanitizers: compilers do not share them.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(other ${RAYSWEEP_GXX})
else()
  set(other ${RAYSWEEP_CLANGXX})
endif()
set(module ${RAYSWEEP_MODULE_DIR}/kernels_other_compiler.so)
if(other AND NOT CMAKE_CROSSCOMPILING)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS_${build_type}}")
  get_target_property(own_flags raysweep_flags INTERFACE_COMPILE_OPTIONS)
  file(GLOB headers CONFIGURE_DEPENDS *.h ${PROJECT_SOURCE_DIR}/tracer/intersect/*.h ${PROJECT_SOURCE_DIR}/tracer/math/*.h)
  add_custom_command(OUTPUT ${module}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${RAYSWEEP_MODULE_DIR}
    COMMAND ${other} -std=c++20 ${flags} ${own_flags} -fvisibility=hidden -fPIC -shared -I${PROJECT_SOURCE_DIR}
            -DRAYSWEEP_KERNELS_NAME="baseline" -DRAYSWEEP_KERNELS_LANES=0 -DRAYSWEEP_KERNELS_CONTRACTED=0
            ${kernel_source} -o ${module}
    DEPENDS ${kernel_source} ${headers}
    COMMENT "Building ${module} by ${other}" VERBATIM)
  add_custom_target(kernels_other_compiler ALL DEPENDS ${module})
  add_dependencies(raysweep kernels_other_compiler)
endif()

# What an earlier configuration has left behind.
foreach(name avx512 avx2 sse4 neon contracted combined combined_lanes other_compiler)
  if(NOT TARGET kernels_${name})
    file(REMOVE ${RAYSWEEP_MODULE_DIR}/kernels_${name}.so)
  endif()
endforeach()
