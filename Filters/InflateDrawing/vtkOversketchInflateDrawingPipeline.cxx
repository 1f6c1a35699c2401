#include "vtkOversketchInflateDrawingPipeline.h"

#include "Planar/refine.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchPlanarTools.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchTraceTools.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"

#include <algorithm>

using namespace oversketch;

namespace
{

constexpr int mostRebuilds = 24;
constexpr const char* noObject = "No stroke bounds an object; draw a closed outline that crosses nothing.";

} // namespace

vtkOversketchInflateDrawing::Pipeline::Pipeline(vtkOversketchInflateDrawing* self)
  : Self(self)
{
  this->Trace->SetInputData(0, this->Picture);
  this->Canvas->SetInputData(0, this->Strokes);
  this->Snap->SetInputConnection(0, this->Canvas->GetOutputPort());
  this->Snap->SetInputData(1, this->Picture);
  this->Arrange->SetInputConnection(0, this->Resample->GetOutputPort());
  this->Treatment->SetInputConnection(0, this->Classify->GetOutputPort());
  this->Distance->SetInputConnection(0, this->Treatment->GetOutputPort());
  this->Polyline->SetInputConnection(0, this->Distance->GetOutputPort(0));
  this->Polyline->SetInputConnection(1, this->Distance->GetOutputPort(1));
  this->Polyline->SetInputData(2, this->Splits);
  this->Darts->SetInputConnection(0, this->Polyline->GetOutputPort());
  this->Darts->SetInputConnection(1, this->Distance->GetOutputPort(1));
  this->CoarseMesh->SetInputConnection(0, this->Polyline->GetOutputPort());
  this->CoarseMesh->SetInputConnection(1, this->Darts->GetOutputPort());
  this->QuadMerge->SetInputConnection(0, this->CoarseMesh->GetOutputPort(0));
  this->QuadMerge->SetInputConnection(1, this->CoarseMesh->GetOutputPort(1));
  this->Refine->SplitsAreTakenOn();
  this->Refine->LargeFacesOnceMoreOn();
  this->Refine->SetInputConnection(2, this->Distance->GetOutputPort(0));
  this->Inflate->SetInputConnection(0, this->Refine->GetOutputPort(0));
  this->Inflate->SetInputConnection(1, this->Distance->GetOutputPort(1));
  this->Extrude->SetInputConnection(0, this->Refine->GetOutputPort(0));
  this->Tunnel->SetInputConnection(1, this->Distance->GetOutputPort(0));
  this->Texture->SetInputConnection(0, this->Tunnel->GetOutputPort());
  this->Connect();

  self->AddStage("Trace", this->Trace, 0.05);
  self->AddStage("Canvas", this->Canvas, 0.01);
  self->AddStage("MagneticSnap", this->Snap, 0.1);
  self->AddStage("Resample", this->Resample, 0.01);
  self->AddStage("Arrange", this->Arrange, 0.01);
  self->AddStage("Classify", this->Classify, 0.05);
  self->AddStage("Treatment", this->Treatment, 0.01);
  self->AddStage("Distance", this->Distance, 0.15);
  self->AddStage("Polyline", this->Polyline, 0.02);
  self->AddStage("Darts", this->Darts, 0.05);
  self->AddStage("CoarseMesh", this->CoarseMesh, 0.05);
  self->AddStage("QuadMerge", this->QuadMerge, 0.01);
  self->AddStage("Refine", this->Refine, 0.09);
  self->AddStage("Inflate", this->Inflate, 0.35);
  self->AddStage("Extrude", this->Extrude, 0.02);
  self->AddStage("Tunnel", this->Tunnel, 0.01);
  self->AddStage("ProjectTexture", this->Texture, 0.01);
  self->AddStage("Layers", this->Assemble, 0.2);
  this->SetAmendments(true);
}

void vtkOversketchInflateDrawing::Pipeline::Connect()
{
  const bool pictured = this->PictureSeen.first != nullptr;
  this->Canvas->SetInputData(1, pictured ? this->Picture.Get() : nullptr);
  this->Texture->SetInputData(1, pictured ? this->Picture.Get() : nullptr);
  this->Resample->SetInputConnection(
    0, (pictured ? this->Snap->GetOutputPort() : this->Canvas->GetOutputPort()));
  this->Classify->SetInputConnection(
    0, this->Self->Arrange ? this->Arrange->GetOutputPort() : this->Resample->GetOutputPort());
  vtkAlgorithm* faces = this->Self->Quads ? static_cast<vtkAlgorithm*>(this->QuadMerge) : this->CoarseMesh;
  this->Refine->SetInputConnection(0, faces->GetOutputPort(0));
  this->Refine->SetInputConnection(1, faces->GetOutputPort(1));
  vtkAlgorithm* surface =
    this->Self->ExtrudeDepth > 0.0 ? static_cast<vtkAlgorithm*>(this->Extrude) : this->Inflate;
  this->Tunnel->SetInputConnection(0, surface->GetOutputPort(0));
}

