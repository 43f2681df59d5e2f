# Runtimes as modules, loaded on demand: a missing package removes a module and nothing else, and what an earlier
# configuration has left behind. What a module needs of this library is compiled into it.
set(module_sources binding.cpp library_of.cpp scheduler.cpp work.cpp worker_log.cpp)

# A module by this project's own compiler.
function(raysweep_add_module runtime source)
  add_library(raysweep_${runtime} MODULE ${source} ${module_sources})
  target_link_libraries(raysweep_${runtime} PRIVATE raysweep_flags Threads::Threads ${CMAKE_DL_LIBS} ${ARGN})
  set_target_properties(raysweep_${runtime} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${RAYSWEEP_MODULE_DIR})
  if(RAYSWEEP_SANITIZE MATCHES thread) # it would see half of what a runtime does: work.cpp tells the rest
    target_compile_options(raysweep_${runtime} PRIVATE -fno-sanitize=thread)
  endif()
endfunction()

# The OpenMP module by another compiler, since a compiler's OpenMP code is made for one runtime. Without sanitizers:
# compilers do not share them.
function(raysweep_add_foreign_openmp runtime compiler flag)
  file(GLOB headers CONFIGURE_DEPENDS *.h openmp/*.h)
  list(TRANSFORM module_sources PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE sources)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS_${build_type}}")
  if(RAYSWEEP_SANITIZE MATCHES thread)
    list(APPEND flags -DRAYSWEEP_TSAN)
  endif()
  if(CMAKE_COMPILE_WARNING_AS_ERROR)
    list(APPEND flags -Werror)
  endif()
  set(module ${RAYSWEEP_MODULE_DIR}/raysweep_${runtime}.so)
  add_custom_command(OUTPUT ${module}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${RAYSWEEP_MODULE_DIR}
    COMMAND ${compiler} -std=c++20 ${flags} -Wall -Wextra ${flag} -fPIC -shared -I${PROJECT_SOURCE_DIR}
            ${CMAKE_CURRENT_SOURCE_DIR}/openmp/module.cpp ${sources} -ldl -o ${module}
    DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/openmp/module.cpp ${sources} ${headers}
    COMMENT "Building ${module} by ${compiler}" VERBATIM)
  add_custom_target(raysweep_${runtime} ALL DEPENDS ${module})
endfunction()

# Whether `compiler` can build the module, in `found`.
function(raysweep_try_openmp compiler flag found)
  set(${found} OFF PARENT_SCOPE)
  if(NOT compiler)
    return()
  endif()
  set(probe ${CMAKE_CURRENT_BINARY_DIR}/openmp_probe)
  file(WRITE ${probe}.cpp "#include <omp.h>\n#include <functional>\nextern \"C\" void GOMP_loop_end_nowait();\n"
    "int probe() { GOMP_loop_end_nowait(); return omp_get_num_threads(); }\n")
  execute_process(COMMAND ${compiler} -std=c++20 ${flag} -fPIC -shared -Wl,--no-undefined ${probe}.cpp -o ${probe}.so
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(NOT failed)
    set(${found} ON PARENT_SCOPE)
  endif()
endfunction()

find_program(RAYSWEEP_GXX NAMES g++)
find_program(RAYSWEEP_CLANGXX NAMES clang++ clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14)
foreach(pair "libgomp;GNU;RAYSWEEP_GXX;-fopenmp" "libomp;Clang;RAYSWEEP_CLANGXX;-fopenmp=libomp")
  list(GET pair 0 runtime)
  list(GET pair 1 id)
  list(GET pair 2 compiler)
  list(GET pair 3 flag)
  set(found OFF)
  if(CMAKE_CXX_COMPILER_ID STREQUAL id AND OpenMP_CXX_FOUND)
    raysweep_add_module(${runtime} openmp/module.cpp OpenMP::OpenMP_CXX)
    set(found ON)
  elseif(NOT CMAKE_CXX_COMPILER_ID STREQUAL id AND NOT CMAKE_DISABLE_FIND_PACKAGE_OpenMP)
    raysweep_try_openmp("${${compiler}}" ${flag} found)
    if(found)
      raysweep_add_foreign_openmp(${runtime} ${${compiler}} ${flag})
    endif()
  endif()
  set(RAYSWEEP_HAS_${runtime} ${found} PARENT_SCOPE)
endforeach()
if(TBB_FOUND)
  raysweep_add_module(tbb tbb/module.cpp TBB::tbb)
endif()
set(RAYSWEEP_HAS_tbb ${TBB_FOUND} PARENT_SCOPE)

foreach(runtime libgomp libomp tbb)
  if(NOT TARGET raysweep_${runtime})
    file(REMOVE ${RAYSWEEP_MODULE_DIR}/raysweep_${runtime}.so)
  endif()
endforeach()
