// The compiler of the file that reads this.
#pragma once

#include <string_view>

namespace raysweep {

#if defined(__clang__)
inline constexpr std::string_view compiler_name = "clang " __clang_version__;
#else
inline constexpr std::string_view compiler_name = "gcc " __VERSION__;
#endif

}  // namespace raysweep