void vtkOversketchInflateDrawing::Pipeline::FeedStrokes(vtkPolyData* strokes)
{
  if (this->SourceOf(strokes) == this->StrokesSeen)
  {
    return;
  }
  this->StrokesSeen = {}; // until they are made
  vtkNew<vtkPolyData> drawn;
  drawn->ShallowCopy(this->WithTraced(strokes));
  if (this->Self->Magnetic)
  {
    const auto magnetic = NewArray<vtkIntArray>("Magnetic", 1, drawn->GetNumberOfCells());
    magnetic->FillValue(1);
    drawn->GetCellData()->AddArray(magnetic);
  }
  std::vector<DrawingLayer> layers =
    LayersOf(drawn, this->PictureSeen.first ? this->Picture.Get() : nullptr, this->Depths());
  vtkPolyData* const before = this->Layers.empty() ? nullptr : this->Layers[0].Strokes.Get();
  TakeSystems(layers, this->Layers);
  if (layers.empty() || layers[0].Strokes != before)
  {
    this->Strokes->ShallowCopy(layers.empty() ? drawn.Get() : layers[0].Strokes.Get());
  }
  this->Layers.swap(layers);
  this->Drawn = static_cast<int>(drawn->GetNumberOfCells());
  this->StrokesSeen = this->SourceOf(strokes);
}

vtkSmartPointer<vtkPolyData> vtkOversketchInflateDrawing::Pipeline::WithTraced(vtkPolyData* strokes)
{
  vtkSmartPointer<vtkPolyData> all = strokes;
  const std::vector<Vector2> places = TracedPlaces(this->Self->Trace);
  if (!places.empty() && !this->PictureSeen.first)
  {
    throw Error(Failure::BadStroke,
      "{Trace} finds outlines in a picture, and there is none; give the picture, or draw the outlines.");
  }
  for (auto place = places.rbegin(); place != places.rend(); ++place) // each before what there is
  {
    this->Trace->SetPlace(place->x(), place->y());
    this->Self->RunStage("Trace");
    auto outlines = vtkSmartPointer<vtkPolyData>::New();
    outlines->ShallowCopy(this->Self->StageOutput("Trace"));
    all = all ? JoinedDrawings(outlines, all) : outlines;
  }
  return all;
}

void vtkOversketchInflateDrawing::Pipeline::FeedPicture(vtkImageData* picture)
{
  const std::pair<const vtkImageData*, vtkMTimeType> now{ picture, picture ? picture->GetMTime() : 0 };
  if (now == this->PictureSeen)
  {
    return;
  }
  const bool connect = !picture != !this->PictureSeen.first;
  this->PictureSeen = now;
  if (picture)
  {
    this->Picture->ShallowCopy(picture);
  }
  else
  {
    this->Picture->Initialize();
  }
  if (connect)
  {
    this->Connect();
  }
}

void vtkOversketchInflateDrawing::Pipeline::FeedBack(vtkImageData* picture)
{
  const std::pair<const vtkImageData*, vtkMTimeType> now{ picture, picture ? picture->GetMTime() : 0 };
  if (now != this->BackSeen)
  {
    this->BackSeen = now;
    this->Back->Initialize();
    if (picture)
    {
      this->Back->ShallowCopy(picture);
    }
    this->Texture->SetInputData(2, picture ? this->Back.Get() : nullptr);
  }
}

void vtkOversketchInflateDrawing::Pipeline::RunCurves()
{
  this->Self->RunStage("Canvas");
  if (this->PictureSeen.first)
  {
    this->Self->RunStage("MagneticSnap");
  }
  this->Self->RunStage("Resample");
  if (this->Self->Arrange)
  {
    this->Self->RunStage("Arrange");
  }
  try
  {
    this->Self->RunStage("Classify");
  }
  catch (const Error& error)
  {
    if (this->Self->Arrange || this->Classify->GetCrossingCount() == 0)
    {
      throw;
    }
    throw Error(error.failure(), "%1 Or let strokes cross: {Arrange on}.", error.message());
  }
  this->Self->RunStage("Treatment");
  this->Self->RunStage("Distance");
}

