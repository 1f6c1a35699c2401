#include "vtkOversketchEdit.h"

#include "vtkOversketchEditPipeline.h"
#include "vtkOversketchEditRemarks.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <locale>
#include <sstream>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchEdit);

vtkOversketchEdit::vtkOversketchEdit()
  : Inner(new Pipeline(this))
{
  this->SetNumberOfInputPorts(7);
  this->SetNumberOfOutputPorts(3);
  DeclareInput(this, 3, { Port::Optional });
  DeclareInput(this, 4, { Port::Optional });
  DeclareInput(this, 5, { Port::Image, Port::Optional });
  DeclareInput(this, 6, { Port::Optional });
}

vtkOversketchEdit::~vtkOversketchEdit() = default;

int vtkOversketchEdit::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  const int done = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  if (vtkInformation* image = inputs[5]->GetInformationObject(0))
  {
    using Streaming = vtkStreamingDemandDrivenPipeline;
    image->Set(Streaming::UPDATE_EXTENT(), image->Get(Streaming::WHOLE_EXTENT()), 6);
  }
  return done;
}

int vtkOversketchEdit::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Pipeline& inner = *this->Inner;
  inner.Made = nullptr;
  Message remark;
  const int done = this->RunSystem(
    [&]
    {
      vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
      if (mesh->GetNumberOfPoints() == 0)
      {
        return;
      }
      RequireFinite(this->ProfileAt, "ProfileAt");
      const Pipeline::Inputs all = Pipeline::InputsOf(inputs);
      inner.FeedMesh(mesh);
      inner.FeedEdit(all, this->Operations);
      try
      {
        inner.RunToWeights(all);
      }
      catch (const Error& error)
      {
        if (error.failure() != Failure::BadRegion || this->AsPublished)
        {
          throw;
        }
        const Message circle = inner.CircleThatWouldDo(all);
        throw Error(
          error.failure(), circle.empty() ? error.message() : Message::joined({ error.message(), circle }));
      }
      inner.RunDeform();
      inner.RunTriangles();
      inner.PutOutput(mesh,
        vtkPolyData::GetData(outputs, 0),
        vtkPolyData::GetData(outputs, 1),
        vtkPolyData::GetData(outputs, 2));
      const EditFigures& figures = inner.Made->Figures;
      const Message said = RemarkOf(figures);
      constexpr int few = 10; // pairs of triangles
      if (!this->AsPublished && figures.depth > 0.0 && figures.crossings > few)
      {
        throw Error(Failure::BadStroke, said);
      }
      remark = said;
    });
  this->SetRemark(remark);
  return done;
}

bool vtkOversketchEdit::Prepare()
{
  Pipeline& inner = *this->Inner;
  return inner.Outside(
    [&](const Pipeline::Inputs& inputs)
    {
      const auto isDrawn = [](vtkPolyData* curve) { return curve && curve->GetNumberOfPoints() > 0; };
      inner.FeedMesh(inputs.Mesh);
      inner.FeedEdit(inputs, this->Operations);
      inner.SetParameters();
      if (isDrawn(inputs.Reference) && isDrawn(inputs.Boundary))
      {
        inner.RunToWeights(inputs);
        return true;
      }
      inner.RunGround(nullptr, nullptr);
      SharedMesh(inner.Start)->Normals(); // of which those of the mesh with line and ring will be made
      if (isDrawn(inputs.Reference))
      {
        inner.RunReference(inputs.Reference);
      }
      return true;
    });
}

bool vtkOversketchEdit::PreviewEdit(vtkPolyData* edited)
{
  return this->Inner->Show(this->Operations, edited);
}

bool vtkOversketchEdit::DragLine(double right, double up, vtkPolyData* edited)
{
  std::ostringstream operations;
  operations.imbue(std::locale::classic());
  operations.precision(17);
  operations << this->Operations << "; drag " << right << ' ' << up;
  return this->Inner->Show(operations.str(), edited);
}

int vtkOversketchEdit::GetMovedPoints()
{
  return this->Inner->Made ? this->Inner->Made->MovedPoints : 0;
}

vtkOversketchSystem::FigureList vtkOversketchEdit::Figures()
{
  if (!this->Inner->Made)
  {
    return {};
  }
  const EditFigures& figures = this->Inner->Made->Figures;
  return { { "edit.bridges", this->Inner->Made->Bridges },
    { "edit.moved_points", this->Inner->Made->MovedPoints },
    { "edit.folded_edges", figures.folds },
    { "edit.crossings", figures.crossings },
    { "edit.share_seen", figures.shareSeen } };
}

void vtkOversketchEdit::GetHold(vtkPolyData* hold)
{
  hold->Initialize();
  if (this->Inner->Made)
  {
    hold->ShallowCopy(this->Inner->Made->Reference);
  }
}

void vtkOversketchEdit::GetRegion(vtkPolyData* region)
{
  region->Initialize();
  if (this->Inner->Made)
  {
    PutTriangles(this->Inner->Made->Output, this->Inner->Made->Moved, 1, region);
  }
}

void vtkOversketchEdit::SetOperations(const char* text)
{
  SetText(this, this->Operations, text);
}

void vtkOversketchEdit::SetLayers(const char* text)
{
  SetText(this, this->Layers, text);
}

void vtkOversketchEdit::SetAsPublished(bool published)
{
  if (published != this->AsPublished)
  {
    this->AsPublished = published;
    this->Inner->SetAmendments(!published);
    this->Modified();
  }
}

void vtkOversketchEdit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operations: " << this->Operations << "\n";
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "ProfileAt: " << this->ProfileAt << "\n";
  os << indent << "Falloff: " << this->Falloff << "\n";
  os << indent << "UseTexture: " << this->UseTexture << "\n";
  os << indent << "Feather: " << this->Feather << "\n";
  os << indent << "Rule: " << this->Rule << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "MovedPoints: " << this->GetMovedPoints() << "\n";
}
