// The shipped models and strokes, for tests of whole systems.
#ifndef oversketch_testing_harness_shipped_h
#define oversketch_testing_harness_shipped_h

#include "Harness/promises.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkPLYReader.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <string>

namespace oversketch_test
{

inline vtkSmartPointer<vtkPolyData> shippedModel(const std::string& name)
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName((OVERSKETCH_DATA_FOLDER "/Models/" + name + ".ply").c_str());
  reader->Update();
  return reader->GetOutput();
}

inline vtkSmartPointer<vtkPolyData> shippedStroke(const std::string& name)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((OVERSKETCH_DATA_FOLDER "/Strokes/" + name + ".vtp").c_str());
  reader->Update();
  return reader->GetOutput();
}

// Largest distance between equally numbered points; infinity when the numbers differ.
inline double largestMove(vtkPolyData* a, vtkPolyData* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    Vector3 p, q;
    a->GetPoint(i, p.data());
    b->GetPoint(i, q.data());
    largest = std::max(largest, (p - q).norm());
  }
  return largest;
}

// Same points and polygons, bit for bit.
inline bool identical(vtkPolyData* a, vtkPolyData* b)
{
  if (largestMove(a, b) != 0.0 || a->GetNumberOfPolys() != b->GetNumberOfPolys())
  {
    return false;
  }
  vtkNew<vtkIdList> p, q;
  for (vtkIdType i = 0; i < a->GetNumberOfPolys(); ++i)
  {
    a->GetPolys()->GetCellAtId(i, p);
    b->GetPolys()->GetCellAtId(i, q);
    if (!std::equal(p->begin(), p->end(), q->begin(), q->end()))
    {
      return false;
    }
  }
  return true;
}

} // namespace oversketch_test
#endif
