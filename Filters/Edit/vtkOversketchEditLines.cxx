// The lines that the edit is drawn with: from strokes to curves in the mesh, and what redraws them.
#include "vtkOversketchEditPipeline.h"

#include "vtkOversketchDrawnProfile.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellData.h"

#include <optional>
#include <string>

using namespace oversketch;

void vtkOversketchEdit::Pipeline::Keep(vtkOversketchInsertCurve* insert, OnMesh& kept)
{
  const auto output = [insert](int port)
  { return vtkPolyData::SafeDownCast(insert->GetOutputDataObject(port)); };
  const StepKey key({ WholeKey(output(0)), WholeKey(output(1)), WholeKey(output(2)) }, {});
  if (kept.Mesh->GetNumberOfPoints() == 0 || kept.Seen != key)
  {
    kept.Mesh->ShallowCopy(output(0));
    kept.Curve->ShallowCopy(output(1));
    kept.Stored->ShallowCopy(output(2));
    kept.Seen = key;
  }
  kept.Bridges = insert->GetBridgeCount();
}

void vtkOversketchEdit::Pipeline::Keep(const OnMesh& from, OnMesh& kept)
{
  const StepKey key({ WholeKey(from.Mesh), WholeKey(from.Curve), WholeKey(from.Stored) }, {});
  if (kept.Mesh->GetNumberOfPoints() == 0 || kept.Seen != key)
  {
    kept.Mesh->ShallowCopy(from.Mesh);
    kept.Curve->ShallowCopy(from.Curve);
    kept.Stored->ShallowCopy(from.Stored);
    kept.Seen = key;
  }
  kept.Bridges = from.Bridges;
}

namespace
{

// A fit in space alone reads the mesh; else another one does not run it again.
void FitOnMesh(vtkOversketchNurbsFit* fit, vtkPolyData* mesh)
{
  fit->SetMeshData(fit->GetFitSpace() == vtkOversketchNurbsFit::World ? mesh : nullptr);
}

} // namespace

vtkPolyData* vtkOversketchEdit::Pipeline::ReadFirst(Drawn& drawn, vtkPolyData* curve)
{
  drawn.Lines.Read(curve, &drawn == &this->Boundary ? "boundary" : "reference");
  return drawn.Lines.All().front();
}

vtkPolyData* vtkOversketchEdit::Pipeline::Lay(vtkPolyData* curve,
  vtkPolyData* mesh,
  bool closed,
  vtkPolyData* laid,
  StepKey& seen)
{
  const StepKey key({ WholeKey(curve), MeshKey(mesh) }, {});
  if (laid->GetNumberOfPoints() == 0 || seen != key)
  {
    const double done = this->Self->GetDone();
    LayOnMesh(curve, mesh, closed, ContextOf(this->Self, done, done), laid);
    seen = key;
  }
  return laid;
}

vtkPolyData* vtkOversketchEdit::Pipeline::Place(Drawn& drawn, vtkPolyData* curve)
{
  vtkPolyData* mesh = this->Self->StageOutput("MeanEdge");
  vtkPolyData* first = this->ReadFirst(drawn, curve);
  if (IsCurveOfEdit(first))
  {
    return this->Lay(first, mesh, &drawn == &this->Boundary, drawn.LaidFirst, drawn.LaidFirstSeen);
  }
  this->Feed(first, drawn.Input);
  FitOnMesh(drawn.Fit, mesh);
  this->Self->RunStage((drawn.Name + "Fit").c_str());
  this->Self->RunStage((drawn.Name + "Place").c_str());
  return this->Self->StageOutput((drawn.Name + "Place").c_str());
}

