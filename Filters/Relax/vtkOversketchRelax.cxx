#include "vtkOversketchRelax.h"

#include "Relax/relax.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchStellarCurves.h"
#include "vtkOversketchStrokeThinning.h"
#include "vtkOversketchSurfaceStroke.h"
#include "vtkOversketchWeldedInput.h"

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
  WeldedInput Input;
  vtkNew<vtkPolyData> Strokes; // changed only where the input has
  vtkNew<vtkOversketchStrokeThinning> Thinning;
  vtkNew<vtkOversketchSurfaceStroke> Curves;

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
  MeshKey StrokesSeen;
};

vtkStandardNewMacro(vtkOversketchRelax);

vtkOversketchRelax::vtkOversketchRelax()
{
  this->SetNumberOfInputPorts(2);
  Inner& inner = this->Kept<Inner>();
  inner.Thinning->SetInputData(0, inner.Strokes);
  inner.Curves->SetInputConnection(0, inner.Thinning->GetOutputPort());
  inner.Curves->SetMeshData(inner.Input.Geometry());
  this->AddStage("Thinning", inner.Thinning, 0.01);
  this->AddStage("Curves", inner.Curves, 0.4);
}

int vtkOversketchRelax::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Inner& inner = this->Kept<Inner>();
  inner.Made = nullptr;
  return this->RunOnMesh(inputs,
    outputs,
    [&](vtkPolyData* mesh, vtkPolyData* output)
    {
      RequireFinite(this->Radius, "Radius");
      inner.FeedStrokes(vtkPolyData::GetData(inputs[1]));
      inner.Input.Feed(mesh);
      this->RunStage("Thinning");
      this->RunStage("Curves");
      vtkPolyData* curves = this->StageOutput("Curves");
      RelaxOptions options;
      options.radius = this->Radius < 0.0 ? shareOfDiagonal * mesh->GetLength() : this->Radius;
      options.strength = this->Strength;
      options.usePressure = this->UsePressure;
      options.featureAngle = this->FeatureAngle;
      options.mask = inner.Input.MaskOfVertices(mesh);
      const StepKey key({ WholeKey(mesh), WholeKey(curves) },
        { options.radius, options.strength, options.usePressure ? 1.0 : 0.0, options.featureAngle });
      this->Kept<KeptOutput>().Provide(key,
        output,
        [&](vtkPolyData* result)
        {
          ++this->RelaxCount;
          const Context context = ContextOf(this, this->GetDone(), 1.0);
          const Mesh& surface = inner.Input.Data().Surface();
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
          std::vector<Vector3> places = relaxed(band, context);
          for (std::size_t i = 0; i < places.size(); ++i)
          {
            places[i] = moves(band.share[i]) ? places[i] : surface.points[band.part.vertices[i]];
          }
          inner.Input.Move(mesh, band.part.vertices, places, result);
          inner.Compare(mesh, result);
        });
      inner.Made = std::make_unique<Inner::Result>();
      inner.Made->Output->ShallowCopy(output);
      inner.Made->Curves->ShallowCopy(curves);
    });
}

bool vtkOversketchRelax::Prepare()
{
  return this->TryPrepare(
    [this](vtkPolyData* mesh)
    {
      Inner& inner = this->Kept<Inner>();
      inner.Input.Feed(mesh);
      this->RunStage("Curves", [&inner] { inner.Curves->Prepare(); });
    });
}

bool vtkOversketchRelax::Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold)
{
  return this->TryPreview(mesh,
    stroke,
    hold,
    [&]
    {
      Inner& inner = this->Kept<Inner>();
      inner.Input.Feed(mesh);
      if (stroke->GetNumberOfPoints() < 2)
      {
        this->RunStage("Curves", [&inner] { inner.Curves->Prepare(); });
        return false;
      }
      inner.FeedStrokes(stroke);
      this->RunStage("Thinning");
      this->RunStage("Curves");
      hold->ShallowCopy(this->StageOutput("Curves"));
      return hold->GetNumberOfPoints() > 0;
    });
}

void vtkOversketchRelax::GetHold(vtkPolyData* hold)
{
  hold->Initialize();
  if (this->Kept<Inner>().Made)
  {
    hold->ShallowCopy(this->Kept<Inner>().Made->Curves);
  }
}

void vtkOversketchRelax::GetRegion(vtkPolyData* region)
{
  region->Initialize();
  if (this->Kept<Inner>().Made)
  {
    PutTriangles(this->Kept<Inner>().Made->Output, this->Kept<Inner>().Moved, 1, region);
  }
}

vtkOversketchSystem::FigureList vtkOversketchRelax::Figures()
{
  if (!this->Kept<Inner>().Made)
  {
    return {};
  }
  const std::vector<char>& moved = this->Kept<Inner>().Moved;
  return { { "moved", static_cast<vtkIdType>(std::count(moved.begin(), moved.end(), 1)) },
    { "farthest", this->Kept<Inner>().Farthest } };
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
