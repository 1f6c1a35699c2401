// The inner pipeline of vtkOversketchEdit: its steps, what they start from, and what is asked of them one by
// one. Not installed.
#ifndef vtkOversketchEditPipeline_h
#define vtkOversketchEditPipeline_h

#include "vtkOversketchEdit.h"

#include "Remesh/retriangulate.h"
#include "vtkOversketchCrossSection.h"
#include "vtkOversketchDistanceField.h"
#include "vtkOversketchEditCurves.h"
#include "vtkOversketchEditLimb.h"
#include "vtkOversketchEditMotion.h"
#include "vtkOversketchEditPreview.h"
#include "vtkOversketchEditRemarks.h"
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
#include "vtkOversketchRefineBetween.h"
#include "vtkOversketchResketch.h"
#include "vtkOversketchRetriangulate.h"
#include "vtkOversketchScanFill.h"
#include "vtkOversketchShadingLevels.h"
#include "vtkOversketchTextureToWeight.h"
#include "vtkOversketchWeld.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

struct vtkOversketchEdit::Pipeline
{
  explicit Pipeline(vtkOversketchEdit* self);

  // Inputs of ports 0 to 6; the last four may be null.
  struct Inputs
  {
    vtkPolyData *Mesh, *Reference, *Boundary, *Profile, *Areas;
    vtkImageData* Weights;
    vtkPolyData* Handles;
  };
  static Inputs InputsOf(vtkInformationVector** inputs);
  // Work outside a run, on what the ports hold by now; false where there is no mesh, or see Try.
  bool Outside(const std::function<bool(const Inputs& inputs)>& work);
  // Brings the inner inputs up to date; they change only where what came in has changed.
  void FeedMesh(vtkPolyData* mesh);
  void FeedEdit(const Inputs& inputs, const std::string& operations);

  void SetAmendments(bool on);
  void SetParameters();

  // The mesh that the line is put into: fine enough for what lies between it and the ring, which may be null.
  void RunGround(vtkPolyData* reference, vtkPolyData* boundary);
  void RunReference(vtkPolyData* curve);
  void RunBoundary(vtkPolyData* curve);
  // The ring, and that it encloses the line: of several ways to lead it on where it is hidden the first that
  // does.
  void RunEnclosed(vtkPolyData* curve);
  void RunRegion();
  void RunWeights();
  void RunDeform();
  void RunTriangles();
  // All before the deformation.
  void RunToWeights(const Inputs& inputs);
  // Another ring, for one that encloses no region, that does, as a sentence; empty where none is found.
  oversketch::Message CircleThatWouldDo(const Inputs& inputs);
  bool Show(const std::string& operations, vtkPolyData* edited); // as PreviewEdit
  void PutPreview(vtkPolyData* edited);
  void PutOutput(vtkPolyData* mesh, vtkPolyData* output, vtkPolyData* reference, vtkPolyData* boundary);

  bool HasProfile() const { return this->ProfileInput->GetNumberOfPoints() > 0; }
  const char* DeformName() const { return this->HasProfile() ? "Bend" : "Deform"; }
  const char* WeightName() const { return this->HasImage ? "Texture" : "Shading"; }
  bool Retriangulates() const { return this->Self->Rule != Off; }
  int Moved();

  vtkOversketchEdit* Self;

  // Meshes that the inner pipeline starts from: Start is the mesh that came in, welded.
  vtkNew<vtkPolyData> Start, Plain;
  std::unique_ptr<oversketch::Weld> Welding;
  oversketch::MeshKey MeshSeen;
  vtkNew<vtkPolyData> ProfileInput, AreasInput, HandlesInput;
  vtkNew<vtkImageData> ImageInput;
  std::map<const vtkDataObject*, std::pair<const vtkDataObject*, vtkMTimeType>> Seen; // by Feed, per copy
  bool HasImage = false;

