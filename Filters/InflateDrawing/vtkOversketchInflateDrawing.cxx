#include "vtkOversketchInflateDrawing.h"

#include "Planar/refine.h"
#include "vtkOversketchArrange.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchCoarseMesh.h"
#include "vtkOversketchDarts.h"
#include "vtkOversketchDistance.h"
#include "vtkOversketchDrawingTools.h"
#include "vtkOversketchExtrude.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchInflate.h"
#include "vtkOversketchMagneticSnap.h"
#include "vtkOversketchPlanarRefine.h"
#include "vtkOversketchPlanarTools.h"
#include "vtkOversketchPolyline.h"
#include "vtkOversketchProjectTexture.h"
#include "vtkOversketchQuadMerge.h"
#include "vtkOversketchResample.h"
#include "vtkOversketchTrace.h"
#include "vtkOversketchTraceTools.h"
#include "vtkOversketchTreatment.h"
#include "vtkOversketchTunnel.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchInflateDrawing);

namespace
{

constexpr int mostRebuilds = 24;

} // namespace

struct vtkOversketchInflateDrawing::Pipeline
{
  explicit Pipeline(vtkOversketchInflateDrawing* self);

  // Bring the inner inputs up to date; they change only where what the steps read has changed.
  void FeedStrokes(vtkPolyData* strokes); // null: none
  void FeedPicture(vtkImageData* picture);
  void FeedBack(vtkImageData* picture);
  // Takes the steps that the parameters leave out of the way.
  void Connect();
  void SetAmendments(bool on);

  // Outlines that Trace asks for, and the strokes.
  vtkSmartPointer<vtkPolyData> WithTraced(vtkPolyData* strokes);
  void RunCurves();
  // Polyline to Refine, as often as parts of strokes are handed back. Returns how often.
  int RunMesh();
  void RunSurface();
  [[noreturn]] void RefuseSplits(const StrokeSplit& split);

  vtkOversketchInflateDrawing* Self;

  // Data that the inner pipeline starts from.
  vtkNew<vtkPolyData> Strokes;
  vtkNew<vtkImageData> Picture, Back;
  std::pair<const vtkImageData*, vtkMTimeType> PictureSeen{ nullptr, 0 }, BackSeen{ nullptr, 0 };
  // What the inner strokes were made of; times of what is traced are 0 where nothing is.
  using Source = std::tuple<const vtkPolyData*, vtkMTimeType, bool, std::string, vtkMTimeType, vtkMTimeType>;
  Source SourceOf(vtkPolyData* strokes)
  {
    const bool traces = !this->Self->Trace.empty();
    return { strokes,
      strokes ? strokes->GetMTime() : 0,
      this->Self->Magnetic,
      this->Self->Trace,
      traces ? this->Picture->GetMTime() : 0,
      traces ? this->Trace->GetMTime() : 0 };
  }
  Source StrokesSeen{};

  // Splits that were handed back for the present curves, and what these and the steps are told apart by.
  vtkNew<vtkPolyData> Splits;
  std::vector<vtkMTimeType> MeshSeen;
  int MeshRebuilds = 0;

  vtkNew<vtkOversketchTrace> Trace;
  vtkNew<vtkOversketchCanvas> Canvas;
  vtkNew<vtkOversketchMagneticSnap> Snap;
  vtkNew<vtkOversketchResample> Resample;
  vtkNew<vtkOversketchArrange> Arrange;
  vtkNew<vtkOversketchClassify> Classify;
  vtkNew<vtkOversketchTreatment> Treatment;
  vtkNew<vtkOversketchDistance> Distance;
  vtkNew<vtkOversketchPolyline> Polyline;
  vtkNew<vtkOversketchDarts> Darts;
  vtkNew<vtkOversketchCoarseMesh> CoarseMesh;
  vtkNew<vtkOversketchQuadMerge> QuadMerge;
  vtkNew<vtkOversketchPlanarRefine> Refine;
  vtkNew<vtkOversketchInflate> Inflate;
  vtkNew<vtkOversketchExtrude> Extrude;
  vtkNew<vtkOversketchTunnel> Tunnel;
  vtkNew<vtkOversketchProjectTexture> Texture;
};

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
  const vtkSmartPointer<vtkPolyData> drawn = this->WithTraced(strokes);
  this->Strokes->ShallowCopy(drawn);
  if (this->Self->Magnetic)
  {
    const auto magnetic = NewArray<vtkIntArray>("Magnetic", 1, drawn->GetNumberOfCells());
    magnetic->FillValue(1);
    this->Strokes->GetCellData()->AddArray(magnetic);
  }
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
  throw Error(Failure::BadStroke,
    "{Stroke %1} still turns triangles over near {(%2, %3)} after %4 rebuilds of the mesh; draw it there "
    "with "
    "more room to what is beside it.",
    nameOf(strokes, split.stroke),
    at[0],
    at[1],
    mostRebuilds);
}

void vtkOversketchInflateDrawing::Pipeline::RunSurface()
{
  this->Self->RunStage(this->Self->ExtrudeDepth > 0.0 ? "Extrude" : "Inflate");
  this->Self->RunStage("Tunnel");
  this->Self->RunStage("ProjectTexture");
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
      inner.RunCurves();
      const int rebuilds = inner.RunMesh();
      inner.RunSurface();
      vtkPolyData* made = this->StageOutput("ProjectTexture");
      if (made->GetNumberOfPolys() == 0)
      {
        throw Error(
          Failure::BadStroke, "No stroke bounds an object; draw a closed outline that crosses nothing.");
      }
      vtkPolyData::GetData(outputs)->ShallowCopy(made);
      this->Rebuilds = rebuilds;
      this->LevelsMade = inner.Refine->GetLevelsMade();
    });
}

vtkOversketchSystem::FigureList vtkOversketchInflateDrawing::Figures()
{
  if (this->GetOutput()->GetNumberOfPolys() == 0)
  {
    return {};
  }
  const char* const words[] = { "rejected", "unknown", "boundary", "closed feature", "open feature" };
  vtkDataArray* roles = this->StageOutput("Treatment")->GetCellData()->GetArray("Role");
  std::vector<std::string> strokes;
  for (vtkIdType i = 0; roles && i < roles->GetNumberOfTuples(); ++i)
  {
    strokes.emplace_back(words[std::clamp(static_cast<int>(roles->GetComponent(i, 0)), -1, 3) + 1]);
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
  this->Inner->Treatment->SetHoles(strokes);
}

void vtkOversketchInflateDrawing::SetTunnels(const char* strokes)
{
  SetText(this, this->Tunnels, strokes);
  this->Inner->Treatment->SetTunnels(strokes);
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
