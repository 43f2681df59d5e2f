#include "tracer/huge_pages.h"

#include <sys/mman.h>
#include <unistd.h>

#include <memory>

namespace raysweep {

void prefer_huge_pages(void* memory, size_t bytes) {
  const auto page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
  size_t space = bytes;
  if (!std::align(page, page, memory, space)) return;
  (void)madvise(memory, space / page * page, MADV_HUGEPAGE);  // where there are none, it fails
}

}  // namespace raysweep
