/**
 * @class vtkOversketchRemesh
 * @brief incremental remeshing of a region, before it is stretched or after
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 5.2: the region is remeshed to
 * edges of length L k before it is deformed (stage Stretch), L the mean edge length of the region and k the
 * length of the matched section over that of the target curve, and back to L afterwards (stage Restore). The
 * loop is the usual one: split edges over 4/3 of the target length, collapse those under 4/5, flip towards
 * valence 6 (4 on a border), relax in the tangent plane (towards the mean of the neighbours) and project back
 * to the input surface.
 *
 * Departures, each because one uniform length eats thin limbs and loses what the pipeline carries:
 * - the target length of a vertex is min(L k, ShapeDiameter / 2), never under 0.2 L k, smoothed so
 * that it grows by at most half of the way walked; where the limit by diameter would more than quadruple the
 * number of triangles it is raised evenly until it does not;
 * - (KeepSmooth) it is at most k times the length that fits the triangles round it: 3.9 times their area over
 * half their perimeter, a side of even triangles as wide as they are, at least half the side of even ones of
 * their area. The mean edge of long thin triangles is longer than a thin limb can bear: its facets twist;
 * - (KeepSmooth) a flip, a collapse or a relaxation that makes the surface turn more sharply is refused. Over
 * the edges that it touches, and beyond 13 degrees, the sum of length times (1 - cosine) may not grow by more
 * than 0.02 target lengths. After the total absolute curvature of N. Dyn, K. Hormann, S.-J. Kim and D. Levin,
 * "Optimizing 3D triangulations using discrete curvature analysis", 2001;
 * - (KeepSmooth) edges of 50 to 100 degrees, as of a box, keep their place (they may be split);
 * - where the lengths ask for far more triangles than there were, as of one that is far larger than those
 * round it, they are raised evenly from below (GetTrianglesWanted);
 * - next to edges that cannot change the target goes over to their length, so that no fan of needles forms
 * there;
 * - edges and vertices that carry handles keep their place (edges may be split), so that the section does not
 * drift;
 * - k is limited to [0.2, 1];
 * - folded edges (normals over 100 degrees apart) are not split: there shall never be more of them;
 * - (TakeOutFolds) at last vertices at folded edges move towards the mean of their neighbours, off the
 * surface where less is folded then, but none on the region's border, a seam or a border of the mesh;
 * - a move that folds a triangle, makes one narrower than 30 degrees (a collapse 25, a split 10) that was
 * not, or cuts off a tip is refused.
 *
 * What may change: triangles all of whose vertices are in the region. What never does: every point outside
 * the region and on the region's border; edges on that border and non-manifold edges, even if long; the shape
 * of borders of the mesh and of edges between charts, which are split at most.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, with point array Region (1 component, not 0 = in the region)
 * and, if LimitByDiameter is on, ShapeDiameter (1 component, model length; values that are not positive
 * limit nothing). Optional cell array Chart (1 component, integers): edges between different charts are
 * kept. For stage Restore, optional: field array GuideLength, L; with KeepSmooth point array EdgeLength (1
 * component, model length), the lengths that fit; without them those of the mesh itself.
 * Input 1 (Handles, optional): handles, vtkPolyData with point arrays MeshVertices (3 components) and
 * MeshWeights (3), and for stage Stretch field arrays SectionLength and TargetLength. Without handles k is
 * 1.
 *
 * Output 0 (Mesh): the mesh. Points outside the region come first, in their order and bit for bit; then
 * the region's remaining ones, then new ones. Triangles that could not change come first, in their order.
 * Point arrays: measures interpolated (the active normals re-normalised), labels, and Region, taken
 * from the vertex of largest weight. Cell arrays: from the input triangle under the middle of each
 * triangle, of the same Chart. Field data is passed. Global ids, which would no longer be unique, and
 * the arrays of a 4-8 mesh are dropped. New arrays:
 * - cell array SourceCell, vtkIdType[3]: per corner the input triangle it lies on, of the triangle's own
 * chart,
 * - cell array SourceWeights, double[9]: per corner the weights of that triangle's corners (sum 1),
 *   so that an attribute that lives on corners (texture coordinates across seams) can be interpolated;
 *   (SourcesOfAll off) both as field arrays, of the triangles that could change alone, which come last, and
 *   field array UnchangedCell, int: the input triangle that each of the others is,
 * - field array GuideLength, double (stage Stretch): L,
 * - point array EdgeLength, double (stage Stretch, with KeepSmooth): the lengths that fit the input's
 * triangles, interpolated; 0 away from the region.
 * Output 1 (Handles): the handles bound to output 0: MeshVertices, MeshWeights (unused vertices repeat the
 * first) and positions; everything else passed. Empty if there are none.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray, Cancelled. A mesh without
 * points gives an empty output silently; a region without a triangle passes the mesh through in the order
 * above.
 *
 * Deterministic: splits, collapses and flips are made one by one in an order given by length and place;
 * threads relax all vertices at once, each from where its neighbours were. The result is kept while points,
 * polygons, Region, ShapeDiameter, EdgeLength, Chart, handle bindings and parameters stand; then the same
 * points, polygons and (for unchanged input arrays) the same arrays come out. Cost: about 3 microseconds per
 * triangle of the region on two threads.
 *
 * @sa vtkOversketchLaplacianDeform, vtkOversketchTargets, vtkOversketchShapeDiameter
 */
