// The inner pipeline of vtkOversketchOneStroke: its steps, what they start from, and what is asked of them
// one by one. Not installed.
#ifndef vtkOversketchOneStrokePipeline_h
#define vtkOversketchOneStrokePipeline_h

#include "vtkOversketchOneStroke.h"

#include "Intersection/crossing_faces.h"
#include "Mesh/part.h"
#include "Silhouette/effect.h"
#include "Silhouette/facing.h"
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
#include "vtkOversketchSharedMesh.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchSnake.h"
#include "vtkOversketchStrokeFilter.h"
#include "vtkOversketchTargets.h"
#include "vtkOversketchVisibility.h"
#include "vtkOversketchWeld.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct vtkOversketchOneStroke::Pipeline
{
  explicit Pipeline(vtkOversketchOneStroke* self);

  // Brings the persistent inner inputs up to date; they change only where what the steps read has changed.
  void FeedMesh(vtkPolyData* mesh);
  void FeedMask(vtkPolyData* mesh);
  void FeedStroke(vtkPolyData* stroke);
  // The curves that a stroke in the present view can take hold of.
  void RunCurves();
  void SetAmendments(bool on);
  bool WantsRemeshing();
  // Deforms; throws Error(BadRegion) that names the mask where that leaves no handle.
  void RunDeformation(const char* stage);
  // Remeshes, deforms what was made, remeshes again, and says whether that is kept.
  void RunRemeshed();
  bool RemeshingKept();
  // The user's mesh with what the steps made of it.
  void PutOutput(vtkPolyData* mesh, vtkPolyData* output);
  // Adds handles where the outline of a deformation has left the stroke, and deforms again. Returns the name
  // of the better deformation.
  const char* Corrected(const char* before, const char* deform, const char* correction, const char* again);
  const oversketch::StrokeOutline& OutlineOf(const char* stage);
  // By outline and folds.
  oversketch::Judgement Judged(const char* stage, int foldsBefore);
  int Folds(const char* stage);
  const oversketch::Roughness& Rough(const char* stage);
  // Share of what is seen of the mesh that shows its back, in the stroke's view.
  double Back(const char* stage);
  double NewBack(const char* stage);
  // Pairs of triangles that pass through each other, one of them at least with a corner in the region.
  int Crossings(const char* stage);
  int NewCrossings(const char* stage);
  // What the result is judged by beside its outline: silhouettes of its region where the section is one of
  // them.
  const std::vector<oversketch::OutlineLoop>& Contours(const char* stage);
  std::vector<oversketch::OutlineLoop> ContoursOf(const char* stage);
  // What has been done up to a stage, by the deformation of the stage before.
  oversketch::StrokeEffect EffectOf(const char* before, const char* stage);
  // True where remeshing could not make the plain deformation what was drawn.
  bool BeyondHelp();
  // From the match to the result, with the section of a rank, 1 for the one that fits best; what that has
  // done.
  oversketch::StrokeEffect Run(int candidate);
  // With the section that was asked for. Where that turns a limb inside out, or misses the
  // stroke far, and was not chosen by the user, the next ones are tried: one that does as drawn is taken.
  void RunBest();
  // Says what the run has done; throws Torn where that is refused.
  void Judge(const oversketch::StrokeEffect& effect);
  double Missed(const oversketch::StrokeEffect& effect);

  // The mesh that a step of this run made, held until the run ends, so that it is converted and judged once.
  struct MadeMesh
  {
    std::shared_ptr<const oversketch::MeshData> Data;
    std::shared_ptr<oversketch::MeshPart> Part; // one for all that have the same triangles
    std::optional<int> Folds;
    std::optional<oversketch::StrokeOutline> Outline;
    std::optional<oversketch::OutlineError> OutlineMissed;
    std::optional<oversketch::Roughness> Rough; // of its region
    std::optional<double> Back;
    std::optional<int> Crossings;
    std::optional<std::vector<oversketch::OutlineLoop>> Contours;
  };
  MadeMesh& Made(const char* stage);
  // One byte per point of the mesh that a step made.
  std::vector<char> RegionOf(const char* stage);
  // The part that its folds and its roughness are told by; until the next call.
  const oversketch::MeshPart& PartOf(const char* stage);
  std::map<std::string, MadeMesh> MadeMeshes;

  vtkOversketchOneStroke* Self;

  // What the inner pipeline starts from. View is the present stroke's view, with the diagonal of the viewport
  // for a stroke: it changes only with the view, so silhouettes stand while strokes come and go, and are the
  // same whichever stroke came first.
  vtkNew<vtkPolyData> Mesh, Stroke, View;
  oversketch::MeshKey MeshKeySeen;
  std::unique_ptr<oversketch::Weld> Welding;
  std::pair<const vtkDataArray*, vtkMTimeType> MaskSeen{ nullptr, 0 };
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
  vtkNew<vtkPolyData> Hold; // the section that the last run matched
  oversketch::StrokeEffect Effect;
  oversketch::Message Remark;
  const char* Deformation = "Deform"; // the stage whose output the last result was made of
  // How that result follows a drag; null after a run that failed.
  std::unique_ptr<oversketch::Followers> Following;
};

#endif
