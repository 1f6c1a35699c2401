#include "vtkOversketchInflateDrawing.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchInflateDrawingPipeline.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchInflateDrawing);

vtkOversketchInflateDrawing::vtkOversketchInflateDrawing()
  : Inner(new Pipeline(this))
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 0, { Port::Optional });
  DeclareInput(this, 1, { Port::Image, Port::Optional });
  DeclareInput(this, 2, { Port::Image, Port::Optional });
}

vtkOversketchInflateDrawing::~vtkOversketchInflateDrawing() = default;

int vtkOversketchInflateDrawing::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  Pipeline& inner = *this->Inner;
  this->Rebuilds = this->LevelsMade = 0;
  return this->RunSystem(
    [&]
    {
      vtkPolyData* strokes = vtkPolyData::GetData(inputs[0]);
      const bool isDrawn = strokes && strokes->GetNumberOfPoints() > 0;
      if (!isDrawn && this->Trace.empty())
      {
        if (!strokes)
        {
          throw Error(Failure::BadStroke,
            "There are no strokes; give a drawing, or a picture in which {Trace} finds outlines.");
        }
        return;
      }
      vtkImageData *picture = vtkImageData::GetData(inputs[1]), *back = vtkImageData::GetData(inputs[2]);
      if (this->BackFromRim && back)
      {
        Warn(this, "The back wears the picture that was given of it; {BackFromRim} does nothing.");
      }
      inner.FeedPicture(picture);
      inner.FeedStrokes(isDrawn ? strokes : nullptr);
      inner.FeedBack(this->BackFromRim && !back ? picture : back);
      inner.FeedTreatments();
      inner.Run(vtkPolyData::GetData(outputs));
    });
}

vtkOversketchSystem::FigureList vtkOversketchInflateDrawing::Figures()
{
  if (this->GetOutput()->GetNumberOfPolys() == 0)
  {
    return {};
  }
  const char* const words[] = { "rejected", "unknown", "boundary", "closed feature", "open feature" };
  std::vector<std::string> strokes;
  int layer = 1;
  for (vtkOversketchInflateDrawing* system = this; system; system = this->GetLayer(layer++))
  {
    vtkDataArray* roles = system->StageOutput("Treatment")->GetCellData()->GetArray("Role");
    for (vtkIdType i = 0; roles && i < roles->GetNumberOfTuples(); ++i)
    {
      strokes.emplace_back(words[std::clamp(static_cast<int>(roles->GetComponent(i, 0)), -1, 3) + 1]);
    }
  }
  return { { "strokes", strokes }, { "rebuilds", this->Rebuilds }, { "levels", this->LevelsMade } };
}

void vtkOversketchInflateDrawing::SetExtrudeDepth(double depth)
{
  depth = std::max(depth, 0.0);
  if (depth != this->ExtrudeDepth)
  {
    const bool other = (depth > 0.0) != (this->ExtrudeDepth > 0.0);
    this->ExtrudeDepth = depth;
    this->Inner->Extrude->SetDepth(depth);
    if (other)
    {
      this->Inner->Connect();
    }
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::SetProfile(const char* text)
{
  SetText(this, this->Profile, text);
  this->Inner->Inflate->SetProfile(text);
}

void vtkOversketchInflateDrawing::SetHeight(double factor)
{
  if (factor != this->Height)
  {
    this->Height = factor;
    this->Inner->Inflate->SetHeightFactor(factor);
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::SetPoisson(bool poisson)
{
  if (poisson != this->Poisson)
  {
    this->Poisson = poisson;
    this->Inner->Inflate->SetMode(poisson ? vtkOversketchInflate::Poisson : vtkOversketchInflate::Circular);
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::SetHoles(const char* strokes)
{
  SetText(this, this->Holes, strokes);
}

void vtkOversketchInflateDrawing::SetTunnels(const char* strokes)
{
  SetText(this, this->Tunnels, strokes);
}

void vtkOversketchInflateDrawing::SetInFront(const char* strokes)
{
  SetText(this, this->InFront, strokes);
}

void vtkOversketchInflateDrawing::SetBehind(const char* strokes)
{
  SetText(this, this->Behind, strokes);
}

void vtkOversketchInflateDrawing::SetBothSides(const char* strokes)
{
  SetText(this, this->BothSides, strokes);
}

vtkOversketchInflateDrawing* vtkOversketchInflateDrawing::GetLayer(int layer)
{
  const std::vector<DrawingLayer>& layers = this->Inner->Layers;
  return layer > 0 && layer < static_cast<int>(layers.size())
           ? layers[static_cast<std::size_t>(layer)].System.Get()
           : nullptr;
}

Message vtkOversketchInflateDrawing::Said(const Message& message)
{
  const DrawingLayer* layer = this->Inner->SayingOf;
  return layer ? message.renumbered(
                   [layer](int stroke) { return layer->Numbers[static_cast<std::size_t>(stroke)]; })
               : message;
}

void vtkOversketchInflateDrawing::SetTrace(const char* places)
{
  SetText(this, this->Trace, places);
}

void vtkOversketchInflateDrawing::SetMagnetic(bool magnetic)
{
  if (magnetic != this->Magnetic)
  {
    this->Magnetic = magnetic;
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::SetQuads(bool quads)
{
  if (quads != this->Quads)
  {
    this->Quads = quads;
    this->Inner->Refine->SetQuads(quads);
    this->Inner->Connect();
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::SetLevels(int levels)
{
  if (levels != this->Levels)
  {
    this->Levels = levels;
    this->Inner->Refine->SetLevels(levels);
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::SetArrange(bool arrange)
{
  if (arrange != this->Arrange)
  {
    this->Arrange = arrange;
    this->Inner->Connect();
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::SetBackFromRim(bool fromRim)
{
  if (fromRim != this->BackFromRim)
  {
    this->BackFromRim = fromRim;
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::SetAsPublished(bool published)
{
  if (published != this->AsPublished)
  {
    this->AsPublished = published;
    this->Inner->SetAmendments(!published);
    this->Modified();
  }
}

void vtkOversketchInflateDrawing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ExtrudeDepth: " << this->ExtrudeDepth << "\n";
  os << indent << "Profile: " << this->Profile << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Poisson: " << this->Poisson << "\n";
  os << indent << "Holes: " << this->Holes << "\n";
  os << indent << "Tunnels: " << this->Tunnels << "\n";
  os << indent << "InFront: " << this->InFront << "\n";
  os << indent << "Behind: " << this->Behind << "\n";
  os << indent << "BothSides: " << this->BothSides << "\n";
  os << indent << "Trace: " << this->Trace << "\n";
  os << indent << "Magnetic: " << this->Magnetic << "\n";
  os << indent << "Quads: " << this->Quads << "\n";
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Arrange: " << this->Arrange << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "BackFromRim: " << this->BackFromRim << "\n";
  os << indent << "Rebuilds: " << this->Rebuilds << "\n";
  os << indent << "LevelsMade: " << this->LevelsMade << "\n";
}
