# cmake -DSOURCE_DIR=… -DHEADER=… -P git_state.cmake: writes the state of the sources into a header, if it has changed. Sources
# without git, or in a folder of another repository, are "unknown".
set(commit unknown)
set(changed unknown)
find_package(Git QUIET)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --show-prefix HEAD WORKING_DIRECTORY ${SOURCE_DIR}
                  OUTPUT_VARIABLE answer RESULT_VARIABLE failed ERROR_QUIET)
  # First line: the way down from the repository's top, empty at the top; second: the commit.
  if(NOT failed AND answer MATCHES "^\n([0-9a-f]+)\n$")
    set(commit ${CMAKE_MATCH_1})
    # Without locks: another git may be at work. What git does not know is not part of the build, or CMakeLists.txt differs.
    execute_process(COMMAND ${GIT_EXECUTABLE} --no-optional-locks status --porcelain --untracked-files=no
                    WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE answer RESULT_VARIABLE failed ERROR_QUIET)
    if(NOT failed)
      string(COMPARE NOTEQUAL "${answer}" "" differs)
      set(changed no)
      if(differs)
        set(changed yes)
      endif()
    endif()
  endif()
endif()
set(text "// Written at every build, if it has changed.
#pragma once

namespace raysweep {

inline constexpr const char* git_commit = \"${commit}\";
inline constexpr const char* git_changed = \"${changed}\";

}  // namespace raysweep
")
set(before "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} before)
endif()
if(NOT text STREQUAL before)
  file(WRITE ${HEADER} "${text}")
endif()
