/**
 * @class vtkOversketchAxisHandleWidget
 * @brief handles on a line: three axes to move, scale and turn it by; or the line itself is dragged
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Ch. 4 and 7, Fig. 7.1 and
 * 7.2. For any vtkRenderWindowInteractor. What the hand does is written as operations (vtkOversketchHandles):
 * the same axis of a handle again changes its row, another axis makes one.
 *
 * | event | what it does |
 * |---|---|
 * | left click on the line | a handle is placed there ("pin"), and selected: its axes are seen |
 * | left click on a handle | it is selected |
 * | left drag of the line or a handle | all of the line follows in the plane of the view |
 * | left drag of an axis, inner third | the handle moves along it |
 * | middle third | it scales along it, by the ratio of distances from the handle [0.05 to 20] |
 * | outer third | it turns about it [less than 180 degrees either way] |
 * | Escape | while dragging: as before; else no handle is selected |
 * | Delete, BackSpace | the selected handle goes, with what was done to it |
 *
 * Only the part of the line between a handle's neighbours follows it. A drag of the line is one shift of all
 * handles, which between them add up to all of it; where there is none one is placed under the hand.
 *
 * Left open there and chosen: axes are those of the line before the edit, where the edit has left the handle.
 * An angle is measured about the axis where it looks within 60 degrees at the viewer; else a pixel sideways
 * is a degree. A drag within 3 px is a click. Places are written to a thousandth of the line.
 *
 * @sa vtkOversketchGripWidget vtkOversketchEdit vtkOversketchAxisHandleRepresentation
 */
#ifndef vtkOversketchAxisHandleWidget_h
#define vtkOversketchAxisHandleWidget_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripWidget.h"

#include <string>

class vtkOversketchAxisHandleRepresentation;
class vtkPolyData;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchAxisHandleWidget : public vtkOversketchGripWidget
{
public:
  static vtkOversketchAxisHandleWidget* New();
  vtkTypeMacro(vtkOversketchAxisHandleWidget, vtkOversketchGripWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The line before the edit, with point array VertexId, on its mesh (vtkOversketchEdit::GetHold and its
   * inner output Distance). Null: none. A drag ends. False, with an error, where they do not fit.
   */
  bool SetCurve(vtkPolyData* curve, vtkPolyData* mesh);

  ///@{
  /**
   * What is done to the line, for vtkOversketchEdit or vtkOversketchHandles; empty at first. One that is not
   * understood is refused with an error. Setting it ends a drag and fires no event.
   */
  void SetOperations(const char* text);
  const char* GetOperations();
  ///@}

  ///@{
  /**
   * Places a handle at a share of the line's length [0 to 1], or removes the one that is selected. Returns
   * whether there is another one, or one less. Fire no event.
   */
  bool AddHandle(double t);
  bool RemoveSelectedHandle();
  ///@}

  ///@{
  /**
   * Whether what is dragged is the line as a whole, and its shift since the press [world].
   */
  bool IsDraggingLine() const { return this->IsDragging() && this->PulledLine; }
  vtkGetVector3Macro(Shift, double);
  ///@}

  void SetRepresentation(vtkOversketchAxisHandleRepresentation* representation);
  vtkOversketchAxisHandleRepresentation* GetAxisHandleRepresentation();
  void CreateDefaultRepresentation() override;

protected:
  vtkOversketchAxisHandleWidget() = default;
  ~vtkOversketchAxisHandleWidget() override;

  bool Grasp(int grip, const int at[2]) override;
  void Pull(const int at[2]) override;
  bool LetGo(bool keep) override;
  bool UseKey(const std::string& key) override;

private:
  void PullLine(const int at[2]);
  void PullAxis(const int at[2]);
  void Select(double t);

  std::string Before; // at the press
  int Grip = 0, From[2] = { 0, 0 };
  double T = 0.0;
  bool Moved = false, PulledLine = false;
  double Shift[3] = { 0.0, 0.0, 0.0 };
};

#endif
