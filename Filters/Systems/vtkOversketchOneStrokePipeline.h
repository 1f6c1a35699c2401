// The inner pipeline of vtkOversketchOneStroke: its steps, what they start from, and what is asked of them
// one by one. Not installed.
#ifndef vtkOversketchOneStrokePipeline_h
#define vtkOversketchOneStrokePipeline_h

#include "vtkOversketchOneStroke.h"

#include "Silhouette/judgement.h"
#include "vtkOversketchCorrection.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchFollowers.h"
#include "vtkOversketchLaplacianDeform.h"
#include "vtkOversketchMatch.h"
#include "vtkOversketchMixtureRegion.h"
#include "vtkOversketchOutline.h"
#include "vtkOversketchRegionBorder.h"
#include "vtkOversketchRemesh.h"
#include "vtkOversketchShapeDiameter.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchSnake.h"
#include "vtkOversketchStrokeFilter.h"
#include "vtkOversketchTargets.h"
#include "vtkOversketchVisibility.h"
#include "vtkOversketchWeld.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

struct vtkOversketchOneStroke::Pipeline
{
  struct Stage
  {
    const char* name;
    vtkAlgorithm* step;
    double share; // of the whole run, for progress
    double seconds = 0.0;
  };

  explicit Pipeline(vtkOversketchOneStroke* self);

  // Brings the persistent inner inputs up to date; they change only where what the steps read has changed.
  void FeedMesh(vtkPolyData* mesh);
  void FeedStroke(vtkPolyData* stroke);
  // Runs one step, forwarding its events and failing with its first error.
  void Run(const char* name);
  // The curves that a stroke in the present view can take hold of.
  void RunCurves();
  Stage* Find(const char* name); // null where there is none of that name
  vtkPolyData* Output(const char* name)
  {
    return vtkPolyData::SafeDownCast(this->Find(name)->step->GetOutputDataObject(0));
  }
  void SetAmendments(bool on);
  bool WantsRemeshing();
  bool RemeshingKept();
  // Adds handles where the outline of a deformation has left the stroke, and deforms again. Returns the name
  // of the better deformation.
  const char* Corrected(const char* deform, const char* correction, const char* again);
  oversketch::Judgement Judged(const char* stage, int foldsBefore);

  vtkOversketchOneStroke* Self;

  // What the inner pipeline starts from. View is the present stroke's view, with the diagonal of the viewport
  // for a stroke: it changes only with the view, so silhouettes stand while strokes come and go, and are the
  // same whichever stroke came first.
  vtkNew<vtkPolyData> Mesh, Stroke, View;
  oversketch::MeshKey MeshKeySeen;
  std::unique_ptr<oversketch::Weld> Welding;
  std::vector<double> ViewSeen;
  std::pair<const vtkPolyData*, vtkMTimeType> StrokeSeen{ nullptr, 0 };

  vtkNew<vtkOversketchStrokeFilter> StrokeStep;
  vtkNew<vtkOversketchSilhouette> Silhouette;
  vtkNew<vtkOversketchSnake> Snake;
  vtkNew<vtkOversketchVisibility> Visibility;
  vtkNew<vtkOversketchOutline> Outline;
  vtkNew<vtkOversketchMatch> Match;
  vtkNew<vtkOversketchTargets> Targets;
  vtkNew<vtkOversketchShapeDiameter> ShapeDiameter;
  vtkNew<vtkOversketchMixtureRegion> MixtureRegion;
  vtkNew<vtkOversketchRegionBorder> RegionBorder;
  vtkNew<vtkOversketchLaplacianDeform> Deform;
  vtkNew<vtkOversketchRemesh> Stretch;
  vtkNew<vtkOversketchLaplacianDeform> DeformRemeshed;
  vtkNew<vtkOversketchCorrection> Correction, CorrectionRemeshed;
  vtkNew<vtkOversketchLaplacianDeform> DeformCorrected, DeformRemeshedCorrected;
  vtkNew<vtkOversketchRemesh> Restore;
  std::vector<Stage> Stages;
  const char* Deformation = "Deform"; // the stage whose output the last result was made of
  // How that result follows a drag; null after a run that failed.
  std::unique_ptr<oversketch::Followers> Following;

  vtkNew<vtkCallbackCommand> Observer;
  Stage* Running = nullptr;
  double Done = 0.0; // share of the steps that are finished
  std::string FirstError;
};

#endif
