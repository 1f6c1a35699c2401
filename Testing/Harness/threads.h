// A context with some threads. Header-only.
#ifndef oversketch_testing_harness_threads_h
#define oversketch_testing_harness_threads_h

#include "Mesh/context.h"

#include <thread>
#include <vector>

namespace oversketch_test
{

// So many threads, whatever the machine has.
inline oversketch::Context withThreads(int number)
{
  oversketch::Context context;
  context.parallelFor = [number](int count, const oversketch::Context::Body& body)
  {
    std::vector<std::thread> threads;
    for (int i = 0; i < number; ++i)
    {
      threads.emplace_back([=, &body] { body(count * i / number, count * (i + 1) / number); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  };
  return context;
}

inline oversketch::Context twoThreads()
{
  return withThreads(2);
}

} // namespace oversketch_test
#endif
