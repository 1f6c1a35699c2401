/**
 * @class vtkOversketchAxisHandleRepresentation
 * @brief the line of vtkOversketchAxisHandleWidget, its handles, and the axes of the one that is selected
 *
 * The line is red where the edit left it, a handle a knob on it. Of the selected one three axes are drawn, 90
 * px long whatever the zoom: t along the line red, w beside it green, n outward blue; on each an arrow in the
 * inner third, a square in the middle one, a ring in the outer one, which move, scale and rotate. An axis
 * that points within 10 degrees at the viewer, or away, is two rings about the knob: the inner one moves, by
 * a drag up towards the viewer, the outer one rotates.
 *
 * @sa vtkOversketchAxisHandleWidget
 */
#ifndef vtkOversketchAxisHandleRepresentation_h
#define vtkOversketchAxisHandleRepresentation_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripRepresentation.h"

#include <memory>

class vtkPolyData;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchAxisHandleRepresentation
  : public vtkOversketchGripRepresentation
{
public:
  static vtkOversketchAxisHandleRepresentation* New();
  vtkTypeMacro(vtkOversketchAxisHandleRepresentation, vtkOversketchGripRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PartType
  {
    Move = 0,
    Scale = 1,
    Rotate = 2,
    Knob = 3,
    Line = 4
  };

  ///@{
  /**
   * The part of a grip; the handle that it belongs to and the axis (0 t, 1 w, 2 n), -1 where there is none.
   */
  int GetPart(int grip) const;
  int GetHandle(int grip) const;
  int GetAxis(int grip) const;
  ///@}

  /**
   * The line before the edit, with point array VertexId, on its mesh, whose normals say what is outward
   * (vtkOversketchHandles' inputs 0 and 1). Null: none. False, with an error, where they do not fit.
   */
  bool SetCurve(vtkPolyData* curve, vtkPolyData* mesh);

  ///@{
  /**
   * What is done to the line (vtkOversketchHandles); empty (default): nothing. A text that is not understood
   * is refused with an error, and changes nothing.
   */
  void SetOperations(const char* text);
  const char* GetOperations() const;
  ///@}

  ///@{
  /**
   * Handles along the line, from 0, and where each is: share of the line's length.
   */
  int GetNumberOfHandles() const;
  double GetHandleT(int handle) const;
  ///@}

  ///@{
  /**
   * The handle whose axes are drawn; -1 (default): none.
   */
  vtkSetMacro(SelectedHandle, int);
  vtkGetMacro(SelectedHandle, int);
  ///@}

  ///@{
  /**
   * For a drag: places of the window [px, y up], the line and the handle as they were at StartDrag. The share
   * of the line's length nearest to a place as it is seen (-1: none); whether that is within GrabDistance;
   * what dragging an axis does: a length, a factor, degrees; what dragging the line does, a vector in the
   * plane of the view [world], and the same along a handle's axes.
   */
  double GetT(double x, double y);
  bool IsOnLine(double x, double y);
  void StartDrag(double x, double y, int handle, double t);
  double GetAmount(int part, int axis, double x, double y);
  void GetShift(double x, double y, double shift[3]);
  void GetAlongAxes(double t, const double shift[3], double along[3]);
  ///@}

protected:
  vtkOversketchAxisHandleRepresentation();
  ~vtkOversketchAxisHandleRepresentation() override;

  int FindGrip(const oversketch::View& view, double x, double y) override;
  void Paint(const oversketch::View& view, oversketch::Overlay& overlay) override;

private:
  int SelectedHandle = -1;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
