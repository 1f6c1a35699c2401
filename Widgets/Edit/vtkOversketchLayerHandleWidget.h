/**
 * @class vtkOversketchLayerHandleWidget
 * @brief handles on grey layers: dragged out they spread what follows the line, dragged in they draw it in
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.3, Fig. 5.4. For any
 * vtkRenderWindowInteractor; the layers are on the disc, for a window of its own, or on the model. What the
 * hand does is written as the Layers of vtkOversketchShadingLevels, whose rules Kernels/Shading/layers.h has:
 * one handle moves all layers, of several only those between its neighbours; dragged inwards far enough a
 * layer goes, and comes back.
 *
 * | event | what it does |
 * |---|---|
 * | left press on the region | a handle is placed on what is there, and taken hold of |
 * | left press on a handle, all along its line | it is taken hold of |
 * | move | it goes to the share of the way from line to ring that is under the cursor; beside the region 1 |
 * | Escape | while dragging: as before, also without the handle that was just placed |
 * | Delete, BackSpace | the handle that was in the hand last goes |
 *
 * Motion along a layer changes nothing but where the knob is. Shares are written to 1e-4.
 *
 * @sa vtkOversketchGripWidget vtkOversketchLayerHandleRepresentation vtkOversketchAreaSelectWidget
 */
#ifndef vtkOversketchLayerHandleWidget_h
#define vtkOversketchLayerHandleWidget_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripWidget.h"

#include <string>

class vtkOversketchLayerHandleRepresentation;
class vtkPolyData;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchLayerHandleWidget : public vtkOversketchGripWidget
{
public:
  static vtkOversketchLayerHandleWidget* New();
  vtkTypeMacro(vtkOversketchLayerHandleWidget, vtkOversketchGripWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh with point arrays DiscCoords and CurveDistance (vtkOversketchEdit's inner output Distance);
   * null: none. A drag ends. False, with an error, for another one.
   */
  bool SetRegion(vtkPolyData* mesh);

  ///@{
  /**
   * Handles and areas, for vtkOversketchEdit or vtkOversketchShadingLevels; empty at first. One that is not
   * understood is refused with an error. Setting it ends a drag and fires no event.
   */
  void SetLayers(const char* text);
  const char* GetLayers();
  ///@}

  /**
   * Removes the handle that was in the hand last. Returns whether there was one. Fires no event.
   */
  bool RemoveHandle();

  void SetRepresentation(vtkOversketchLayerHandleRepresentation* representation);
  vtkOversketchLayerHandleRepresentation* GetLayerHandleRepresentation();
  void CreateDefaultRepresentation() override;

protected:
  vtkOversketchLayerHandleWidget() = default;
  ~vtkOversketchLayerHandleWidget() override;

  bool Grasp(int grip, const int at[2]) override;
  void Pull(const int at[2]) override;
  bool LetGo(bool keep) override;
  bool UseKey(const std::string& key) override;

private:
  std::string Before, Held; // the layers at the press; the same with the handle in the hand as their last
  int HeldArea = -1;        // whose layers the hand has
  double LastRest = -1.0;   // of the handle that was in the hand last
  bool Moved = false;
  int From[2] = { 0, 0 }; // px
};

#endif