void vtkOversketchEdit::Pipeline::RunCurve(Drawn& drawn, vtkPolyData* curve, vtkPolyData* mesh)
{
  vtkPolyData* first = this->ReadFirst(drawn, curve);
  if (IsCurveOfEdit(first))
  {
    drawn.Insert->SetCurvesData(
      this->Lay(first, mesh, &drawn == &this->Boundary, drawn.Laid, drawn.LaidSeen));
  }
  else
  {
    this->Feed(first, drawn.Input);
    FitOnMesh(drawn.Fit, mesh);
    this->Self->RunStage((drawn.Name + "Fit").c_str());
    this->Self->RunStage((drawn.Name + "Project").c_str());
    if (&drawn == &this->Boundary && !drawn.Spans.empty() && !drawn.IsWhole)
    {
      drawn.Insert->SetCurvesData(this->OnLimb(this->Self->StageOutput("BoundaryProject"), 1));
    }
    else
    {
      drawn.Insert->SetCurvesConnection(drawn.Project->GetOutputPort());
    }
  }
  this->Self->RunStage((drawn.Name + "Insert").c_str());
  Keep(drawn.Insert, drawn.First);
  const std::size_t count = drawn.Lines.All().size() - 1;
  drawn.Redrawings.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->RunRedrawing(drawn, i);
  }
  Keep(count > 0 ? drawn.Redrawings.back()->Made : drawn.First, drawn.Made);
}

// One that redraws what the ones before have made.
void vtkOversketchEdit::Pipeline::RunRedrawing(Drawn& drawn, std::size_t number)
{
  const OnMesh& before = number > 0 ? drawn.Redrawings[number - 1]->Made : drawn.First;
  vtkPolyData* stroke = drawn.Lines.All()[number + 1];
  const StepKey key(
    { WholeKey(before.Mesh), WholeKey(before.Curve), WholeKey(before.Stored), WholeKey(stroke) },
    { static_cast<double>(this->Refit->GetFitSpace()),
      this->Refit->GetSpacing(),
      this->Refit->GetInterpolate() ? 1.0 : 0.0,
      this->Resketch->GetK(),
      static_cast<double>(this->Resketch->GetMiddle()),
      this->Resketch->GetRawTangents() ? 1.0 : 0.0,
      this->Reproject->GetSpacing(),
      this->Reinsert->GetSnap() ? 1.0 : 0.0,
      this->Reinsert->GetEmbedSegments() ? 1.0 : 0.0,
      this->Reinsert->GetBridge() ? 1.0 : 0.0,
      this->Reinsert->GetJoinRuns() ? 1.0 : 0.0,
      this->Reinsert->GetClean() ? 1.0 : 0.0 });
  std::unique_ptr<Drawn::Redrawing>& redrawing = drawn.Redrawings[number];
  if (redrawing && redrawing->Seen == key)
  {
    return;
  }
  redrawing = nullptr;
  auto made = std::make_unique<Drawn::Redrawing>();
  this->Refit->SetInputData(0, stroke);
  FitOnMesh(this->Refit, before.Mesh);
  this->Resketch->SetInputData(0, before.Curve);
  this->Self->RunStage("Refit");
  this->Self->RunStage("Resketch");
  const RedrawnPart part = PartRedrawn(this->Self->StageOutput("Resketch"));
  if (part.Stroke)
  {
    this->Reproject->SetInputData(0, part.Stroke);
    this->Reproject->SetMeshData(before.Mesh);
    this->Self->RunStage("Reproject");
    vtkNew<vtkPolyData> laid;
    LayRedrawn(part, this->Self->StageOutput("Reproject"), before.Mesh, laid);
    this->Reinsert->SetInputData(0, before.Mesh);
    this->Reinsert->SetCurvesData(laid);
    this->Reinsert->SetStoredData(before.Stored);
    this->Self->RunStage("Reinsert");
    Keep(this->Reinsert, made->Made);
    made->Made.Bridges += before.Bridges;
    // The view that the curve can be dragged in stays the one that it was first drawn in.
    made->Made.Curve->GetCellData()->ShallowCopy(before.Curve->GetCellData());
  }
  else
  {
    Keep(before, made->Made);
  }
  made->Seen = key;
  redrawing = std::move(made);
}

