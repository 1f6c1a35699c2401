/**
 * Arrays with a name, and what they are made of. For use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchArrays_h
#define vtkOversketchArrays_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>

namespace oversketch
{

/**
 * An array whose values are for the caller to fill.
 */
template <class Array>
vtkSmartPointer<Array> NewArray(const char* name, int components = 1, std::size_t tuples = 0)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

/**
 * An array of one value per item, a member of it or what a function makes of it.
 */
template <class Array, class Items, class Value>
vtkSmartPointer<Array> ArrayOf(const char* name, const Items& items, const Value& value)
{
  auto array = NewArray<Array>(name, 1, std::size(items));
  std::transform(std::begin(items),
    std::end(items),
    array->GetPointer(0),
    [&value](const auto& item) { return static_cast<typename Array::ValueType>(std::invoke(value, item)); });
  return array;
}

/**
 * An array of these values.
 */
template <class Array, class Values>
vtkSmartPointer<Array> ArrayOf(const char* name, const Values& values)
{
  return ArrayOf<Array>(name, values, [](const auto& value) { return value; });
}

template <class Array, class Value>
vtkSmartPointer<Array> OneValue(const char* name, Value value)
{
  return ArrayOf<Array>(name, std::array<Value, 1>{ value });
}

} // namespace oversketch
#endif
