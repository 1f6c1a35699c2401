#include "vtkOversketchFollowers.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSources.h"
#include "vtkOversketchWeld.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"

namespace oversketch
{

Followers::Followers(vtkPolyData* output, const Weld& welding, vtkPolyData* deformed)
  : Rest(output->GetPoints())
  , Before(deformed->GetPoints())
{
  const vtkIdType count = output->GetNumberOfPoints();
  this->Vertices.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->Vertices.push_back(static_cast<int>(welding.VertexOf(i)));
  }
}

Followers::Followers(vtkPolyData* output,
  std::vector<int> vertices,
  vtkPolyData* deformed,
  vtkPolyData* restored)
  : Rest(output->GetPoints())
  , Before(deformed->GetPoints())
  , Deformed(vtkSmartPointer<vtkPolyData>::New())
  , Restored(vtkSmartPointer<vtkPolyData>::New())
  , Vertices(std::move(vertices))
{
  this->Deformed->ShallowCopy(deformed);
  this->Restored->ShallowCopy(restored);
}

bool Followers::Fits(vtkPoints* points) const
{
  return (points->GetDataType() == VTK_FLOAT || points->GetDataType() == VTK_DOUBLE) &&
         points->GetNumberOfPoints() == this->Rest->GetNumberOfPoints();
}

void Followers::Bind()
{
  const Sources sources(this->Restored);
  this->Bindings.resize(static_cast<std::size_t>(this->Restored->GetNumberOfPoints()));
  vtkNew<vtkIdList> corners, source;
  for (vtkIdType t = 0; t < this->Restored->GetNumberOfPolys(); ++t)
  {
    this->Restored->GetPolys()->GetCellAtId(t, corners);
    for (int corner = 0; corner < 3; ++corner)
    {
      this->Deformed->GetPolys()->GetCellAtId(sources.Cell(t, corner), source);
      const double* weights = sources.WeightsAt(t, corner);
      Binding& binding = this->Bindings[static_cast<std::size_t>(corners->GetId(corner))];
      for (int k = 0; k < 3; ++k)
      {
        binding.vertices[k] = static_cast<int>(source->GetId(k));
        binding.weights[k] = weights[k];
      }
    }
  }
}

bool Followers::Place(const Drag& drag, const double translation[3], vtkPoints* points)
{
  if (this->Dragged->GetNumberOfPoints() == 0)
  {
    // As it is before rounding, so that no drag is no move.
    const double none[3] = { 0.0, 0.0, 0.0 };
    this->Dragged->SetDataTypeToDouble();
    this->Dragged->DeepCopy(this->Before);
    if (!drag(none, this->Dragged))
    {
      return false;
    }
    this->Before = vtkSmartPointer<vtkPoints>::New();
    this->Before->SetDataTypeToDouble();
    this->Before->DeepCopy(this->Dragged);
    if (this->Restored)
    {
      this->Bind();
    }
  }
  if (!drag(translation, this->Dragged))
  {
    return false;
  }
  const auto move = [this](vtkIdType vertex)
  {
    Vector3 before, dragged;
    this->Before->GetPoint(vertex, before.data());
    this->Dragged->GetPoint(vertex, dragged.data());
    return Vector3(dragged - before);
  };
  for (std::size_t i = 0; i < this->Vertices.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    Vector3 at;
    this->Rest->GetPoint(point, at.data());
    if (!this->Restored)
    {
      at += move(this->Vertices[i]);
    }
    else
    {
      const Binding& binding = this->Bindings[static_cast<std::size_t>(this->Vertices[i])];
      for (int k = 0; k < 3; ++k)
      {
        at += binding.weights[k] * move(binding.vertices[k]);
      }
    }
    points->SetPoint(point, at.data());
  }
  points->Modified();
  return true;
}

} // namespace oversketch
