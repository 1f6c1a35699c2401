/**
 * @class vtkOversketchAreaSelectRepresentation
 * @brief the areas of vtkOversketchAreaSelectWidget, on the disc or on the model
 *
 * Outlines, green, the current one's wider, over the region's rim, grey.
 *
 * @sa vtkOversketchAreaSelectWidget
 */
#ifndef vtkOversketchAreaSelectRepresentation_h
#define vtkOversketchAreaSelectRepresentation_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripRepresentation.h"

#include <memory>

class vtkPolyData;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchAreaSelectRepresentation
  : public vtkOversketchGripRepresentation
{
public:
  static vtkOversketchAreaSelectRepresentation* New();
  vtkTypeMacro(vtkOversketchAreaSelectRepresentation, vtkOversketchGripRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh with point arrays DiscCoords and CurveDistance (vtkOversketchEdit's inner output Distance);
   * null: none. False, with an error, for another one.
   */
  bool SetRegion(vtkPolyData* mesh);
  bool HasRegion() const;

  enum SideType
  {
    Disc = 0,
    Model = 1
  };
  ///@{
  /**
   * Whether areas are on the Disc (default), x and y from -1 to 1, z = 0, or on the Model.
   */
  void SetSide(int side);
  vtkGetMacro(Side, int);
  void SetSideToDisc() { this->SetSide(Disc); }
  void SetSideToModel() { this->SetSide(Model); }
  ///@}

  /**
   * Polylines on the disc, z is ignored; null: none.
   */
  void SetAreas(vtkPolyData* areas);

  ///@{
  /**
   * The area whose outline is wider, by its number from 0; -1 (default): none.
   */
  vtkSetMacro(Area, int);
  vtkGetMacro(Area, int);
  ///@}

  /**
   * A stroke with its view, drawn over the disc or the model, as a polyline on the disc. Samples that miss
   * the model are left out, those beside the disc lie on its plane, at most half its radius beyond it.
   */
  void PutOnDisc(vtkPolyData* stroke, vtkPolyData* area);

  /**
   * As a prop.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;

protected:
  vtkOversketchAreaSelectRepresentation();
  ~vtkOversketchAreaSelectRepresentation() override;

  void Paint(const oversketch::View& view, oversketch::Overlay& overlay) override;

private:
  void Follow();

  int Side = Disc;
  int Area = -1;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
