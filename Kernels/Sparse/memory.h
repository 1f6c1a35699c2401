// Memory that factors lie in, kept from one to the next: the system hands new memory out page by page, which
// takes as long as a factorisation.
#ifndef oversketch_kernels_sparse_memory_h
#define oversketch_kernels_sparse_memory_h

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace oversketch
{

// Room for doubles, not cleared. In huge pages where the system has them: the columns of a panel lie so far
// apart that each would need a page of its own in the processor's table.
class Memory
{
public:
  // Loses what it held if it has to grow.
  void reserve(std::size_t count)
  {
    if (count > this->Room)
    {
      this->Data.reset();
      this->Room = 0;
      const std::size_t room = count + count / 4; // what is never touched takes no memory
      const std::size_t size = (room * sizeof(double) + hugePage - 1) / hugePage * hugePage;
      this->Data.reset(static_cast<double*>(std::aligned_alloc(hugePage, size)));
      if (!this->Data)
      {
        throw std::bad_alloc();
      }
#if defined(__linux__)
      madvise(this->Data.get(), size, MADV_HUGEPAGE); // where refused it is only slower
#endif
      this->Room = room;
    }
  }
  double* data() const
  {
    return this->Data.get();
  }

private:
  static constexpr std::size_t hugePage = std::size_t(1) << 21; // bytes
  struct Free
  {
    void operator()(double* data) const { std::free(data); }
  };
  std::unique_ptr<double, Free> Data;
  std::size_t Room = 0;
};

// Pieces of memory of one size for any number of threads.
class MemoryPool
{
public:
  // A piece that goes back when the handle dies.
  struct Return
  {
    MemoryPool* pool;
    void operator()(Memory* memory) const
    {
      const std::lock_guard<std::mutex> lock(this->pool->Mutex);
      this->pool->Unused.emplace_back(memory);
    }
  };
  std::unique_ptr<Memory, Return> take(std::size_t count)
  {
    std::unique_ptr<Memory> memory;
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Unused.empty())
      {
        memory = std::move(this->Unused.back());
        this->Unused.pop_back();
      }
    }
    if (!memory)
    {
      memory = std::make_unique<Memory>();
    }
    memory->reserve(count);
    return { memory.release(), { this } };
  }

private:
  std::mutex Mutex;
  std::vector<std::unique_ptr<Memory>> Unused;
};

// Memory that one Cholesky factor lies in. The next one may take it over once the former is not used any
// more.
struct FactorMemory
{
  Memory panels, updates;
  MemoryPool stacks, strips;
};

} // namespace oversketch
#endif