namespace
{

// The steps of a line and of a ring are the same; what they say of a stroke says whose it is.
template <typename Run>
void SayWhose(const char* whose, const Run& run)
{
  try
  {
    run();
  }
  catch (const Error& error)
  {
    for (const char* what : { "Stroke", "Curve" })
    {
      if (error.message().id() == Message::unusable(what, 0, {}).id())
      {
        const auto& arguments = error.message().arguments();
        throw Error(error.failure(),
          ("{" + std::string(what) + " %1 of the " + whose + "} cannot be used: %2").c_str(),
          arguments[0].text,
          arguments[1].messages.front());
      }
    }
    throw;
  }
}

} // namespace

vtkPolyData* vtkOversketchEdit::Pipeline::OnLimb(vtkPolyData* ring, int projection)
{
  Drawn& drawn = this->Boundary;
  if (drawn.Spans.empty())
  {
    return ring;
  }
  std::vector<double> spans;
  for (const auto& [first, last] : drawn.Spans)
  {
    spans.insert(spans.end(), { first, last });
  }
  const StepKey key({ WholeKey(ring) }, spans);
  if (drawn.Kept[projection]->GetNumberOfPoints() == 0 || drawn.KeptSeen[projection] != key)
  {
    KeepSpans(ring, drawn.Spans, drawn.Kept[projection]);
    drawn.KeptSeen[projection] = key;
  }
  return drawn.Kept[projection];
}

void vtkOversketchEdit::Pipeline::RunGround(vtkPolyData* reference, vtkPolyData* boundary)
{
  this->Self->RunStage("MeanEdge");
  vtkPolyData* ground = this->Self->StageOutput("MeanEdge");
  if (boundary && this->Refine->GetEdges() > 0.0)
  {
    vtkPolyData *line = nullptr, *ring = nullptr;
    SayWhose("reference", [&] { line = this->Place(this->Reference, reference); });
    SayWhose("boundary", [&] { ring = this->Place(this->Boundary, boundary); });
    const StepKey key({ MeshKey(ground), WholeKey(line), WholeKey(ring) }, {});
    if (this->Boundary.SpansSeen != key)
    {
      this->Boundary.Spans = SpansOnLimb(ring, this->Self->StageOutput("BoundaryFit"), ground, line);
      this->Boundary.SpansSeen = key;
    }
    this->Refine->SetReferenceData(line);
    this->Refine->SetBoundaryData(this->OnLimb(ring, 0));
    this->Self->RunStage("Refine");
    ground = this->Self->StageOutput("Refine");
  }
  else if (boundary)
  {
    this->Boundary.Spans.clear();
    this->Boundary.SpansSeen = StepKey();
  }
  const StepKey key({ WholeKey(ground) }, {});
  if (this->Ground->GetNumberOfPoints() == 0 || this->GroundSeen != key)
  {
    this->Ground->ShallowCopy(ground);
    this->GroundSeen = key;
  }
}

void vtkOversketchEdit::Pipeline::RunReference(vtkPolyData* curve)
{
  SayWhose("reference", [&] { this->RunCurve(this->Reference, curve, this->Ground); });
}

void vtkOversketchEdit::Pipeline::RunBoundary(vtkPolyData* curve)
{
  SayWhose("boundary", [&] { this->RunCurve(this->Boundary, curve, this->Reference.Made.Mesh); });
}

double vtkOversketchEdit::Pipeline::TakenOutside()
{
  const Drawn& ring = this->Boundary;
  return ring.Made.Bridges > 0 && !IsCurveOfEdit(ring.Lines.All().front())
           ? ShareOutside(this->Self->StageOutput("Enclose"),
               this->Self->StageOutput("BoundaryProject"),
               this->Self->StageOutput("BoundaryFit"))
           : 0.0;
}

