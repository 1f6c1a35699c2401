// The inner pipeline of vtkOversketchEdit: its steps, what they start from, and what is asked of them one by
// one. Not installed.
#ifndef vtkOversketchEditPipeline_h
#define vtkOversketchEditPipeline_h

#include "vtkOversketchEdit.h"

#include "Remesh/motion.h"
#include "vtkOversketchCrossSection.h"
#include "vtkOversketchDistanceField.h"
#include "vtkOversketchEditMotion.h"
#include "vtkOversketchEnclose.h"
#include "vtkOversketchFlatten.h"
#include "vtkOversketchHandles.h"
#include "vtkOversketchInsertCurve.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchMatrixDeform.h"
#include "vtkOversketchMeanEdge.h"
#include "vtkOversketchNurbsFit.h"
#include "vtkOversketchProfileDeform.h"
#include "vtkOversketchProfilePlanes.h"
#include "vtkOversketchProjectCurve.h"
#include "vtkOversketchResketch.h"
#include "vtkOversketchRetriangulate.h"
#include "vtkOversketchScanFill.h"
#include "vtkOversketchShadingLevels.h"
#include "vtkOversketchTextureToWeight.h"
#include "vtkOversketchWeld.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// The step that is told what the edit does between vertices.
class vtkOversketchToldRetriangulate : public vtkOversketchRetriangulate
{
public:
  static vtkOversketchToldRetriangulate* New();
  vtkTypeMacro(vtkOversketchToldRetriangulate, vtkOversketchRetriangulate);

  void Tell(std::shared_ptr<const oversketch::Motion> motion);

protected:
  vtkOversketchToldRetriangulate() = default;
  ~vtkOversketchToldRetriangulate() override = default;

private:
  vtkOversketchToldRetriangulate(const vtkOversketchToldRetriangulate&) = delete;
  void operator=(const vtkOversketchToldRetriangulate&) = delete;
};

struct vtkOversketchEdit::Pipeline
{
  explicit Pipeline(vtkOversketchEdit* self);

  // Brings the inner inputs up to date; they change only where what came in has changed.
  void FeedMesh(vtkPolyData* mesh);
  void FeedEdit(vtkPolyData* profile, vtkPolyData* areas, vtkImageData* image, vtkPolyData* handles);

  void SetAmendments(bool on);
  void SetParameters();

  void RunCurves(vtkPolyData* reference, vtkPolyData* boundary);
  void RunRegion();
  void RunWeights();
  void RunDeform();
  void RunTriangles();
  void PutOutput(vtkPolyData* mesh, vtkPolyData* output, vtkPolyData* reference, vtkPolyData* boundary);
  void PutRegion(vtkPolyData* region);

  bool HasProfile() const { return this->ProfileInput->GetNumberOfPoints() > 0; }
  const char* DeformName() const { return this->HasProfile() ? "Bend" : "Deform"; }
  const char* WeightName() const { return this->HasImage ? "Texture" : "Shading"; }
  bool Retriangulates() const { return this->Self->Rule != Off; }
  int Moved();
  int Folded();

  vtkOversketchEdit* Self;

  // What the inner pipeline starts from: Start is the mesh that came in, welded.
  vtkNew<vtkPolyData> Start, Plain;
  std::unique_ptr<oversketch::Weld> Welding;
  oversketch::MeshKey MeshSeen;
  vtkNew<vtkPolyData> ReferenceInput, BoundaryInput, ReferenceLaid, BoundaryLaid;
  vtkNew<vtkPolyData> ProfileInput, DrawnInput, AreasInput, HandlesInput;
  vtkNew<vtkImageData> ImageInput;
  oversketch::StepKey ReferenceSeen, BoundarySeen, DrawnSeen;
  std::map<const vtkDataObject*, std::pair<const vtkDataObject*, vtkMTimeType>> Seen; // by Feed, per copy
  bool HasImage = false;

  vtkNew<vtkOversketchMeanEdge> MeanEdge;
  vtkNew<vtkOversketchNurbsFit> ReferenceFit, BoundaryFit;
  vtkNew<vtkOversketchProjectCurve> ReferenceProject, BoundaryProject;
  vtkNew<vtkOversketchInsertCurve> ReferenceInsert, BoundaryInsert;
  vtkNew<vtkOversketchEnclose> Enclose;
  vtkNew<vtkOversketchFlatten> Flatten;
  vtkNew<vtkOversketchDistanceField> Distance;
  vtkNew<vtkOversketchScanFill> Areas;
  vtkNew<vtkOversketchShadingLevels> Shading;
  vtkNew<vtkOversketchTextureToWeight> Texture;
  vtkNew<vtkOversketchHandles> Handles;
  vtkNew<vtkOversketchMatrixDeform> Deform;
  vtkNew<vtkOversketchProfilePlanes> Planes;
  vtkNew<vtkOversketchCrossSection> Section;
  vtkNew<vtkOversketchResketch> Redraw;
  vtkNew<vtkOversketchProfileDeform> Bend;
  vtkNew<vtkOversketchToldRetriangulate> Retriangulate;

  oversketch::StepKey MotionSeen;
  std::shared_ptr<const oversketch::Motion> Motion; // that the last step was told

  // Of the last output, as shallow copies.
  struct Result
  {
    vtkNew<vtkPolyData> Output, Reference;
    std::vector<char> Moved; // per point of the output
    int MovedPoints, FoldedEdges, Bridges;
  };
  std::unique_ptr<Result> Made; // null after a run that failed

private:
  // Copies, shallowly, what is another one than it was; nothing of a null one.
  void Feed(vtkDataObject* from, vtkDataObject* to);
  void RunCurve(const std::string& name, vtkPolyData* curve, vtkPolyData* input, vtkPolyData* laid);
  std::shared_ptr<const oversketch::Motion> FindMotion();
};

#endif
