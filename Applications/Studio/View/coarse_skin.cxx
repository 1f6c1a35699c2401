#include "coarse_skin.h"

#include "vtkBinnedDecimation.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace oversketch_studio
{

namespace
{

// Bins along the longest side of the mesh's box: to begin with, and the most, which take 64 MB for a moment.
constexpr double firstBins = 128.0, mostBins = 256.0;
constexpr int tries = 5;

bool haveSameBytes(vtkDataArray* a, vtkDataArray* b)
{
  return a == b ||
         (a->GetDataType() == b->GetDataType() && a->GetNumberOfValues() == b->GetNumberOfValues() &&
           std::memcmp(a->GetVoidPointer(0),
             b->GetVoidPointer(0),
             static_cast<std::size_t>(a->GetNumberOfValues()) *
               static_cast<std::size_t>(a->GetDataTypeSize())) == 0);
}

} // namespace

void CoarseSkin::clear()
{
  this->Whole = nullptr;
  this->Faces = nullptr;
  this->Time = 0;
  this->Shown->Initialize();
}

// A preview may have cells of its own with the same faces.
bool CoarseSkin::isOf(vtkPolyData* mesh) const
{
  vtkCellArray* faces = mesh->GetPolys();
  return this->Whole &&
         (faces == this->Whole ||
           (haveSameBytes(faces->GetConnectivityArray(), this->Whole->GetConnectivityArray()) &&
             haveSameBytes(faces->GetOffsetsArray(), this->Whole->GetOffsetsArray())));
}

// Each try comes nearer to the number that is wanted, which goes with the square of the bins.
void CoarseSkin::make(vtkPolyData* mesh, vtkIdType most)
{
  if (this->isOf(mesh))
  {
    return;
  }
  this->clear();
  this->Whole = mesh->GetPolys();
  const vtkBoundingBox box(mesh->GetBounds());
  if (mesh->GetNumberOfPolys() < mesh->GetNumberOfCells() || !(box.GetMaxLength() > 0.0))
  {
    return;
  }
  vtkNew<vtkPolyData> bare; // without arrays, which need no copy
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(bare);
  vtkNew<vtkBinnedDecimation> bins;
  this->Whole->IsHomogeneous() == 3 ? bins->SetInputData(bare)
                                    : bins->SetInputConnection(triangles->GetOutputPort());
  bins->SetPointGenerationModeToUseInputPoints();
  bins->AutoAdjustNumberOfDivisionsOff();
  double along = firstBins;
  vtkIdType count = 0;
  for (int i = 0; i < tries && !(2 * count > most && count <= most); ++i)
  {
    const auto across = [&](int axis)
    { return std::max(1, static_cast<int>(along * box.GetLength(axis) / box.GetMaxLength())); };
    bins->SetNumberOfDivisions(across(0), across(1), across(2));
    bins->Update();
    count = bins->GetOutput()->GetNumberOfPolys();
    if (count <= most && (!this->Faces || count > this->Faces->GetNumberOfCells()))
    {
      this->Faces = bins->GetOutput()->GetPolys();
    }
    const double times =
      std::sqrt(0.9 * static_cast<double>(most) / std::max(1.0, static_cast<double>(count)));
    along = std::min(mostBins, along * times);
  }
  if (this->Faces && 4 * this->Faces->GetNumberOfCells() < most)
  {
    this->Faces = nullptr;
  }
  this->Shown->SetPolys(this->Faces);
}

vtkPolyData* CoarseSkin::of(vtkPolyData* mesh)
{
  if (!mesh || !this->Faces || !this->isOf(mesh))
  {
    return nullptr;
  }
  if (mesh->GetMTime() != this->Time) // points and arrays that are shared tell their own changes
  {
    this->Time = mesh->GetMTime();
    this->Shown->SetPoints(mesh->GetPoints());
    this->Shown->GetPointData()->ShallowCopy(mesh->GetPointData());
  }
  return this->Shown;
}

} // namespace oversketch_studio
