/**
 * @class vtkOversketchPlanarRefine
 * @brief refines the coarse mesh of a drawing and snaps its edges on strokes onto these
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.2.3, Fig. 9: smooth subdivision, Loop's of
 * triangles, Catmull and Clark's where there are quads (Sec. 2.2.4); each new point of an edge on a stroke
 * goes onto it, to the middle of the edge's part of it; a portion of what points of features move by goes to
 * their neighbours. Departure: on most real outlines triangles turn over by that. Where
 * they do, free points go back; where strokes leave no room all the same, the strokes' parts are handed back
 * for a closer approximation, as are those that have samples farther from the refined edges than 0.004 of the
 * canvas (Kernels/Planar/refine.h, guard.h). Named so, and not Refine, beside
 * vtkOversketchStellarRefine and vtkOversketchRemesh, which refine meshes of other kinds by other means.
 *
 * Input 0 (Mesh): triangles or quads of vtkOversketchCoarseMesh or vtkOversketchQuadMerge, with their arrays.
 * Input 1 (Edges): output 1 of the same.
 * Input 2 (Curves): the curves that the mesh was made of, with field array Canvas.
 *
 * Output 0 (Mesh): the refined mesh, each face in 4^LevelsMade, with the same arrays: StrokeId, StrokeParam
 * and BoundaryKind of new points on strokes, RegionId, ObjectId and BaseFaceId as inherited. With Levels 0
 * the mesh itself, its edges from rim to rim on no stroke split in the middle. Field arrays are passed, other
 * ones not.
 *
 * Output 1 (Edges): its edges on strokes, as those of the input.
 *
 * Output 2 (Splits): parts of strokes to be approximated closer, for vtkOversketchPolyline: lines with cell
 * arrays StrokeId, ParamStart, ParamEnd and Halvings, 1. Where there are any, the other outputs are empty and
 * a warning says so: a pipeline has no loop, which vtkOversketchInflateDrawing is for. Empty as published.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray and BadMesh, naming array, face or
 * edge, where mesh and edges are not sound or not of these curves, and for more than 2^24 faces; BadStroke
 * for Levels or SnapShare out of range. A mesh without points gives empty outputs silently.
 *
 * Deterministic: same result bit for bit for any number of threads, and as published where what guards
 * triangles hands nothing back and nothing turns over. The result stays, as the same arrays, while mesh,
 * edges, curves and parameters do; what strokes are treated as is not read. Cost: some 0.3 microseconds a
 * face.
 *
 * @sa vtkOversketchTrimHoles
 */
#ifndef vtkOversketchPlanarRefine_h
#define vtkOversketchPlanarRefine_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchPlanarRefine : public vtkOversketchFilter
{
public:
  static vtkOversketchPlanarRefine* New();
  vtkTypeMacro(vtkOversketchPlanarRefine, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The edges, on port 1.
   */
  void SetEdgesConnection(vtkAlgorithmOutput* edges) { this->SetInputConnection(1, edges); }
  void SetEdgesData(vtkPolyData* edges) { this->SetInputData(1, edges); }

  /**
   * The curves, on port 2.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(2, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(2, curves); }

  /**
   * The edges, on output port 1.
   */
  vtkPolyData* GetEdgesOutput() { return this->GetOutput(1); }

  /**
   * The splits, on output port 2.
   */
  vtkPolyData* GetSplitsOutput() { return this->GetOutput(2); }

  ///@{
  /**
   * How often every face is cut in four [0 to 10, default 3; the paper: several].
   */
  vtkSetMacro(Levels, int);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * Whether Levels is not read, and edges are cut until they are shorter than 4 samples of a stroke, 0.02 of
   * the canvas's longest side: the levels that the sketch asks for, none that would make over 2^20 faces
   * (Kernels/Planar/refine.h) [default and as published off].
   */
  vtkSetMacro(LevelsFromSketch, bool);
  vtkGetMacro(LevelsFromSketch, bool);
  vtkBooleanMacro(LevelsFromSketch, bool);
  ///@}

  ///@{
  /**
   * Whether a mesh whose faces are larger on the mean than the square of a sixteenth of the canvas's longest
   * side is refined once more than Levels says, if that is not 0 [default and as published off; the system
   * of drawings turns it on]. Not read with LevelsFromSketch.
   */
  vtkSetMacro(LargeFacesOnceMore, bool);
  vtkGetMacro(LargeFacesOnceMore, bool);
  vtkBooleanMacro(LargeFacesOnceMore, bool);
  ///@}

  ///@{
  /**
   * The portion of a snapped feature point's way that its neighbours on no stroke go too [0 to 1, default and
   * as published 0.3].
   */
  vtkSetMacro(SnapShare, double);
  vtkGetMacro(SnapShare, double);
  ///@}

  ///@{
  /**
   * As published: triangles may turn over, LevelsFromSketch and LargeFacesOnceMore do not count as on
   * [default off].
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  ///@{
  /**
   * Whether a mesh of triangles alone becomes one of quads, as one with a quad in it does [default off].
   */
  vtkSetMacro(Quads, bool);
  vtkGetMacro(Quads, bool);
  vtkBooleanMacro(Quads, bool);
  ///@}

  ///@{
  /**
   * Whether somebody takes the splits and makes the mesh anew: then no warning says that there are some
   * [default off].
   */
  vtkSetMacro(SplitsAreTaken, bool);
  vtkGetMacro(SplitsAreTaken, bool);
  vtkBooleanMacro(SplitsAreTaken, bool);
  ///@}

  /**
   * Figures of the last refinement: faces that are turned over, or cover next to nothing, in the output, or
   * where there are splits those that are the cause of them.
   */
  vtkGetMacro(Inverted, int);

  /**
   * Levels of the last refinement: Levels, one more, or those of the sketch.
   */
  vtkGetMacro(LevelsMade, int);

  /**
   * How many times a mesh has been refined: executions that the kept result did not answer.
   */
  vtkGetMacro(RefineCount, vtkIdType);

protected:
  vtkOversketchPlanarRefine();
  ~vtkOversketchPlanarRefine() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  int Levels = 3;
  bool LevelsFromSketch = false;
  bool LargeFacesOnceMore = false;
  double SnapShare = 0.3;
  bool AsPublished = false;
  bool Quads = false;
  bool SplitsAreTaken = false;
  int Inverted = 0;
  int LevelsMade = 0;
  vtkIdType RefineCount = 0;

  struct Cache;
};

#endif
