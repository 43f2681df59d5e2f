// Denormal numbers as zero, for as long as an object lives.
#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace raysweep {

/// Embree's manual asks for it in every thread that traces ("MXCSR control and status register"); on other
/// processors than x86 it asks for nothing. What was set before is set again at the end: our own tracer
/// counts on denormals.
class FlushDenormals {
 public:
#ifdef __SSE__
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_to_zero | denormals_are_zero); }
  ~FlushDenormals() { _mm_setcsr(before_); }
#else
  FlushDenormals() {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#ifdef __SSE__
  // Intel's manual, volume 1, 10.2.3: bits of MXCSR.
  static constexpr unsigned flush_to_zero = 1u << 15, denormals_are_zero = 1u << 6;
  unsigned before_;
#endif
};

}  // namespace raysweep
