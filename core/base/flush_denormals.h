// While an object of this class lives, this thread's vector arithmetic treats denormal numbers as
// zero: decayed depths below 1e-308 m have no meaning, and computing with them is a hundred times
// slower.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace asperity {

/// Whether invalid operations and divisions by zero keep trapping, if traps were enabled. Vector
/// lanes compute both sides of every choice and keep one, so exceptions of the other side (a root
/// that does not exist, a division by a zero slope) have no meaning.
enum class Traps { AsBefore, None };

class FlushDenormals {
 public:
#if defined(__SSE2__)
  explicit FlushDenormals(Traps traps = Traps::AsBefore) : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | kFlushToZero | kDenormalsAreZero | (traps == Traps::None ? kNoTraps : 0));
  }
  ~FlushDenormals() {
    _mm_setcsr(before_);
  }
#else
  explicit FlushDenormals(Traps = Traps::AsBefore) {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040, kNoTraps = 0x1f80;
  unsigned before_;
#endif
};

}  // namespace asperity
