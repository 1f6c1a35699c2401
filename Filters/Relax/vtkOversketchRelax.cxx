#include "vtkOversketchRelax.h"

#include "Relax/relax.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchStellarCurves.h"
#include "vtkOversketchStrokeThinning.h"
#include "vtkOversketchSurfaceStroke.h"
#include "vtkOversketchWeld.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

namespace
{

constexpr double shareOfDiagonal = 0.03;

// The curves, with the triangles that they go through.
FeatureCurves curvesWithCells(vtkPolyData* curves, vtkIdType triangles)
{
  FeatureCurves result = CurvesOf(curves);
  vtkDataArray* cells = RequireArray(curves->GetPointData(),
    "MeshCell",
    1,
    curves->GetNumberOfPoints(),
    "curves",
    "vtkOversketchSurfaceStroke writes it");
  vtkIdType next = 0; // its curves are new points each, one after the other
  for (FeatureCurve& curve : result)
  {
    for (std::size_t i = 0; i < curve.points.size(); ++i)
    {
      const auto cell = static_cast<vtkIdType>(cells->GetComponent(next++, 0));
      curve.cells.push_back(static_cast<int>(std::clamp<vtkIdType>(cell, 0, triangles - 1)));
    }
  }
  return result;
}

} // namespace

struct vtkOversketchRelax::Inner
{
  // Inputs of the steps, changed only where theirs have: the mesh's triangles with repeated points welded.
  vtkNew<vtkPolyData> Mesh, Strokes;
  std::unique_ptr<Weld> Welding;
  vtkNew<vtkOversketchStrokeThinning> Thinning;
  vtkNew<vtkOversketchSurfaceStroke> Curves;
  KeptOutput Kept;

  void FeedMesh(vtkPolyData* mesh)
  {
    RequirePolygonsOnly(mesh); // the key does not see other cells
    if (this->Welding && this->MeshSeen == MeshKey(mesh))
    {
      return;
    }
    vtkNew<vtkPolyData> bare; // of attributes, which would have to be told apart at seams
    bare->SetPoints(mesh->GetPoints());
    bare->SetPolys(mesh->GetPolys());
    this->Welding = std::make_unique<Weld>(bare);
    this->MeshSeen = MeshKey(mesh);
    this->Mesh->ShallowCopy(this->Welding->Welded());
  }
  // The mask of each vertex.
  std::vector<double> MaskOfVertices(vtkPolyData* mesh) const
  {
    vtkNew<vtkPolyData> masked;
    masked->ShallowCopy(this->Mesh);
    this->Welding->PutMask(mesh, masked);
    return MaskOf(masked);
  }
  void FeedStrokes(vtkPolyData* strokes)
  {
    if (strokes->GetNumberOfPoints() == 0 || strokes->GetNumberOfCells() == 0)
    {
      throw Error(Failure::BadStroke, "There is no stroke; draw one over the mesh.");
    }
    if (this->StrokesSeen != WholeKey(strokes))
    {
      this->Strokes->ShallowCopy(strokes);
      this->StrokesSeen = WholeKey(strokes);
    }
  }

  // Parts of the last output, as shallow copies.
  struct Result
  {
    vtkNew<vtkPolyData> Output, Curves;
  };
  std::unique_ptr<Result> Made; // null after a run that failed
  // Points of what is kept that lie elsewhere, and how far at most.
  std::vector<char> Moved;
  double Farthest = 0.0;
  void Compare(vtkPolyData* mesh, vtkPolyData* output)
  {
    this->Moved.resize(static_cast<std::size_t>(output->GetNumberOfPoints()));
    this->Farthest = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      Vector3 before, after;
      mesh->GetPoint(i, before.data());
      output->GetPoint(i, after.data());
      this->Moved[i] = before != after;
      this->Farthest = std::max(this->Farthest, (after - before).norm());
    }
  }

private:
  MeshKey MeshSeen, StrokesSeen;
};

vtkStandardNewMacro(vtkOversketchRelax);

vtkOversketchRelax::vtkOversketchRelax()
  : Internals(new Inner)
{
  this->SetNumberOfInputPorts(2);
  this->Internals->Thinning->SetInputData(0, this->Internals->Strokes);
  this->Internals->Curves->SetInputConnection(0, this->Internals->Thinning->GetOutputPort());
  this->Internals->Curves->SetMeshData(this->Internals->Mesh);
  this->AddStage("Thinning", this->Internals->Thinning, 0.01);
  this->AddStage("Curves", this->Internals->Curves, 0.4);
}

vtkOversketchRelax::~vtkOversketchRelax() = default;

