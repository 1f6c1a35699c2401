/**
 * The user's arrays from one mesh to what is made of it: which are interpolated, by what, and which stay
 * behind. For use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchCarriedArrays_h
#define vtkOversketchCarriedArrays_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "Mesh/mesh.h"
#include "Mesh/place.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkCellArray;
class vtkIntArray;
class vtkPolyData;

namespace oversketch
{

/**
 * Whether an array's numbers mean something between two elements: real ones, and whole ones that are a colour
 * or a measure, which are then rounded. Ids and labels alone do not, and keep the value of one element: bits,
 * characters, whole numbers of eight bytes, and those of one component whose name has one of the words id,
 * index, label, region, part, group, material, segment, class, cluster, chart, flag, mask, seed, object,
 * kind, type, face, cell, vertex, point, source, treatment, mark, in any spelling: "RegionId",
 * "point_labels".
 */
OVERSKETCHFILTERSCORE_EXPORT bool IsMixable(vtkAbstractArray* array);

OVERSKETCHFILTERSCORE_EXPORT bool IsNamed(vtkAbstractArray* array, const char* name);

///@{
/**
 * The number of each face's part, cell array PartId; null where the mesh is one part, 0. Throws
 * Error(BadMesh) where it is not one int a face, from 0 on. The highest of these numbers.
 */
OVERSKETCHFILTERSCORE_EXPORT vtkIntArray* PartNumbers(vtkPolyData* mesh);
OVERSKETCHFILTERSCORE_EXPORT int HighestPart(vtkIntArray* numbers);
///@}

/**
 * An array without values of the same kind, name and components, of some tuples.
 */
template <typename Array>
vtkSmartPointer<Array> LikeArray(Array* array, std::size_t tuples)
{
  const auto count = static_cast<vtkIdType>(tuples);
  vtkNew<vtkDataSetAttributes> from, to;
  from->AddArray(array);
  to->CopyAllocate(from, count);
  vtkSmartPointer<Array> result = Array::SafeDownCast(to->GetAbstractArray(0));
  result->SetNumberOfTuples(count);
  return result;
}

/**
 * Goes through sources, the element of another array that each element is, in order: copy(first, count,
 * source) for each stretch of elements whose sources follow each other. Those without one, -1, are left out.
 */
template <typename Source, typename Copy>
void EachRun(const std::vector<Source>& sources, const Copy& copy)
{
  for (std::size_t begin = 0, end = 0; begin < sources.size(); begin = end)
  {
    end = begin + 1;
    while (sources[begin] >= 0 && end < sources.size() && sources[end] == sources[end - 1] + 1)
    {
      ++end;
    }
    if (sources[begin] >= 0)
    {
      copy(static_cast<vtkIdType>(begin),
        static_cast<vtkIdType>(end - begin),
        static_cast<vtkIdType>(sources[begin]));
    }
  }
}

/**
 * The array's tuples by source; those without one hold nothing.
 */
template <typename Array, typename Source>
vtkSmartPointer<Array> CarriedArray(Array* array, const std::vector<Source>& sources)
{
  auto carried = LikeArray(array, sources.size());
  EachRun(sources,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); });
  return carried;
}

/**
 * Gives `to` the tuples by source of all arrays that it is to copy (vtkDataSetAttributes::CopyAllOn).
 */
template <typename Source>
void CopyElements(vtkDataSetAttributes* from, const std::vector<Source>& sources, vtkDataSetAttributes* to)
{
  to->CopyAllocate(from, static_cast<vtkIdType>(sources.size()));
  EachRun(sources,
    [&](vtkIdType first, vtkIdType count, vtkIdType source) { to->CopyData(from, first, count, source); });
}

/**
 * Writes means of tuples: of arrays that are mixed weighted ones, of others what has the largest weight.
 * Normals keep length 1.
 */
