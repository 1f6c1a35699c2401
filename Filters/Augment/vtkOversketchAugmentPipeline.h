// The inner pipeline of vtkOversketchAugment: its steps, what they start from, and what is asked of them one
// by one. Not installed.
#ifndef vtkOversketchAugmentPipeline_h
#define vtkOversketchAugmentPipeline_h

#include "vtkOversketchAugment.h"

#include "vtkOversketchChaikin.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchRemesh.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchSilhouetteSketch.h"
#include "vtkOversketchStellarBase.h"
#include "vtkOversketchStellarDisplace.h"
#include "vtkOversketchStellarRefine.h"
#include "vtkOversketchStellarSimplify.h"
#include "vtkOversketchStellarSmooth.h"
#include "vtkOversketchStellarSnap.h"
#include "vtkOversketchStrokeThinning.h"
#include "vtkOversketchSurfaceStroke.h"
#include "vtkOversketchVisibility.h"
#include "vtkOversketchWeld.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Figures of all passes of a run.
struct vtkOversketchAugmentFigures
{
  int Crossings = 0, Residual = 0, RefusedMoves = 0, FacesAdded = 0, FlippedFaces = 0, HeldBack = 0;
  int IntersectingFaces = 0; // below 0: not counted
  int CrestPlaces = 0;
  double LeastShare = 1.0, CrestSum = 0.0, CrestMinimum = 0.0, LongestSegment = 0.0;
};

struct vtkOversketchAugment::Pipeline
{
  explicit Pipeline(vtkOversketchAugment* self);

  // Brings the inner inputs up to date; they change only where what the steps read has changed.
  void FeedMesh(vtkPolyData* mesh);
  void FeedStrokes(vtkPolyData* strokes, vtkPolyData* mesh);
  // Throws Error(BadMesh) for masked points over a simplified base.
  void RequireMaskKept() const;
  // The strokes one by one, those that neither cross nor lie on each other together.
  std::vector<vtkSmartPointer<vtkPolyData>> PassesOf(vtkPolyData* strokes,
    const oversketch::Vector3& centre,
    double radius) const;
  void FeedPass(std::size_t pass);
  std::size_t PassCount() const { return this->Passes.size(); }

  void SetAmendments(bool on);
  // The curves of the silhouette mode or the other's; of a surface that refinement moves, laid on it anew.
  void Connect();
  // Whether refinement reads its new points from a source, which is not where strokes were projected.
  bool ReadsSource() const;
  // Hands the system's parameters to the steps that have them, for a pass's mesh, after {Base}.
  void SetParameters();
  void SetEdges(vtkOversketchStellarRefine* step, double radius) const;
  void SetShape(vtkOversketchStellarDisplace* step,
    double radius,
    const std::string& profile,
    double height,
    double sharpness) const;

  // {Base} of the present pass's mesh, or of what was made of it.
  void RunBase(vtkPolyData* mesh);
  // {Base} and the curves; where those run over long thin triangles, of a mesh with even ones there.
  void LayCurves();
  // Has the curves' step make what rays need of the present mesh.
  void PrepareRays();
  void RunCurves();
  void WidenDent();
  void RunFeature();
  // The stage of the curves that RunCurves() makes, and of those that the feature follows.
  const char* DrawnName() const { return this->Self->SketchMode == Silhouette ? "Sketch" : "Curves"; }
  const char* CurvesName() const { return this->ReadsSource() ? "CurvesOnSource" : this->DrawnName(); }
  const char* LastName() const { return this->Self->Simplify ? "Simplify" : "Displace"; }
  // Adds what the steps count, after a pass; see vtkOversketchAugment::Figures.
  void AddFigures();
  // Remark on what of them is not as it should be; empty: nothing, or the run failed.
  oversketch::Message Remark() const;

  // The user's mesh with what the steps made of it.
  void PutOutput(vtkPolyData* output);
  void PutCrest(vtkPolyData* crest);
  // See vtkOversketchAugment::Reshape; where Made has numbers.
  void Reshape(double height, double sharpness, vtkPoints* points);

  vtkOversketchAugment* Self;

  std::optional<vtkOversketchAugmentFigures> Counted; // nothing after a run that failed

  // Meshes that the inner pipeline starts from. Start is the mesh that came in, welded where that has
  // repeated points; Mesh that of the present pass; Shape its 4-8 mesh without arrays, so that no step reads
  // normals.
  vtkNew<vtkPolyData> Start, Mesh, Shape, Strokes;
  vtkNew<vtkPolyData> RefinedShape;   // the same of {Refine}
  vtkNew<vtkPolyData> Uneven, Evened; // what {Even} starts from, and makes for EvenedKey; empty: nothing
  oversketch::StepKey EvenedKey;
  std::unique_ptr<oversketch::Weld> Welding; // null where points and arrays go through the steps themselves
  vtkNew<vtkPolyData> Plain;                 // the mesh that it is of
  oversketch::MeshKey MeshKeySeen, ShapeKeySeen, RefinedKeySeen;
  std::pair<const vtkPolyData*, vtkMTimeType> MeshSeen{ nullptr, 0 }, StrokesSeen{ nullptr, 0 };
  bool SplitSeen = false, WholeSeen = false;
  std::vector<vtkSmartPointer<vtkPolyData>> Passes; // the strokes of each
  long MeshPass = -1, StrokesPass = -1;             // that Mesh and Strokes are of
  double PassRadius = 0.0;
  std::string PassProfile;

  vtkNew<vtkOversketchStrokeThinning> Thinning;
  vtkNew<vtkOversketchChaikin> Chaikin;
  vtkNew<vtkOversketchRemesh> Even;
  vtkNew<vtkOversketchStellarBase> Base;
  vtkNew<vtkOversketchSurfaceStroke> Curves, CurvesOnSource;
  vtkNew<vtkOversketchSilhouette> SilhouetteStep;
  vtkNew<vtkOversketchVisibility> Visibility;
  vtkNew<vtkOversketchSilhouetteSketch> Sketch;
  vtkNew<vtkOversketchStellarRefine> Refine, RefineOnSource;
  vtkNew<vtkOversketchStellarSnap> Snap;
  vtkNew<vtkOversketchStellarSmooth> Smooth;
  vtkNew<vtkOversketchStellarDisplace> Displace, Reshaped; // the second beside the pipeline
  vtkNew<vtkOversketchStellarSimplify> Simplify;

  // Parts of the last output, as shallow copies, so that a preview does not touch it: what {Smooth},
  // {Displace}, the curves' step and the last step made. Per point of the output its number in that of
  // {Displace}; empty after several passes.
  struct Result
  {
    vtkNew<vtkPolyData> Smooth, Displaced, Curves, Sketch, Last;
    double Radius;
    std::string Profile;
    std::vector<vtkIdType> Numbers;
  };
  std::unique_ptr<Result> Made; // null after a run that failed
};

#endif