#ifndef vtkOversketchRemesh_h
#define vtkOversketchRemesh_h

#include "OversketchFiltersRemeshModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSREMESH_EXPORT vtkOversketchRemesh : public vtkOversketchFilter
{
public:
  static vtkOversketchRemesh* New();
  vtkTypeMacro(vtkOversketchRemesh, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum StageType
  {
    Stretch = 0,
    Restore = 1
  };

  /**
   * The handles, on port 1, and where they come out.
   */
  void SetHandlesConnection(vtkAlgorithmOutput* handles) { this->SetInputConnection(1, handles); }
  void SetHandlesData(vtkPolyData* handles) { this->SetInputData(1, handles); }
  vtkPolyData* GetHandlesOutput() { return this->GetOutput(1); }

  /**
   * Gives back the kept result and the outputs; the next Update makes them anew.
   */
  void ReleaseWork();

  ///@{
  /**
   * Stretch: before deforming, to length L k; Restore: after it, to length L. Default Stretch.
   */
  vtkSetClampMacro(Stage, int, Stretch, Restore);
  vtkGetMacro(Stage, int);
  void SetStageToStretch() { this->SetStage(Stretch); }
  void SetStageToRestore() { this->SetStage(Restore); }
  ///@}

  ///@{
  /**
   * Rounds of split, collapse, flip and relax, 1 to 50. Default 5.
   */
  vtkSetClampMacro(Iterations, int, 1, 50);
  vtkGetMacro(Iterations, int);
  ///@}

  ///@{
  /**
   * Keep edges under half of the ShapeDiameter array's value. Default on; off as published.
   */
  vtkSetMacro(LimitByDiameter, bool);
  vtkGetMacro(LimitByDiameter, bool);
  vtkBooleanMacro(LimitByDiameter, bool);
  ///@}

  ///@{
  /**
   * Keep vertices and edges that carry handles where they are (edges may be split). Default on; off as
   * published.
   */
  vtkSetMacro(ProtectSection, bool);
  vtkGetMacro(ProtectSection, bool);
  vtkBooleanMacro(ProtectSection, bool);
  ///@}

  ///@{
  /**
   * Leave what is smooth as smooth as it is, and what is sharp where it is (see the departures). Default on;
   * off as published.
   */
  vtkSetMacro(KeepSmooth, bool);
  vtkGetMacro(KeepSmooth, bool);
  vtkBooleanMacro(KeepSmooth, bool);
  ///@}

  ///@{
  /**
   * At last take out folds that the input has (see the departures). Default off, as published.
   */
  vtkSetMacro(TakeOutFolds, bool);
  vtkGetMacro(TakeOutFolds, bool);
  vtkBooleanMacro(TakeOutFolds, bool);
  ///@}

  ///@{
  /**
   * Write the sources of all triangles, 96 bytes each, or of those alone that could change. Default on.
   */
  vtkSetMacro(SourcesOfAll, bool);
  vtkGetMacro(SourcesOfAll, bool);
  vtkBooleanMacro(SourcesOfAll, bool);
  ///@}

  /**
   * L [model length] and k of the last update.
   */
  vtkGetMacro(GuideLength, double);
  vtkGetMacro(Factor, double);

  /**
   * How many triangles the target lengths of the last result asked for, where that was more than are made: 64
   * times as many as there were and 20,000, or 500,000. The lengths were raised then, the least ones first. 0
   * where nothing was.
   */
  vtkGetMacro(TrianglesWanted, double);

  /**
   * How many times a mesh has really been remeshed, not found again.
   */
  vtkGetMacro(RemeshCount, vtkIdType);

protected:
  vtkOversketchRemesh();
  ~vtkOversketchRemesh() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Stage = Stretch;
  int Iterations = 5;
  bool LimitByDiameter = true;
  bool ProtectSection = true;
  bool KeepSmooth = true;
  bool TakeOutFolds = false;
  bool SourcesOfAll = true;
  double GuideLength = 0.0;
  double Factor = 1.0;
  double TrianglesWanted = 0.0;
  vtkIdType RemeshCount = 0;

  struct Cache;
};

#endif