int vtkOversketchInflateDrawing::Pipeline::RunMesh()
{
  const std::vector<vtkMTimeType> now = { this->Distance->GetOutput()->GetMTime(),
    this->Distance->GetDistanceOutput()->GetMTime(),
    this->Polyline->GetMTime(),
    this->Darts->GetMTime(),
    this->CoarseMesh->GetMTime(),
    this->QuadMerge->GetMTime(),
    this->Refine->GetMTime() };
  if (now == this->MeshSeen)
  {
    return this->MeshRebuilds;
  }
  this->MeshSeen.clear(); // until it is made
  this->Splits->Initialize();
  std::vector<StrokeSplit> splits;
  for (int rebuilds = 0;; ++rebuilds)
  {
    this->Self->SetPasses(std::size_t(2) << rebuilds); // each round tells half of what is left to be told
    for (const char* stage : { "Polyline", "Darts", "CoarseMesh", "QuadMerge", "Refine" })
    {
      if (this->Self->Quads || std::string(stage) != "QuadMerge")
      {
        this->Self->RunStage(stage);
      }
    }
    vtkPolyData* handed = vtkPolyData::SafeDownCast(this->Refine->GetOutputDataObject(2));
    if (handed->GetNumberOfCells() == 0)
    {
      this->Self->SetPasses(1);
      this->MeshSeen = now;
      return this->MeshRebuilds = rebuilds;
    }
    const std::vector<StrokeSplit> more = SplitsOf(handed);
    if (rebuilds == mostRebuilds)
    {
      this->RefuseSplits(more[0]);
    }
    addSplits(splits, more);
    WriteSplits(splits, DrawingOf(this->Distance->GetOutput()).Strokes, this->Splits);
    this->Splits->Modified();
  }
}

void vtkOversketchInflateDrawing::Pipeline::RefuseSplits(const StrokeSplit& split)
{
  const std::vector<DrawnStroke> strokes = StrokesOf(this->Distance->GetOutput());
  const oversketch::Polyline& points = strokes[static_cast<std::size_t>(split.stroke)].points;
  const std::vector<double> lengths = arcLengths(points);
  const Vector2 at =
    placeAt(lengths, static_cast<int>(points.size()), 0.5 * (split.start + split.end)).of(points);
  const Message why(
    "{Stroke %1} still turns triangles over near {(%2, %3)} after %4 rebuilds of the mesh; draw it there "
    "with "
    "more room to what is beside it.",
    nameOf(strokes, split.stroke),
    at[0],
    at[1],
    mostRebuilds);
  throw Error(Failure::BadStroke, this->Self->Said(why));
}

void vtkOversketchInflateDrawing::Pipeline::RunSurface()
{
  this->Self->RunStage(this->Self->ExtrudeDepth > 0.0 ? "Extrude" : "Inflate");
  this->Self->RunStage("Tunnel");
  this->Self->RunStage("ProjectTexture");
}

void vtkOversketchInflateDrawing::Pipeline::FeedTreatments()
{
  if (this->Layers.empty())
  {
    this->Treatment->SetHoles(this->Self->Holes.c_str());
    this->Treatment->SetTunnels(this->Self->Tunnels.c_str());
    return;
  }
  const std::vector<int> holes = StrokeNumbers(this->Self->Holes, "Holes", this->Drawn),
                         tunnels = StrokeNumbers(this->Self->Tunnels, "Tunnels", this->Drawn);
  this->Treatment->SetHoles(this->Layers[0].Own(holes).c_str());
  this->Treatment->SetTunnels(this->Layers[0].Own(tunnels).c_str());
  for (std::size_t k = 1; k < this->Layers.size(); ++k)
  {
    this->Layers[k].System->SetHoles(this->Layers[k].Own(holes).c_str());
    this->Layers[k].System->SetTunnels(this->Layers[k].Own(tunnels).c_str());
  }
}

void vtkOversketchInflateDrawing::Pipeline::FeedLayer(const DrawingLayer& layer)
{
  const char* const sections[] = { this->Self->Profile.c_str(), "circle", "linear", "step" };
  vtkOversketchInflateDrawing* system = layer.System;
  system->SetAsPublished(this->Self->AsPublished);
  system->SetExtrudeDepth(this->Self->ExtrudeDepth * layer.Height);
  system->SetHeight(this->Self->Height * layer.Height);
  system->SetProfile(sections[layer.CrossSection]);
  system->SetPoisson(this->Self->Poisson && layer.CrossSection == 0);
  system->SetQuads(this->Self->Quads);
  system->SetLevels(this->Self->Levels);
  system->SetArrange(this->Self->Arrange);
  system->Inner->Refine->SetLevelsFromSketch(this->Refine->GetLevelsFromSketch());
  system->Inner->Inflate->SetUnstretchedRims(this->Inflate->GetUnstretchedRims());
  vtkDataObject* const inputs[] = { layer.Strokes,
    this->PictureSeen.first ? this->Picture.Get() : nullptr,
    this->BackSeen.first ? this->Back.Get() : nullptr };
  for (int port = 0; port < 3; ++port)
  {
    if (system->GetInputDataObject(port, 0) != inputs[port]) // data that are set again count as new ones
    {
      system->SetInputData(port, inputs[port]);
    }
  }
}

