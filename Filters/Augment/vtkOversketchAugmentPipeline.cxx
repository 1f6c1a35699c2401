#include "vtkOversketchAugmentPipeline.h"

#include "Stellar/profile.h"
#include "vtkOversketchAugmentSeams.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchPolylines.h"
#include "vtkOversketchSources.h"
#include "vtkOversketchStellarCurves.h"
#include "vtkOversketchStepRunner.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace oversketch;

namespace
{

// How near curves follow the surface, in radii.
constexpr double curveTolerance = 0.02;

double DiagonalOf(vtkPolyData* mesh)
{
  double box[6];
  mesh->GetCellsBounds(box);
  return Vector3(box[1] - box[0], box[3] - box[2], box[5] - box[4]).norm();
}

// The mesh without arrays, where it is not there already.
void PutShape(vtkPolyData* mesh, vtkPolyData* shape, MeshKey& seen)
{
  if (seen != MeshKey(mesh) || shape->GetNumberOfPoints() == 0)
  {
    shape->Initialize();
    shape->SetPoints(mesh->GetPoints());
    shape->SetPolys(mesh->GetPolys());
    seen = MeshKey(mesh);
  }
}

// Whether there are arrays that each step would round.
bool HasWholeMeasures(vtkPointData* data)
{
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    if (array && IsMixable(array) && !IsStellarArray(array->GetName()) && array->GetDataType() != VTK_FLOAT &&
        array->GetDataType() != VTK_DOUBLE)
    {
      return true;
    }
  }
  return false;
}

} // namespace

vtkOversketchAugment::Pipeline::Pipeline(vtkOversketchAugment* self)
  : Self(self)
{
  this->Thinning->SetInputData(0, this->Strokes);
  this->Chaikin->SetInputConnection(0, this->Thinning->GetOutputPort());
  this->Even->SetInputData(0, this->Uneven);
  this->Even->SetStageToRestore();
  this->Even->LimitByDiameterOff();
  this->Curves->SetInputConnection(0, this->Chaikin->GetOutputPort());
  this->Curves->SetInputData(1, this->Shape);
  this->SilhouetteStep->SetInputData(0, this->Shape);
  this->SilhouetteStep->SetInputData(1, this->Strokes);
  this->Visibility->SetInputConnection(0, this->SilhouetteStep->GetOutputPort());
  this->Visibility->SetInputData(1, this->Shape);
  this->Visibility->SetInputData(2, this->Strokes);
  this->Sketch->SetInputConnection(0, this->Chaikin->GetOutputPort());
  this->Sketch->SetInputData(1, this->Shape);
  this->Sketch->SetInputConnection(2, this->Visibility->GetOutputPort());
  this->Refine->SetInputConnection(0, this->Base->GetOutputPort());
  this->CurvesOnSource->SetInputConnection(0, this->Chaikin->GetOutputPort());
  this->CurvesOnSource->SetInputData(1, this->RefinedShape);
  this->RefineOnSource->SetInputConnection(0, this->Refine->GetOutputPort());
  this->RefineOnSource->SetCurvesConnection(this->CurvesOnSource->GetOutputPort());
  this->Refine->SetSourceConnection(this->Base->GetOutputPort(1));
  this->RefineOnSource->SetSourceConnection(this->Base->GetOutputPort(1));
  this->Snap->SetSourceConnection(this->Base->GetOutputPort(1));
  this->Smooth->SetSourceConnection(this->Base->GetOutputPort(1));
  this->Smooth->SetInputConnection(0, this->Snap->GetOutputPort());
  this->Displace->SetInputConnection(0, this->Smooth->GetOutputPort());
  this->Simplify->SetInputConnection(0, this->Displace->GetOutputPort());
  this->Reshaped->CountIntersectionsOff();
  this->Connect();

  self->AddStage("Thinning", this->Thinning, 0.01);
  self->AddStage("Chaikin", this->Chaikin, 0.01);
  self->AddStage("Base", this->Base, 0.15);
  self->AddStage("Curves", this->Curves, 0.08);
  self->AddStage("Even", this->Even, 0.05);
  self->AddStage("Silhouette", this->SilhouetteStep, 0.05);
  self->AddStage("Visibility", this->Visibility, 0.05);
  self->AddStage("Sketch", this->Sketch, 0.05);
  self->AddStage("Refine", this->Refine, 0.11);
  self->AddStage("CurvesOnSource", this->CurvesOnSource, 0.02);
  self->AddStage("RefineOnSource", this->RefineOnSource, 0.02);
  self->AddStage("Snap", this->Snap, 0.20);
  self->AddStage("Smooth", this->Smooth, 0.08);
  self->AddStage("Displace", this->Displace, 0.08);
  self->AddStage("Simplify", this->Simplify, 0.04);
  this->SetAmendments(true);
}

