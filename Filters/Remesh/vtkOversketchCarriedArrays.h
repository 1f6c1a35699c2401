// The arrays of a mesh on what was made of it, for the filters of this module. Not installed.
#ifndef vtkOversketchCarriedArrays_h
#define vtkOversketchCarriedArrays_h

#include "Mesh/mesh.h"
#include "Mesh/place.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;
class vtkIdList;
class vtkPolyData;

namespace oversketch
{

// An array without values of the same kind, name and components, of some tuples.
vtkSmartPointer<vtkAbstractArray> LikeArray(vtkAbstractArray* array, std::size_t tuples);

bool IsNamed(vtkAbstractArray* array, const char* name);

// The points of the input that a new point is a mean of, and their weights.
using PointMix = std::function<void(vtkIdType point, vtkIdList* ids, std::vector<double>& weights)>;

void SetMix(const Mix& mix, vtkIdList* ids, std::vector<double>& weights);

// What becomes of an array of points: the input's point that each point is, or -1; those are mixed where the
// array can be (IsMixable) and holds no labels, and take what the point of largest weight has elsewhere;
// normals keep length 1.
struct CarriedPoints
{
  const std::vector<int>& Sources;
  PointMix Mixed;
  std::string Labels; // the array that holds labels
  PointMix OfLabels;  // what those take their point from; Mixed where empty

  vtkSmartPointer<vtkAbstractArray> Array(vtkAbstractArray* array, bool normals) const;
};

// An array of cells; sources: the input's cell that each cell comes from.
vtkSmartPointer<vtkAbstractArray> CarriedCellArray(vtkAbstractArray* array, const std::vector<int>& sources);

// Gives `to` an array for each of `from` but the global ids, which would no longer be unique, each with the
// part that it has there.
void CarryArrays(vtkDataSetAttributes* from,
  vtkDataSetAttributes* to,
  const std::function<vtkSmartPointer<vtkAbstractArray>(vtkAbstractArray*, bool normals)>& made);

// A mesh with the arrays of the one that it was made of, but for its global ids and the arrays of a 4-8 mesh.
void WriteCarried(const Mesh& mesh,
  const CarriedPoints& points,
  const std::vector<int>& triangleSources,
  vtkPolyData* input,
  vtkPolyData* output);

} // namespace oversketch
#endif