void vtkOversketchInflateDrawing::Pipeline::RunLayers(vtkPolyData* output)
{
  vtkOversketchInflateDrawing* self = this->Self;
  StepRunner::Listener listener;
  listener.progress = [this](double share) { this->Assemble->UpdateProgress(share); };
  listener.warning = [self](const Message& message) { Warn(self, self->Said(message)); };
  listener.cancelled = [self] { return self->GetAbortExecute() != 0; };
  self->SetPasses(this->Layers.size());
  for (std::size_t k = 1; k < this->Layers.size(); ++k)
  {
    this->FeedLayer(this->Layers[k]);
    const auto run = [&]
    {
      try
      {
        StepRunner(this->Layers[k].System, listener).Run();
      }
      catch (const Error& error)
      {
        if (error.message().id() != noObject) // which others may have
        {
          throw;
        }
      }
    };
    this->SayingOf = &this->Layers[k];
    self->RunStage("Layers", run);
  }
  this->SayingOf = nullptr;
  std::vector<LayerBody> bodies;
  for (const bool inPlane : { true, false })
  {
    for (std::size_t k = 0; k < this->Layers.size(); ++k)
    {
      vtkOversketchInflateDrawing* system = k == 0 ? self : this->Layers[k].System.Get();
      vtkPolyData* made = k == 0 ? self->StageOutput("ProjectTexture") : system->GetOutput();
      if ((this->Layers[k].Depth == 0) == inPlane && made->GetNumberOfPolys() > 0)
      {
        bodies.push_back({ made, system->StageOutput("Treatment"), static_cast<int>(k) });
      }
    }
  }
  if (bodies.empty())
  {
    throw Error(Failure::BadStroke, noObject);
  }
  const auto assemble = [&]
  {
    Context context = ContextOf(self);
    context.progress = [](double) {};
    const auto warn = [self](const Message& message) { Warn(self, message); };
    this->Assemble->RemoveAllInputConnections(0);
    for (vtkPolyData* body : PlacedBodies(this->Layers, bodies, warn, context))
    {
      this->Assemble->AddInputData(body);
    }
    this->Assemble->Update();
  };
  self->RunStage("Layers", assemble);
  output->ShallowCopy(self->StageOutput("Layers"));
  output->GetFieldData()->ShallowCopy(bodies[0].Made->GetFieldData());
  vtkDataArray* numbers = output->GetCellData()->GetArray("PartId");
  const auto parts = NewArray<vtkIntArray>("PartId", 1, static_cast<std::size_t>(output->GetNumberOfCells()));
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    parts->SetValue(i, static_cast<int>(numbers->GetComponent(i, 0)) % 2);
  }
  output->GetCellData()->RemoveArray("PartId");
  if (this->BackSeen.first) // each body has two parts, which wear one picture each
  {
    output->GetCellData()->AddArray(parts);
  }
}

void vtkOversketchInflateDrawing::Pipeline::Run(vtkPolyData* output)
{
  this->SayingOf = this->Layers.empty() ? nullptr : this->Layers.data();
  this->RunCurves();
  int rebuilds = this->RunMesh();
  this->RunSurface();
  vtkPolyData* made = this->Self->StageOutput("ProjectTexture");
  int levels = made->GetNumberOfPolys() > 0 ? this->Refine->GetLevelsMade() : 0;
  if (!this->Layers.empty())
  {
    this->RunLayers(output);
  }
  else if (made->GetNumberOfPolys() == 0)
  {
    throw Error(Failure::BadStroke, noObject);
  }
  else
  {
    output->ShallowCopy(made);
  }
  for (std::size_t k = 1; k < this->Layers.size(); ++k)
  {
    rebuilds += this->Layers[k].System->Rebuilds;
    levels = std::max(levels, this->Layers[k].System->LevelsMade);
  }
  this->Self->Rebuilds = rebuilds;
  this->Self->LevelsMade = levels;
}

void vtkOversketchInflateDrawing::Pipeline::SetAmendments(bool on)
{
  this->Snap->SetAsPublished(!on);
  this->Classify->SetAsPublished(!on);
  this->Polyline->SetAsPublished(!on);
  this->Darts->SetAsPublished(!on);
  this->CoarseMesh->SetRelax(on);
  this->Refine->SetAsPublished(!on);
  this->Inflate->SetAsPublished(!on);
  this->Tunnel->SetTunnelWall(on);
}