void vtkOversketchAugment::Pipeline::SetAmendments(bool on)
{
  this->Base->SetImprovePairs(on);
  this->Sketch->SetProjection(on ? vtkOversketchSilhouetteSketch::Line : vtkOversketchSilhouetteSketch::Ray);
  for (vtkOversketchStellarRefine* step : { this->Refine.Get(), this->RefineOnSource.Get() })
  {
    step->SetFineFoot(on);
    step->SetConnectedOnly(on);
    step->SetSeedCurveFaces(on);
  }
  this->Snap->SetOrder(on ? vtkOversketchStellarSnap::Nearest : vtkOversketchStellarSnap::AllAtOnce);
  this->Snap->SetConnectedOnly(on);
  this->Smooth->SetRings(on ? 2 : -1);
  this->Displace->SetConnectedOnly(on);
  this->Displace->SetHoldBack(on);
  this->Displace->SetNormals(on ? vtkOversketchStellarDisplace::Base : vtkOversketchStellarDisplace::Current);
  this->Simplify->SetConnectedOnly(on);
}

void vtkOversketchAugment::Pipeline::Connect()
{
  const bool sketched = this->Self->SketchMode == Silhouette, moved = this->ReadsSource();
  vtkAlgorithmOutput* drawn = sketched ? this->Sketch->GetOutputPort() : this->Curves->GetOutputPort();
  vtkAlgorithmOutput* curves = moved ? this->CurvesOnSource->GetOutputPort() : drawn;
  this->Refine->SetCurvesConnection(drawn);
  this->Snap->SetInputConnection(0, (moved ? this->RefineOnSource : this->Refine)->GetOutputPort());
  this->Snap->SetCurvesConnection(curves);
  this->Smooth->SetCurvesConnection(curves);
  this->Simplify->SetCurvesConnection(curves);
  this->Displace->SetCurvesConnection(curves);
  this->Displace->SetSketchConnection(sketched ? this->Sketch->GetOutputPort(1) : nullptr);
}

// A silhouette's stretch and its sketch are of the mesh as it was.
bool vtkOversketchAugment::Pipeline::ReadsSource() const
{
  vtkFieldData* data = this->Base->GetOutput()->GetFieldData();
  return this->Self->SketchMode == Surface &&
         (this->Self->Base == Simplified || data->GetArray("TerrainGray"));
}

