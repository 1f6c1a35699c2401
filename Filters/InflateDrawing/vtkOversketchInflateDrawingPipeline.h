// The inner pipeline of vtkOversketchInflateDrawing: its steps, what they start from, and what runs them. Not
// installed.
#ifndef vtkOversketchInflateDrawingPipeline_h
#define vtkOversketchInflateDrawingPipeline_h

#include "vtkOversketchInflateDrawing.h"

#include "Planar/stroke_line.h"
#include "vtkOversketchArrange.h"
#include "vtkOversketchAssemble.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchCoarseMesh.h"
#include "vtkOversketchDarts.h"
#include "vtkOversketchDistance.h"
#include "vtkOversketchExtrude.h"
#include "vtkOversketchInflate.h"
#include "vtkOversketchLayerTools.h"
#include "vtkOversketchMagneticSnap.h"
#include "vtkOversketchPlanarRefine.h"
#include "vtkOversketchPolyline.h"
#include "vtkOversketchProjectTexture.h"
#include "vtkOversketchQuadMerge.h"
#include "vtkOversketchResample.h"
#include "vtkOversketchTrace.h"
#include "vtkOversketchTreatment.h"
#include "vtkOversketchTunnel.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <tuple>
#include <utility>
#include <vector>

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
  [[noreturn]] void RefuseSplits(const oversketch::StrokeSplit& split);
  // Says of each layer, the plane's steps included, which strokes of it are holes and tunnels.
  void FeedTreatments();
  void FeedLayer(const oversketch::DrawingLayer& layer);
  // All steps, and of layers theirs; counts rebuilds and levels.
  void Run(vtkPolyData* output);
  // Layers over the plane, all bodies in one.
  void RunLayers(vtkPolyData* output);

  vtkOversketchInflateDrawing* Self;

  // Data that the inner pipeline starts from.
  vtkNew<vtkPolyData> Strokes;
  vtkNew<vtkImageData> Picture, Back;
  std::pair<const vtkImageData*, vtkMTimeType> PictureSeen{ nullptr, 0 }, BackSeen{ nullptr, 0 };
  // What the inner strokes were made of; times of what is traced are 0 where nothing is.
  using Source = std::tuple<const vtkPolyData*,
    vtkMTimeType,
    bool,
    std::string,
    vtkMTimeType,
    vtkMTimeType,
    oversketch::DepthLists,
    vtkMTimeType>;
  oversketch::DepthLists Depths() const
  {
    return { this->Self->InFront, this->Self->Behind, this->Self->BothSides };
  }
  Source SourceOf(vtkPolyData* strokes)
  {
    const bool traces = !this->Self->Trace.empty();
    return { strokes,
      strokes ? strokes->GetMTime() : 0,
      this->Self->Magnetic,
      this->Self->Trace,
      traces ? this->Picture->GetMTime() : 0,
      traces ? this->Trace->GetMTime() : 0,
      this->Depths(),
      this->Layers.empty() ? 0 : this->Picture->GetMTime() };
  }
  Source StrokesSeen{};
  std::vector<oversketch::DrawingLayer> Layers;       // the plane and others; none: all is in the plane
  const oversketch::DrawingLayer* SayingOf = nullptr; // whose strokes' numbers steps say
  int Drawn = 0;                                      // how many strokes there are

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
  vtkNew<vtkOversketchAssemble> Assemble;
};

#endif
