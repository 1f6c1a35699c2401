#include "vtkOversketchAugment.h"

#include "vtkOversketchAugmentPipeline.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchAugment);

vtkOversketchAugment::vtkOversketchAugment()
  : Inner(new Pipeline(this))
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchAugment::~vtkOversketchAugment() = default;

int vtkOversketchAugment::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Pipeline& inner = *this->Inner;
  inner.Made = nullptr;
  inner.Counted = std::nullopt;
  const int done = this->RunOnMesh(inputs,
    outputs,
    [&](vtkPolyData* mesh, vtkPolyData* output)
    {
      inner.FeedStrokes(vtkPolyData::GetData(inputs[1]), mesh);
      inner.FeedMesh(mesh);
      inner.RequireMaskKept();
      inner.Counted.emplace();
      this->SetPasses(inner.PassCount());
      for (std::size_t pass = 0; pass < inner.PassCount(); ++pass)
      {
        inner.FeedPass(pass);
        inner.LayCurves();
        inner.RunFeature();
        inner.AddFigures();
      }
      inner.PutOutput(output);
    });
  this->SetRemark(inner.Remark());
  return done;
}

bool vtkOversketchAugment::Prepare()
{
  return this->TryPrepare(
    [this](vtkPolyData* mesh)
    {
      this->Inner->FeedMesh(mesh);
      this->Inner->FeedPass(0);
      this->Inner->RunBase(this->Inner->Mesh);
      this->Inner->PrepareRays();
    });
}

bool vtkOversketchAugment::Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold)
{
  return this->TryPreview(mesh,
    stroke,
    hold,
    [&]
    {
      this->Inner->FeedMesh(mesh);
      const bool drawn = stroke->GetNumberOfPoints() > 1;
      if (drawn)
      {
        this->Inner->FeedStrokes(stroke, mesh);
      }
      this->Inner->FeedPass(0);
      this->Inner->RunBase(this->Inner->Mesh);
      if (!drawn)
      {
        this->Inner->PrepareRays();
        return false;
      }
      this->Inner->RunCurves();
      hold->ShallowCopy(this->StageOutput(this->Inner->DrawnName()));
      return hold->GetNumberOfPoints() > 0;
    });
}

bool vtkOversketchAugment::PreviewCrest(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* crest)
{
  crest->Initialize();
  vtkNew<vtkPolyData> curves;
  return this->Preview(mesh, stroke, curves) && this->Try(
                                                  [&]
                                                  {
                                                    this->Inner->PutCrest(crest);
                                                    return true;
                                                  });
}

bool vtkOversketchAugment::Reshape(double height, double sharpness, vtkPoints* points)
{
  if (!this->Inner->Made || this->Inner->Made->Numbers.empty())
  {
    return false;
  }
  if (!points || points->GetNumberOfPoints() != static_cast<vtkIdType>(this->Inner->Made->Numbers.size()))
  {
    vtkErrorMacro("The points to reshape do not fit; give a copy of the output's points.");
    return false;
  }
  return this->Try(
    [&]
    {
      this->Inner->Reshape(height, sharpness, points);
      return true;
    });
}

void vtkOversketchAugment::GetHold(vtkPolyData* hold)
{
  hold->Initialize();
  if (this->Inner->Made)
  {
    hold->ShallowCopy(this->Inner->Made->Curves);
  }
}

void vtkOversketchAugment::GetRegion(vtkPolyData* region)
{
  region->Initialize();
  vtkPolyData* mesh = this->Inner->Made ? this->Inner->Made->Last.Get() : nullptr;
  if (vtkDataArray* feature = mesh ? mesh->GetPointData()->GetArray("Feature") : nullptr)
  {
    PutTriangles(mesh, LabelsOf(feature), 1, region);
  }
}

void vtkOversketchAugment::BackendChanged()
{
  this->Inner->Visibility->SetBackend(this->GetBackend());
}

int vtkOversketchAugment::GetBackendUsed()
{
  return this->SketchMode == Silhouette ? this->Inner->Visibility->GetBackendUsed() : Host;
}

void vtkOversketchAugment::SetBase(int base)
{
  base = std::clamp<int>(base, Direct, Simplified);
  if (base != this->Base)
  {
    this->Base = base;
    this->Inner->Base->SetMode(base);
    this->Modified();
  }
}

void vtkOversketchAugment::SetSketchMode(int mode)
{
  mode = std::clamp<int>(mode, Surface, Silhouette);
  if (mode != this->SketchMode)
  {
    this->SketchMode = mode;
    this->Inner->Connect();
    this->Modified();
  }
}

void vtkOversketchAugment::SetProfile(const char* text)
{
  SetText(this, this->Profile, text);
}

void vtkOversketchAugment::SetAsPublished(bool published)
{
  if (published != this->AsPublished)
  {
    this->AsPublished = published;
    this->Inner->SetAmendments(!published);
    this->Modified();
  }
}

void vtkOversketchAugment::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Base: " << this->Base << "\n";
  os << indent << "SketchMode: " << this->SketchMode << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Sharpness: " << this->Sharpness << "\n";
  os << indent << "Profile: " << this->Profile << "\n";
  os << indent << "UsePressure: " << this->UsePressure << "\n";
  os << indent << "Taper: " << this->Taper << "\n";
  os << indent << "Combine: " << this->Combine << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
  os << indent << "OneByOne: " << this->OneByOne << "\n";
  os << indent << "Simplify: " << this->Simplify << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
}