void vtkOversketchAugment::Pipeline::FeedMesh(vtkPolyData* mesh)
{
  // Welding asks for the attributes too: they tell seams from points that were split for nothing.
  const auto key = [this, mesh]
  {
    std::vector<vtkDataArray*> arrays{ mesh->GetCellData()->GetNormals(),
      mesh->GetCellData()->GetArray("StellarRoot"),
      mesh->GetCellData()->GetArray("StellarPath"),
      mesh->GetCellData()->GetArray("StellarGen") };
    for (int a = 0; this->Welding && a < mesh->GetPointData()->GetNumberOfArrays(); ++a)
    {
      arrays.push_back(mesh->GetPointData()->GetArray(a));
    }
    return MeshKey(mesh, arrays);
  };
  const std::pair<const vtkPolyData*, vtkMTimeType> seen{ mesh, mesh->GetMTime() };
  if (seen == this->MeshSeen)
  {
    return;
  }
  const bool whole = HasWholeMeasures(mesh->GetPointData());
  const bool known =
    this->Start->GetNumberOfPoints() > 0 && whole == this->WholeSeen && key() == this->MeshKeySeen;
  this->MeshSeen = { nullptr, 0 };
  if (!known)
  {
    this->Plain->ShallowCopy(mesh);
    RemoveStellarArrays(this->Plain);
    this->Start->Initialize();
    this->Welding = std::make_unique<oversketch::Weld>(this->Plain);
    vtkPolyData* welded = this->Welding->Welded();
    if (welded->GetPoints() == mesh->GetPoints() && !mesh->GetCellData()->GetNormals() && !whole)
    {
      this->Welding = nullptr; // the steps carry arrays themselves
    }
    else
    {
      std::vector<vtkIdType> firsts(static_cast<std::size_t>(welded->GetNumberOfPoints()));
      for (vtkIdType i = mesh->GetNumberOfPoints() - 1; i >= 0; --i)
      {
        firsts[this->Welding->VertexOf(i)] = i;
      }
      this->Start->ShallowCopy(welded);
      AddPlaces(this->Start);
      this->Welding->PutMask(mesh, this->Start);
      CopyStellarArrays(mesh, firsts, this->Start);
    }
  }
  else if (this->Welding)
  {
    this->Plain->ShallowCopy(mesh);
    RemoveStellarArrays(this->Plain);
  }
  if (!this->Welding)
  {
    this->Start->ShallowCopy(mesh);
  }
  if (!known || !this->Welding)
  {
    this->MeshPass = -1;
  }
  this->MeshKeySeen = key();
  this->MeshSeen = seen;
  this->WholeSeen = whole;
}

void vtkOversketchAugment::Pipeline::RequireMaskKept() const
{
  if (this->Self->Base == Simplified && !MaskedPointsOf(this->Start).empty())
  {
    throw Error(Failure::BadMesh,
      "The mesh has masked points, which a coarser mesh in its place would not keep; set {Base Direct}, or "
      "clear the mask.");
  }
}

void vtkOversketchAugment::Pipeline::FeedStrokes(vtkPolyData* strokes, vtkPolyData* mesh)
{
  if (strokes->GetNumberOfPoints() == 0 || strokes->GetNumberOfCells() == 0)
  {
    throw Error(Failure::BadStroke, "There is no stroke; draw one over the mesh.");
  }
  const bool split = (this->Self->OneByOne || this->Self->SketchMode == Silhouette) &&
                     strokes->GetNumberOfLines() > 1 &&
                     strokes->GetNumberOfLines() == strokes->GetNumberOfCells();
  const std::pair<const vtkPolyData*, vtkMTimeType> seen{ strokes, strokes->GetMTime() };
  if (seen == this->StrokesSeen && !split && !this->SplitSeen)
  {
    return; // of several, radius and mesh say which act together
  }
  this->Passes.clear();
  if (split)
  {
    double box[6];
    mesh->GetCellsBounds(box);
    this->Passes = this->PassesOf(strokes,
      0.5 * Vector3(box[0] + box[1], box[2] + box[3], box[4] + box[5]),
      this->Self->Radius < 0.0 ? 0.03 * DiagonalOf(mesh) : this->Self->Radius);
  }
  else
  {
    this->Passes.push_back(vtkSmartPointer<vtkPolyData>::New());
    this->Passes[0]->ShallowCopy(strokes);
  }
  this->StrokesPass = -1;
  this->StrokesSeen = seen;
  this->SplitSeen = split;
}

