// A context with two threads. Header-only.
#ifndef oversketch_testing_harness_threads_h
#define oversketch_testing_harness_threads_h

#include "Mesh/context.h"

#include <thread>

namespace oversketch_test
{

// Two threads, whatever the machine has.
inline oversketch::Context twoThreads()
{
  oversketch::Context context;
  context.parallelFor = [](int count, const oversketch::Context::Body& body)
  {
    std::thread half([&] { body(0, count / 2); });
    body(count / 2, count);
    half.join();
  };
  return context;
}

} // namespace oversketch_test
#endif
