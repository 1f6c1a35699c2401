/**
 * @class vtkOversketchLayerHandleRepresentation
 * @brief the grey layers of vtkOversketchLayerHandleWidget, on the disc or on the model, and their handles
 *
 * Each fragment has the grey of its layer (Kernels/Shading/layers.h), so borders of layers are sharp at any
 * zoom; with areas, which have layers of their own, the display image of vtkOversketchShadingLevels is shown
 * in their place. On the model the greys are lit and lie over the surface; the disc is flat. A handle is a
 * knob on the orange line of all places that are as far on the way from line to ring.
 *
 * @sa vtkOversketchLayerHandleWidget
 */
#ifndef vtkOversketchLayerHandleRepresentation_h
#define vtkOversketchLayerHandleRepresentation_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripRepresentation.h"

#include <memory>
#include <string>

class vtkImageData;
class vtkPolyData;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchLayerHandleRepresentation
  : public vtkOversketchGripRepresentation
{
public:
  static vtkOversketchLayerHandleRepresentation* New();
  vtkTypeMacro(vtkOversketchLayerHandleRepresentation, vtkOversketchGripRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh with point arrays DiscCoords and CurveDistance (vtkOversketchEdit's inner output Distance);
   * null: none. False, with an error, for another one. While its cells and those arrays stay, other places
   * are followed without taking the region out of the mesh again; PatchCount is how often that was done.
   */
  bool SetRegion(vtkPolyData* mesh);
  int GetPatchCount() const;

  enum SideType
  {
    Disc = 0,
    Model = 1
  };
  ///@{
  /**
   * Whether the layers are shown on the Disc (default), x and y from -1 to 1, z = 0, or on the Model.
   */
  void SetSide(int side);
  vtkGetMacro(Side, int);
  void SetSideToDisc() { this->SetSide(Disc); }
  void SetSideToModel() { this->SetSide(Model); }
  ///@}

  ///@{
  /**
   * How many grey levels there are [2 to 256, default 5].
   */
  void SetLevels(int levels);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * Handles and areas, as vtkOversketchShadingLevels has them; empty (default): none. A text that is not
   * understood is refused with an error, and changes nothing.
   */
  void SetLayers(const char* text);
  const char* GetLayers() const { return this->Layers.c_str(); }
  ///@}

  ///@{
  /**
   * Whose handles are shown: an area's, by the number of its stroke; -1 (default): the whole disc's.
   */
  void SetArea(int area);
  vtkGetMacro(Area, int);
  ///@}

  ///@{
  /**
   * Output 2 of vtkOversketchShadingLevels, to be shown in place of the layers of the whole disc; null
   * (default): none.
   */
  void SetDisplay(vtkImageData* display);
  vtkImageData* GetDisplay();
  ///@}

  ///@{
  /**
   * The share of the way from line to ring at a place of the window [px, y up]; 1 beside the region. Whether
   * it is on the region.
   */
  double GetShareAt(double x, double y);
  bool IsOnRegion(double x, double y);
  ///@}

  /**
   * The knob of a handle, by its number from 0, comes as near as its line lets it to a place of the window.
   */
  void PutKnob(int handle, double x, double y);

  int GetNumberOfHandles() const;

  /**
   * As a prop.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;

protected:
  vtkOversketchLayerHandleRepresentation();
  ~vtkOversketchLayerHandleRepresentation() override;

  int FindGrip(const oversketch::View& view, double x, double y) override;
  void Paint(const oversketch::View& view, oversketch::Overlay& overlay) override;

private:
  void Follow();

  int Side = Disc;
  int Levels = 5;
  int Area = -1;
  std::string Layers;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