void vtkOversketchEdit::Pipeline::RunEnclosed(vtkPolyData* curve)
{
  Drawn& ring = this->Boundary;
  const StepKey key(
    { WholeKey(this->Reference.Made.Mesh), WholeKey(this->Reference.Made.Curve), WholeKey(curve) },
    { ring.Insert->GetBridge() ? 1.0 : 0.0 });
  const bool isSettled = ring.WaySeen == key;
  ring.WaySeen = StepKey(); // until one is found: a run may be cancelled
  constexpr int gaps = vtkOversketchInsertCurve::Across + 1;
  const int ways = ring.Insert->GetBridge() ? (ring.Spans.empty() ? gaps : 2 * gaps) : 1;
  const auto run = [&](int way)
  {
    ring.Way = way;
    ring.IsWhole = way / gaps == 1;
    ring.Insert->SetGap(way % gaps);
    this->RunBoundary(curve);
    this->Self->RunStage("Enclose");
  };
  // A way that leads round the wrong side takes more than this share outside the ring in the picture.
  constexpr double mostOutside = 0.25;
  std::optional<Error> refused;
  int best = -1;
  double least = 0.0;
  for (int way = isSettled ? ring.Way : 0; way < ways; ++way)
  {
    try
    {
      run(way);
      const double outside = isSettled ? 0.0 : this->TakenOutside();
      if (outside <= mostOutside)
      {
        ring.WaySeen = key;
        return;
      }
      if (best < 0 || outside < least)
      {
        best = way;
        least = outside;
      }
    }
    catch (const Error& error)
    {
      refused = refused ? refused : error;
      if (error.failure() != Failure::BadRegion && error.failure() != Failure::BadStroke)
      {
        throw;
      }
    }
  }
  if (best < 0)
  {
    throw Error(*refused);
  }
  if (ring.Way != best)
  {
    run(best);
  }
  ring.WaySeen = key;
}

void vtkOversketchEdit::Pipeline::RequireOwnView(vtkPolyData* strokes,
  const std::string& who,
  const std::string& plane) const
{
  for (const Drawn* drawn : { &this->Reference, &this->Boundary })
  {
    RequireOtherView(strokes, drawn->Lines.All(), who, plane);
  }
}

// The section, redrawn by each of the drawn ones in turn.
void vtkOversketchEdit::Pipeline::RunProfile()
{
  this->Profiles.Read(this->ProfileInput, "profile");
  const std::vector<vtkSmartPointer<vtkPolyData>>& drawn = this->Profiles.All();
  this->Flat.resize(drawn.size());
  this->ProfilesSeen.resize(drawn.size());
  vtkPolyData* section = this->Self->StageOutput("Section");
  const auto nameOf = [&drawn](std::size_t i) {
    return drawn.size() > 1 ? "Stroke " + std::to_string(i) + " of the profile" : std::string("The profile");
  };
  std::vector<MeshKey> read{ WholeKey(section) };
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    this->RequireOwnView(drawn[i], nameOf(i), "the section");
    if (this->ProfilesSeen[i] != drawn[i])
    {
      this->ProfilesSeen[i] = nullptr;
      this->Flat[i] = vtkSmartPointer<vtkPolyData>::New();
      LayInPlane(drawn[i], nameOf(i), this->Flat[i]);
      this->ProfilesSeen[i] = drawn[i];
    }
    read.push_back(WholeKey(this->Flat[i]));
  }
  const StepKey key(read,
    { this->Redraw->GetK(),
      static_cast<double>(this->Redraw->GetMiddle()),
      this->Redraw->GetRawTangents() ? 1.0 : 0.0 });
  if (this->DrawnSeen == key)
  {
    return;
  }
  this->DrawnSeen = StepKey();
  vtkNew<vtkPolyData> before, after;
  before->ShallowCopy(section);
  for (std::size_t i = 0; i < drawn.size() && section->GetNumberOfPoints() > 0; ++i)
  {
    RequireEndsBeside(before, this->Flat[i], nameOf(i));
    this->Redraw->SetInputData(0, before);
    this->Redraw->SetStrokeData(this->Flat[i]);
    before->Modified();
    this->Self->RunStage("Redraw");
    after->ShallowCopy(this->Self->StageOutput("Redraw"));
    if (i > 0)
    {
      FollowSources(before, after);
    }
    before->ShallowCopy(after);
  }
  this->DrawnProfile->ShallowCopy(before);
  this->DrawnSeen = key;
}
