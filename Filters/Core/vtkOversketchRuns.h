/**
 * Whole stretches of an array at once, where its elements are those of another one in their order. Free
 * functions, for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchRuns_h
#define vtkOversketchRuns_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace oversketch
{

/**
 * Goes through sources, the element of another array that each element is, or -1, in order: copy(first,
 * count, source) for each stretch of elements whose sources follow each other, make(i) for each without a
 * source.
 */
template <typename Source, typename Copy, typename Make>
void EachRun(const std::vector<Source>& sources, const Copy& copy, const Make& make)
{
  for (std::size_t begin = 0, end = 0; begin < sources.size(); begin = end)
  {
    end = begin + 1;
    if (sources[begin] < 0)
    {
      make(static_cast<vtkIdType>(begin));
      continue;
    }
    while (end < sources.size() && sources[end] == sources[end - 1] + 1)
    {
      ++end;
    }
    copy(static_cast<vtkIdType>(begin),
      static_cast<vtkIdType>(end - begin),
      static_cast<vtkIdType>(sources[begin]));
  }
}

} // namespace oversketch
#endif
