/**
 * @class vtkOversketchPrintCheck
 * @brief what keeps a mesh from being printed, and how thick its walls are
 *
 * Looks whether the mesh is closed and oriented, counts its bodies and the pairs of faces that pass through
 * each other, and measures walls: from the middle of each face straight inward to where that leaves the body.
 * Not the shape diameter (vtkOversketchShapeDiameter), whose median of a cone is wider than the wall that a
 * nozzle has to lay. Walls are exact at middles of faces, so that a thin place within a large face may be
 * missed. Points with equal places count as one, so that seams of a texture are no holes.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, open or not.
 *
 * Output 0: the input with two cell arrays added:
 * - Wall, double, [model length]; -1 where a face has none, as nothing is behind it, or it has no area;
 * - Faulty, unsigned char, the sum of 1: an edge has no other face, 2: the face beyond an edge faces the
 * other way, 4: an edge has more than two faces, 8: the face passes through another, 16: its body is inside
 * out.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh. A mesh without points gives an empty
 * output silently, and is not ready.
 *
 * Deterministic: same result bit for bit for any number of threads. All that is found is kept while the mesh
 * stands: another Wall costs no ray. Each body with less than no volume costs a look at every face.
 *
 * @sa vtkOversketchShapeDiameter
 */
#ifndef vtkOversketchPrintCheck_h
#define vtkOversketchPrintCheck_h

#include "OversketchFiltersPrintModule.h" // For export macro
#include "Print/print_check.h"            // For what it finds
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPRINT_EXPORT vtkOversketchPrintCheck : public vtkOversketchFilter
{
public:
  static vtkOversketchPrintCheck* New();
  vtkTypeMacro(vtkOversketchPrintCheck, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Thickness that no wall may be below [model length; default 0: none].
   */
  vtkSetClampMacro(Wall, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Wall, double);
  ///@}

  /**
   * Whether the mesh of the last run has a body, no face of it a fault, and no wall is thinner than Wall.
   */
  bool IsReady() const { return this->Found().isReady(this->Wall); }

  ///@{
  /**
   * Edges of the last mesh: with one face; with two that run along it the same way; with more than two. 0
   * after a run that failed, as all that follow.
   */
  int GetOpenEdges() const { return this->Found().openEdges; }
  int GetTurnedEdges() const { return this->Found().turnedEdges; }
  int GetCrowdedEdges() const { return this->Found().crowdedEdges; }
  ///@}

  ///@{
  /**
   * Holes, which are runs of open edges; the length of the longest, and the middle of its edges.
   */
  int GetHoles() const { return this->Found().holes; }
  double GetLargestHoleLength() const { return this->Found().holeLength; }
  void GetLargestHole(double place[3]) const;
  ///@}

  ///@{
  /**
   * Bodies, which are faces that edges and points join, in the order of their first faces; the volume of each
   * [length^3], positive where its faces look outward; how many of them are hollows within others, and how
   * many are inside out, or would be, but for an open edge nothing is said of either.
   */
  int GetNumberOfBodies() const { return static_cast<int>(this->Found().bodies.size()); }
  double GetBodyVolume(int body) const;
  int GetHollows() const { return this->Found().hollows; }
  int GetInsideOut() const { return this->Found().insideOut; }
  ///@}

  /**
   * Pairs of faces that pass through each other, or touch elsewhere than in a common point.
   */
  int GetCrossingPairs() const { return this->Found().crossings; }

  ///@{
  /**
   * The thinnest wall [model length], -1 for none; the area of faces with walls thinner than Wall [length^2].
   */
  double GetLeastWall() const { return this->Found().leastWall; }
  double GetThinArea() const { return this->Found().thinArea(this->Wall); }
  ///@}

  /**
   * All of it as the kernel found it, for hosts that tell it in words.
   */
  const oversketch::PrintCheck& Found() const { return *this->Last; }

protected:
  vtkOversketchPrintCheck();
  ~vtkOversketchPrintCheck() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Wall = 0.0;
  const oversketch::PrintCheck* Last; // of what is kept, or of nothing
};

#endif
