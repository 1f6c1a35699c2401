#include "vtkOversketchHandles.h"

#include "Matrix/operations.h"
#include "vtkOversketchEditTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchHandles);

namespace
{

// The way in the world of a place that goes so far in the picture, as far from the eye as before.
Vector3 ShiftOf(const View& view, const Vector3& place, const Vector2& pixels)
{
  if (!view.inFront(place))
  {
    throw Error(Failure::BadStroke,
      "The curve's middle is behind the eye of the view that it would be dragged in; look at it and draw it "
      "anew.");
  }
  const Vector2 seen = view.toDisplay(place).head<2>();
  const double depth = view.depth(place);
  return view.toWorld(seen + pixels, depth) - view.toWorld(seen, depth);
}

void Write(const std::vector<PlacedHandle>& handles, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  const auto places = NewArray<vtkDoubleArray>("CurveT");
  const auto matrices = NewArray<vtkDoubleArray>("Matrix");
  const auto frames = NewArray<vtkDoubleArray>("Frame");
  for (vtkDoubleArray* array : { matrices.Get(), frames.Get() })
  {
    array->SetNumberOfComponents(16);
  }
  for (const PlacedHandle& handle : handles)
  {
    const vtkIdType id = points->InsertNextPoint(handle.frame.origin.data());
    vertices->InsertNextCell(1, &id);
    places->InsertNextValue(handle.t);
    // Eigen's matrices run column by column.
    matrices->InsertNextTuple(Matrix4(handle.matrix.transpose()).data());
    frames->InsertNextTuple(Matrix4(matrixOf(handle.frame).transpose()).data());
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  for (vtkDoubleArray* array : { places.Get(), matrices.Get(), frames.Get() })
  {
    output->GetPointData()->AddArray(array);
  }
}

} // namespace

vtkOversketchHandles::vtkOversketchHandles()
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 2, { Port::Optional });
}

void vtkOversketchHandles::SetOperations(const char* text)
{
  SetText(this, this->Operations, text);
}

void vtkOversketchHandles::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* curve = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* further = vtkPolyData::GetData(inputs[2]);
  std::vector<double> text;
  AddText(text, this->Operations);
  const StepKey key({ MeshKey(mesh, { mesh->GetPointData()->GetNormals() }),
                      WholeKey(curve),
                      further ? WholeKey(further) : MeshKey() },
    text);
  this->Kept<KeptOutput>().Provide(key,
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      auto& data = this->Kept<std::shared_ptr<const MeshData>>(); // alive between runs
      data = SharedMesh(mesh);
      const CurveOnMesh reference(curve, *data);
      const auto frameAt = [&](double t) { return reference.Frames.at(t); };
      std::function<Vector3(const Vector2&)> shiftOf;
      if (!ViewArraysOf(curve).empty())
      {
        shiftOf = [&](const Vector2& pixels) { return ShiftOf(ViewOf(curve), frameAt(0.5).origin, pixels); };
      }
      const OperatedHandles operated = handlesOf(this->Operations, frameAt, shiftOf);
      std::vector<PlacedHandle> handles = operated.handles;
      if (further)
      {
        const std::vector<double> places = ReadHandlePlaces(further);
        const std::vector<Matrix4> matrices = ReadHandleMatrices(further);
        for (std::size_t i = 0; i < places.size(); ++i)
        {
          const CurveFrame frame = reference.Frames.at(places[i]);
          handles.push_back({ places[i], frame, inWorld(frame, matrices[i]) });
        }
      }
      if (!operated.shift.isZero(0.0))
      {
        shiftAll(handles, operated.shift, frameAt);
      }
      Write(handles, result);
    });
}

void vtkOversketchHandles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operations: " << this->Operations << '\n';
}
