// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef countAllocations_h
#define countAllocations_h

#include <cstdlib>
#include <new>

/*!
  \file countAllocations.h
  Replaces the global operators new and delete with ones that count. For the one source file of a test program.
*/

namespace countAllocations {
static std::size_t allocations = 0; //!< Since the program started.

inline void *allocate(std::size_t size)
{
  ++allocations;
  void *memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}
} // namespace countAllocations

// Counts what the library allocates, too.
void *operator new(std::size_t size)
{
  return countAllocations::allocate(size);
}

void *operator new[](std::size_t size)
{
  return countAllocations::allocate(size);
}

// Standard algorithms ask for temporary memory so; AddressSanitizer has its own one unless it is replaced with the
// rest.
void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
  ++countAllocations::allocations;
  return std::malloc(size == 0 ? 1 : size);
}

void operator delete(void *memory) noexcept
{
  std::free(memory);
}

void operator delete[](void *memory) noexcept
{
  std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
  std::free(memory);
}

void operator delete[](void *memory, std::size_t) noexcept
{
  std::free(memory);
}

#endif
