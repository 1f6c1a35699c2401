/**
 * Polylines made of places in a row. For use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchPolylines_h
#define vtkOversketchPolylines_h

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <iterator>
#include <type_traits>

namespace oversketch
{

/**
 * New lines and their points.
 */
class Polylines
{
public:
  Polylines() { this->Points->SetDataTypeToDouble(); }

  /**
   * Adds one, of the plane z = 0 or in space; one that closes ends with its first point.
   */
  template <class Places>
  void Add(const Places& places, bool closes = false)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    this->Lines->InsertNextCell(static_cast<int>(std::size(places)) + closes);
    for (const auto& place : places)
    {
      double z = 0.0;
      if constexpr (std::decay_t<decltype(place)>::SizeAtCompileTime > 2)
      {
        z = place[2];
      }
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(place[0], place[1], z));
    }
    if (closes)
    {
      this->Lines->InsertCellPoint(first);
    }
  }

  void Put(vtkPolyData* output) const
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
};

} // namespace oversketch
#endif