void vtkOversketchAugment::Pipeline::FeedPass(std::size_t pass)
{
  const auto wanted = static_cast<long>(pass);
  if (this->MeshPass != wanted || wanted > 0)
  {
    this->Mesh->ShallowCopy(wanted == 0 ? this->Start.Get() : this->Self->StageOutput(this->LastName()));
    this->MeshPass = wanted;
  }
  if (this->PassCount() > 1)
  {
    this->Displace->SetKeepBaseNormals(!this->Self->AsPublished && pass + 1 < this->PassCount());
  }
  if (!this->Passes.empty() && this->StrokesPass != wanted)
  {
    this->Strokes->ShallowCopy(this->Passes[pass]);
    this->StrokesPass = wanted;
  }
}

void vtkOversketchAugment::Pipeline::SetShape(vtkOversketchStellarDisplace* step,
  double radius,
  const std::string& profile,
  double height,
  double sharpness) const
{
  const vtkOversketchAugment* self = this->Self;
  step->SetRadius(radius);
  step->SetHeight(height);
  step->SetSharpness(sharpness);
  step->SetProfile(profile.c_str());
  step->SetUsePressure(self->UsePressure);
  step->SetTaper(self->Taper);
  step->SetCombine(self->AsPublished ? Sum : self->Combine);
  step->SetDistance(self->Distance);
}

void vtkOversketchAugment::Pipeline::SetParameters()
{
  const vtkOversketchAugment* self = this->Self;
  for (const auto& [value, name] : { std::make_pair(self->Radius, "Radius"),
         std::make_pair(self->Height, "Height"),
         std::make_pair(self->Sharpness, "Sharpness"),
         std::make_pair(self->Taper, "Taper"),
         std::make_pair(self->TargetEdgeLength, "TargetEdgeLength") })
  {
    if (!std::isfinite(value))
    {
      throw Error(Failure::BadStroke, "{%1} is not a finite number; set another.", name);
    }
  }
  const double radius = self->Radius < 0.0 ? 0.03 * DiagonalOf(this->Shape) : self->Radius;
  this->PassRadius = radius;
  this->PassProfile = self->GetProfile();
  double least = radius; // of all strokes
  if (vtkDataArray* own = this->Strokes->GetCellData()->GetArray("Radius"))
  {
    least = HUGE_VAL;
    for (vtkIdType i = 0; i < own->GetNumberOfTuples(); ++i)
    {
      const double r = own->GetComponent(i, 0);
      least = r > 0.0 ? std::min(least, r) : least;
    }
    least = std::isfinite(least) ? least : radius;
  }
  for (vtkOversketchSurfaceStroke* step : { this->Curves.Get(), this->CurvesOnSource.Get() })
  {
    step->SetTolerance(self->AsPublished ? 0.0 : curveTolerance * least);
  }
  this->Sketch->SetMaximumStep(least);
  this->SetEdges(this->Refine, radius);
  this->SetEdges(this->RefineOnSource, radius);
  // A front's distances are not known within edges.
  this->Snap->SetSnapFoot(!self->AsPublished && self->Distance == Straight);
  this->Snap->SetRadius(radius);
  this->Snap->SetSharpness(this->Refine->GetSharpness());
  this->SetShape(this->Displace, radius, this->PassProfile, self->Height, self->Sharpness);
  this->Simplify->SetRadius(radius);
  this->Simplify->SetDistance(self->Distance);
}

void vtkOversketchAugment::Pipeline::SetEdges(vtkOversketchStellarRefine* step, double radius) const
{
  const vtkOversketchAugment* self = this->Self;
  step->SetRadius(radius);
  step->SetTargetEdgeLength(self->TargetEdgeLength);
  step->SetDistance(self->Distance);
  // It is to stay while it does not depend on the profile, of which it reads whether the sharpness is below
  // 1, up to 2 or above.
  step->SetSharpness(self->Sharpness > 2.0                             ? 3.0
                     : self->Sharpness >= 0.0 && self->Sharpness < 1.0 ? 0.5
                                                                       : 1.5);
}

