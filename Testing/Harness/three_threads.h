// A caller of kernels with three threads, whatever the machine has.
#ifndef oversketch_testing_harness_three_threads_h
#define oversketch_testing_harness_three_threads_h

#include "Mesh/context.h"

#include <thread>
#include <vector>

namespace oversketch_test
{

inline oversketch::Context threeThreads()
{
  oversketch::Context context;
  context.parallelFor = [](int count, const oversketch::Context::Body& body)
  {
    std::vector<std::thread> threads;
    threads.reserve(3);
    for (int i = 0; i < 3; ++i)
    {
      threads.emplace_back([=, &body] { body(count * i / 3, count * (i + 1) / 3); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  };
  return context;
}

} // namespace oversketch_test
#endif
