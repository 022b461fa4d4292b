// Stands in for malloc in the program that links it, in order to count.
#pragma once

namespace tripoint::testing {

/// False under a sanitizer, which stands in for malloc itself.
bool allocations_are_counted();

/// malloc, calloc, realloc and aligned allocations since the program started; operator new comes here too.
long counted_allocations();

template <typename Work>
long allocations_in(const Work& work) {
  const long before = counted_allocations();
  work();
  return counted_allocations() - before;
}

}  // namespace tripoint::testing