void vtkOversketchAugment::Pipeline::RunBase(vtkPolyData* mesh)
{
  this->Base->SetInputData(0, mesh);
  this->Self->RunStage("Base");
  PutShape(this->Self->StageOutput("Base"), this->Shape, this->ShapeKeySeen);
  this->Connect();
}

void vtkOversketchAugment::Pipeline::PrepareRays()
{
  if (this->Self->SketchMode == Surface)
  {
    this->Self->RunStage("Curves", [this] { this->Curves->Prepare(); });
  }
}

void vtkOversketchAugment::Pipeline::RunCurves()
{
  this->SetParameters();
  this->Self->RunStage("Thinning");
  this->Self->RunStage("Chaikin");
  if (this->Self->SketchMode == Silhouette)
  {
    for (const char* name : { "Silhouette", "Visibility", "Sketch" })
    {
      this->Self->RunStage(name);
    }
  }
  else
  {
    this->Self->RunStage("Curves");
  }
  this->WidenDent();
}

// What hides a dent has to move with it. A bell that ends at 1.6 times as far as that hides it moves all of
// it far enough where the surface is round: (1 + cos(pi d / r)) / 2 is above 1 - (d / hidden)^2 from r
// = 1.57.
void vtkOversketchAugment::Pipeline::WidenDent()
{
  constexpr double wide = 1.6;
  constexpr int steps = 24; // of the bell
  vtkDataArray* hidden = this->Self->SketchMode == Silhouette
                           ? this->Sketch->GetOutput()->GetFieldData()->GetArray("Hidden")
                           : nullptr;
  const double radius = hidden ? wide * hidden->GetComponent(0, 0) : 0.0;
  if (radius <= this->PassRadius || this->Strokes->GetCellData()->GetArray("Radius"))
  {
    return;
  }
  if (this->Self->TargetEdgeLength == 0.0)
  {
    this->Refine->SetTargetEdgeLength(0.5 * this->PassRadius);
  }
  this->PassRadius = radius;
  this->Refine->SetRadius(radius);
  this->Snap->SetRadius(radius);
  this->Displace->SetRadius(radius);
  this->Simplify->SetRadius(radius);
  if (this->PassProfile.empty())
  {
    for (int i = 0; i <= steps; ++i)
    {
      const double x = static_cast<double>(i) / steps;
      this->PassProfile +=
        (i ? ", " : "") + std::to_string(x) + " " + std::to_string(0.5 + 0.5 * std::cos(std::acos(-1.0) * x));
    }
    this->Displace->SetProfile(this->PassProfile.c_str());
  }
}

void vtkOversketchAugment::Pipeline::RunFeature()
{
  this->Self->RunStage("Refine");
  if (this->ReadsSource())
  {
    PutShape(this->Self->StageOutput("Refine"), this->RefinedShape, this->RefinedKeySeen);
    this->Self->RunStage("CurvesOnSource");
    this->Self->RunStage("RefineOnSource");
  }
  for (const char* name : { "Snap", "Smooth", "Displace" })
  {
    this->Self->RunStage(name);
  }
  if (this->Self->Simplify)
  {
    this->Self->RunStage("Simplify");
  }
}