int vtkOversketchRelax::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Inner& inner = *this->Internals;
  inner.Made = nullptr;
  return this->RunSystem(
    [&]
    {
      vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (mesh->GetNumberOfPoints() == 0)
      {
        return;
      }
      RequireFinite(this->Radius, "Radius");
      inner.FeedStrokes(vtkPolyData::GetData(inputs[1]));
      inner.FeedMesh(mesh);
      this->RunStage("Thinning");
      this->RunStage("Curves");
      vtkPolyData* curves = this->StageOutput("Curves");
      RelaxOptions options;
      options.radius = this->Radius < 0.0 ? shareOfDiagonal * mesh->GetLength() : this->Radius;
      options.strength = this->Strength;
      options.usePressure = this->UsePressure;
      options.featureAngle = this->FeatureAngle;
      options.mask = inner.MaskOfVertices(mesh);
      const StepKey key({ WholeKey(mesh), WholeKey(curves) },
        { options.radius, options.strength, options.usePressure ? 1.0 : 0.0, options.featureAngle });
      inner.Kept.Provide(key,
        output,
        [&](vtkPolyData* result)
        {
          ++this->RelaxCount;
          const Context context = ContextOf(this, this->GetDone(), 1.0);
          const std::shared_ptr<const MeshData> data = SharedMesh(inner.Mesh);
          const Mesh& surface = data->Surface();
          const RelaxBand band =
            relaxBand(surface, curvesWithCells(curves, surface.triangleCount()), options, context);
          const auto moves = [](double share) { return share > 0.0; };
          if (this->Strength > 0.0 && std::none_of(band.share.begin(), band.share.end(), moves))
          {
            throw Error(Failure::BadStroke,
              options.mask.empty() ? "No point of the mesh within {Radius} %1 of the stroke may move; draw "
                                     "with a larger radius, or "
                                     "where the mesh is finer."
                                   : "No point of the mesh within {Radius} %1 of the stroke may move; draw "
                                     "with a larger radius, "
                                     "where the mesh is finer, or beside the mask.",
              options.radius);
          }
          const std::vector<Vector3> places = relaxed(band, context);
          vtkNew<vtkPoints> points;
          points->SetDataTypeToDouble();
          points->DeepCopy(inner.Mesh->GetPoints());
          for (std::size_t i = 0; i < places.size(); ++i)
          {
            if (moves(band.share[i]))
            {
              points->SetPoint(band.part.vertices[i], places[i].data());
            }
          }
          vtkNew<vtkPolyData> moved;
          moved->SetPoints(points);
          inner.Welding->Move(mesh, moved, result);
          inner.Compare(mesh, result);
        });
      inner.Made = std::make_unique<Inner::Result>();
      inner.Made->Output->ShallowCopy(output);
      inner.Made->Curves->ShallowCopy(curves);
    });
}

bool vtkOversketchRelax::Prepare()
{
  auto* mesh = vtkPolyData::SafeDownCast(this->UpdatedInput(0));
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    return false;
  }
  return this->Try(
    [&]
    {
      this->Internals->FeedMesh(mesh);
      this->RunStage("Curves", [this] { this->Internals->Curves->Prepare(); });
      return true;
    });
}

bool vtkOversketchRelax::Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold)
{
  hold->Initialize();
  if (!mesh || !stroke || mesh->GetNumberOfPoints() == 0)
  {
    return false;
  }
  return this->Try(
    [&]
    {
      this->Internals->FeedMesh(mesh);
      if (stroke->GetNumberOfPoints() < 2)
      {
        this->RunStage("Curves", [this] { this->Internals->Curves->Prepare(); });
        return false;
      }
      this->Internals->FeedStrokes(stroke);
      this->RunStage("Thinning");
      this->RunStage("Curves");
      hold->ShallowCopy(this->StageOutput("Curves"));
      return hold->GetNumberOfPoints() > 0;
    });
}

void vtkOversketchRelax::GetHold(vtkPolyData* hold)
{
  hold->Initialize();
  if (this->Internals->Made)
  {
    hold->ShallowCopy(this->Internals->Made->Curves);
  }
}

void vtkOversketchRelax::GetRegion(vtkPolyData* region)
{
  region->Initialize();
  if (this->Internals->Made)
  {
    PutTriangles(this->Internals->Made->Output, this->Internals->Moved, 1, region);
  }
}

vtkOversketchSystem::FigureList vtkOversketchRelax::Figures()
{
  if (!this->Internals->Made)
  {
    return {};
  }
  const std::vector<char>& moved = this->Internals->Moved;
  return { { "moved", static_cast<vtkIdType>(std::count(moved.begin(), moved.end(), 1)) },
    { "farthest", this->Internals->Farthest } };
}

void vtkOversketchRelax::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "UsePressure: " << this->UsePressure << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "RelaxCount: " << this->RelaxCount << "\n";
}