class OVERSKETCHFILTERSCORE_EXPORT TupleMixer
{
public:
  TupleMixer(bool linear, bool normals)
    : Linear(linear)
    , Normals(normals)
  {
  }
  void Put(vtkAbstractArray* to, vtkIdType tuple, const Mix& mix, vtkAbstractArray* from);

private:
  bool Linear, Normals;
  vtkNew<vtkIdList> Ids;
  std::vector<double> Weights;
};

/**
 * Carries an array of points: the input's point that each point is, or -1; those are mixed where the
 * array can be (IsMixable) and holds no labels.
 */
struct OVERSKETCHFILTERSCORE_EXPORT CarriedPoints
{
  using Mixes = std::function<const Mix&(vtkIdType point)>; // of the input's points, until it is called again

  const std::vector<int>& Sources;
  Mixes Mixed;
  std::string Labels = {}; // the array that holds labels; empty: none does
  Mixes OfLabels = {};     // what those take their point from; Mixed where empty

  vtkSmartPointer<vtkAbstractArray> Array(vtkAbstractArray* array, bool normals) const;
};

/**
 * Gives `to` what is made of each array of `from`, with the part that it has there. Left out are those that
 * nothing is made of, and global ids, which would no longer be unique.
 */
OVERSKETCHFILTERSCORE_EXPORT void CarryArrays(vtkDataSetAttributes* from,
  vtkDataSetAttributes* to,
  const std::function<vtkSmartPointer<vtkAbstractArray>(vtkAbstractArray* array, bool normals)>& made);

/**
 * Results of arrays in the last run of a step, for as long as they stand.
 */
class OVERSKETCHFILTERSCORE_EXPORT KeptArrays
{
public:
  /**
   * Gives what became of the array when it was used that way, else what `make` gives.
   */
  vtkSmartPointer<vtkAbstractArray> Provide(vtkAbstractArray* array,
    int use,
    const std::function<vtkSmartPointer<vtkAbstractArray>()>& make);

  /**
   * Ends a run: what it did not ask for is forgotten.
   */
  void EndRun();

private:
  struct Item
  {
    const void* Source;
    vtkMTimeType Time;
    int Use;
    vtkSmartPointer<vtkAbstractArray> Result;
  };
  std::vector<Item> Known, Asked;
};

OVERSKETCHFILTERSCORE_EXPORT vtkSmartPointer<vtkCellArray> CellsOf(const std::vector<Triangle>& triangles);

/**
 * Writes a mesh with the arrays of the one that it was made of, but for its global ids and the arrays of a
 * 4-8 mesh.
 */
OVERSKETCHFILTERSCORE_EXPORT void WriteCarried(const Mesh& mesh,
  const CarriedPoints& points,
  const std::vector<int>& triangleSources,
  vtkPolyData* input,
  vtkPolyData* output);

///@{
/**
 * The arrays by which a mesh is a 4-8 mesh (Filters/Stellar/README.md), for steps that make triangles of
 * their own: there the arrays would tell of others.
 */
inline constexpr const char* stellarCellArrays[] = { "StellarRoot", "StellarPath", "StellarGen" };
inline constexpr const char* stellarPointArrays[] = { "StellarMoved",
  "CurveId",
  "CurveParam",
  "BaseNormal",
  "Displacement",
  "Feature" };
inline constexpr const char* stellarFieldArrays[] = { "StellarVersion", "CurveDigest" };
///@}

/**
 * Whether an array is one of these, by its name.
 */
OVERSKETCHFILTERSCORE_EXPORT bool IsStellarArray(const char* name);

/**
 * Takes them away.
 */
OVERSKETCHFILTERSCORE_EXPORT void RemoveStellarArrays(vtkPolyData* mesh);

/**
 * The same, of a mesh that has the cells' arrays; others may mean something else by these names.
 */
OVERSKETCHFILTERSCORE_EXPORT void DropHierarchy(vtkPolyData* mesh);

} // namespace oversketch
#endif
