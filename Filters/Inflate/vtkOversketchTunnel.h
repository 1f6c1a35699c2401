/**
 * @class vtkOversketchTunnel
 * @brief cuts the drawing's tunnels through its surface
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.3.1, Fig. 15b: the faces of a tunnel's region are
 * taken out of the surface, front and back, after that has been made; its rim stands where it would without.
 * What lies in the region goes with it. Departure: this leaves two open loops; they are joined by walls as
 * vtkOversketchExtrude makes them, unless TunnelWall is off, as published.
 *
 * Input 0 (Mesh): the surface of vtkOversketchInflate or vtkOversketchExtrude, with cell array RegionId.
 * Input 1 (Curves): the drawing's curves, as vtkOversketchClassify or a filter behind it puts them out; cell
 * array Treatment (see vtkOversketchTreatment) says which closed features are tunnels, without it none is.
 *
 * Output 0 (Mesh): the surface without these faces and the points that only they had, then the walls' points
 * and faces; arrays as vtkOversketchExtrude writes them. Without tunnels the input goes through.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray naming an absent array; BadMesh where
 * a tunnel reaches a rim, takes all, or front and back do not fit each other; BadStroke for contradictions in
 * the curves' arrays. A mesh without points gives an empty output silently.
 *
 * Deterministic. Cost: linear in the surface.
 *
 * @sa vtkOversketchTreatment vtkOversketchInflate vtkOversketchExtrude
 */
#ifndef vtkOversketchTunnel_h
#define vtkOversketchTunnel_h

#include "OversketchFiltersInflateModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSINFLATE_EXPORT vtkOversketchTunnel : public vtkOversketchFilter
{
public:
  static vtkOversketchTunnel* New();
  vtkTypeMacro(vtkOversketchTunnel, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The curves, on port 1.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(1, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(1, curves); }

  ///@{
  /**
   * Close tunnels by walls between their rims [default on; as published: off].
   */
  vtkSetMacro(TunnelWall, bool);
  vtkGetMacro(TunnelWall, bool);
  vtkBooleanMacro(TunnelWall, bool);
  ///@}

  /**
   * How many times tunnels have been cut: executions that the kept result did not answer.
   */
  vtkGetMacro(TunnelCount, vtkIdType);

protected:
  vtkOversketchTunnel() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchTunnel() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  bool TunnelWall = true;
  vtkIdType TunnelCount = 0;
};

#endif