void vtkOversketchAugment::Pipeline::PutOutput(vtkPolyData* output)
{
  vtkPolyData* last = this->Self->StageOutput(this->LastName());
  std::vector<vtkIdType> vertices; // of last, per point of the output
  if (this->Welding)
  {
    vtkNew<vtkPolyData> sourced, split;
    sourced->ShallowCopy(last);
    const double done = this->Self->GetDone();
    AddSources(this->Start, sourced, ContextOf(this->Self, done, done));
    const std::vector<int> made = this->Welding->Transfer(this->Plain, { sourced.Get() }, split);
    vertices = PutSplit(split, made, last, output);
  }
  else
  {
    output->ShallowCopy(last);
    vertices.resize(static_cast<std::size_t>(last->GetNumberOfPoints()));
    std::iota(vertices.begin(), vertices.end(), vtkIdType(0));
  }
  auto made = std::make_unique<Result>();
  vtkPolyData* displaced = this->Self->StageOutput("Displace");
  made->Smooth->ShallowCopy(this->Self->StageOutput("Smooth"));
  made->Displaced->ShallowCopy(displaced);
  made->Curves->ShallowCopy(this->Self->StageOutput(this->CurvesName()));
  made->Radius = this->PassRadius;
  made->Profile = this->PassProfile;
  if (this->Self->SketchMode == Silhouette)
  {
    made->Sketch->ShallowCopy(this->Sketch->GetSketchOutput());
  }
  made->Last->ShallowCopy(last);
  if (this->PassCount() == 1)
  {
    for (vtkIdType& vertex : vertices)
    {
      vertex = this->Self->Simplify ? this->Simplify->GetInputPoint(vertex) : vertex;
    }
    made->Numbers = std::move(vertices);
  }
  this->Made = std::move(made);
}

void vtkOversketchAugment::Pipeline::PutCrest(vtkPolyData* crest)
{
  vtkPolyData* curves = this->Self->StageOutput(this->DrawnName());
  vtkPolyData* sketch = this->Self->SketchMode == Silhouette ? this->Sketch->GetSketchOutput() : nullptr;
  Polylines lines;
  const auto parts = NewArray<vtkIntArray>("Part");
  const auto numbers = NewArray<vtkIntArray>("CurveId");
  const FeatureCurves read = CurvesOf(curves), sketches = sketch ? CurvesOf(sketch) : FeatureCurves();
  for (std::size_t c = 0; c < read.size(); ++c)
  {
    const FeatureCurve& curve = read[c];
    const double radius = curve.radius.value_or(this->PassRadius);
    const double height = this->Self->Height == 0.0 ? 0.5 * radius : this->Self->Height;
    const FeaturePreview preview = previewFeature(curve,
      radius,
      height,
      this->Self->UsePressure,
      this->Self->Taper,
      sketch ? &sketches[c].points : nullptr);
    int part = 0;
    for (const std::vector<Vector3>* line : { &preview.crest, &preview.left, &preview.right })
    {
      lines.Add(*line, curve.closed);
      parts->InsertNextValue(part++);
      numbers->InsertNextValue(static_cast<int>(c));
    }
  }
  lines.Put(crest);
  crest->GetCellData()->AddArray(parts);
  crest->GetCellData()->AddArray(numbers);
}

void vtkOversketchAugment::Pipeline::Reshape(double height, double sharpness, vtkPoints* points)
{
  this->Reshaped->SetInputData(0, this->Made->Smooth);
  this->Reshaped->SetInputData(1, this->Made->Curves);
  const bool sketched = this->Made->Sketch->GetNumberOfPoints() > 0;
  this->Reshaped->SetInputData(2, sketched ? this->Made->Sketch.Get() : nullptr);
  this->SetShape(this->Reshaped, this->Made->Radius, this->Made->Profile, height, sharpness);
  this->Reshaped->SetConnectedOnly(this->Displace->GetConnectedOnly());
  this->Reshaped->SetHoldBack(this->Displace->GetHoldBack());
  this->Reshaped->SetNormals(this->Displace->GetNormals());
  StepRunner(this->Reshaped, {}).Run();
  vtkPolyData* shaped = this->Reshaped->GetOutput();
  vtkDataArray* before = this->Made->Displaced->GetPointData()->GetArray("Feature");
  vtkDataArray* now = shaped->GetPointData()->GetArray("Feature");
  for (std::size_t i = 0; i < this->Made->Numbers.size(); ++i)
  {
    const vtkIdType vertex = this->Made->Numbers[i];
    if (now->GetComponent(vertex, 0) != 0.0 || before->GetComponent(vertex, 0) != 0.0)
    {
      points->SetPoint(static_cast<vtkIdType>(i), shaped->GetPoint(vertex));
    }
  }
  points->Modified();
}