  // The mesh with a curve in it, the curve, and the one before it.
  struct OnMesh
  {
    vtkNew<vtkPolyData> Mesh, Curve, Stored;
    oversketch::StepKey Seen;
    int Bridges = 0;
  };
  // A curve's own steps, and what is made of it when all that redraws it has.
  struct Drawn
  {
    std::string Name; // "Reference"
    vtkNew<vtkOversketchNurbsFit> Fit;
    vtkNew<vtkOversketchProjectCurve> Place, Project; // onto the mesh that came in, and onto what it became
    vtkNew<vtkOversketchInsertCurve> Insert;
    oversketch::DrawnLines Lines;
    vtkNew<vtkPolyData> Input, LaidFirst, Laid;
    oversketch::StepKey LaidFirstSeen, LaidSeen;
    // Runs of a ring on the line's limb, where it passes over others too; of both projections.
    oversketch::RunSpans Spans;
    oversketch::StepKey SpansSeen, KeptSeen[2];
    vtkNew<vtkPolyData> Kept[2];
    bool IsWhole = false; // all runs are taken nevertheless
    int Way = 0;
    oversketch::StepKey WaySeen;
    struct Redrawing
    {
      oversketch::StepKey Seen;
      OnMesh Made;
    };
    std::vector<std::unique_ptr<Redrawing>> Redrawings;
    OnMesh First, Made;
  };
  Drawn Reference, Boundary;

  vtkNew<vtkOversketchMeanEdge> MeanEdge;
  vtkNew<vtkOversketchRefineBetween> Refine;
  vtkNew<vtkPolyData> Ground;
  oversketch::StepKey GroundSeen;
  vtkNew<vtkOversketchNurbsFit> Refit; // these four of whatever redraws either curve
  vtkNew<vtkOversketchResketch> Resketch;
  vtkNew<vtkOversketchProjectCurve> Reproject;
  vtkNew<vtkOversketchInsertCurve> Reinsert;
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
  vtkNew<vtkOversketchRetriangulate> Retriangulate;

  // Weights on the mesh as its mask leaves them.
  vtkNew<vtkPolyData> Masked;
  oversketch::StepKey MaskedSeen;
  // Weights on the mesh, with normals that turn with it.
  vtkNew<vtkPolyData> Weighted;
  oversketch::StepKey WeightedSeen;
  vtkSmartPointer<vtkDataArray> RestNormals; // of Boundary.Made.Mesh
  oversketch::StepKey NormalsSeen;
  vtkNew<vtkPolyData> Bare; // what the deformation made, without these
  oversketch::StepKey BareSeen;
  oversketch::EditPreview Preview;

  oversketch::DrawnLines Profiles;
  std::vector<vtkSmartPointer<vtkPolyData>> ProfilesSeen, Flat; // as drawn, in their plane
  vtkNew<vtkPolyData> DrawnProfile;                             // the section after all of them
  oversketch::StepKey DrawnSeen;

  oversketch::StepKey MotionSeen;
  std::shared_ptr<const oversketch::Motion> Motion; // that the last step goes by

  // Parts of the last output, as shallow copies.
  struct Result
  {
    vtkNew<vtkPolyData> Output, Reference;
    std::vector<char> Moved; // per point of the output
    int MovedPoints, Bridges;
    oversketch::EditFigures Figures;
  };
  std::unique_ptr<Result> Made; // null after a run that failed

private:
  // Copies, shallowly, what is another one than it was; nothing of a null one.
  void Feed(vtkDataObject* from, vtkDataObject* to);
  static void Keep(vtkOversketchInsertCurve* insert, OnMesh& kept);
  static void Keep(const OnMesh& from, OnMesh& kept);
  vtkPolyData* ReadFirst(Drawn& drawn, vtkPolyData* curve);
  vtkPolyData* Place(Drawn& drawn,
    vtkPolyData* curve); // where its first stroke lies on the mesh that came in
  vtkPolyData* OnLimb(vtkPolyData* ring, int projection);
  vtkPolyData* Lay(vtkPolyData* curve,
    vtkPolyData* mesh,
    bool closed,
    vtkPolyData* laid,
    oversketch::StepKey& seen);
  double TakenOutside(); // the share of the region that lies outside the ring in the picture
  void RunCurve(Drawn& drawn, vtkPolyData* curve, vtkPolyData* mesh);
  void RunRedrawing(Drawn& drawn, std::size_t number);
  void RunProfile();
  // Throws Error(BadStroke) for strokes that were drawn in the view of the line or of the ring.
  void RequireOwnView(vtkPolyData* strokes, const std::string& who, const std::string& plane) const;
  oversketch::EditFigures FiguresOf(vtkPolyData* last);
  // What {Shading} or {Texture} made, where the mesh has a mask without masked vertices in the region. Throws
  // Error(BadRegion) where no others are.
  vtkPolyData* MaskedWeights();
  void AddNormals();
  std::shared_ptr<const oversketch::Motion> FindMotion();
};

#endif
