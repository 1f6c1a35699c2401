/**
 * @class vtkOversketchProfilePlaneRepresentation
 * @brief the three planes of vtkOversketchProfilePlaneWidget, and the section that the sliding one cuts
 *
 * Squares round the region through a place of the line, tinted, with their borders: the n-plane
 * blue, the t-plane green, the b-plane, which slides, orange, with a knob on the line. The section lies over
 * all else, from orange at its left end to blue, as in the profile's window.
 *
 * @sa vtkOversketchProfilePlaneWidget vtkOversketchProfileRepresentation
 */
#ifndef vtkOversketchProfilePlaneRepresentation_h
#define vtkOversketchProfilePlaneRepresentation_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripRepresentation.h"

#include <memory>

class vtkPolyData;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchProfilePlaneRepresentation
  : public vtkOversketchGripRepresentation
{
public:
  static vtkOversketchProfilePlaneRepresentation* New();
  vtkTypeMacro(vtkOversketchProfilePlaneRepresentation, vtkOversketchGripRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PlaneType
  {
    N = 0,
    T = 1,
    B = 2
  };

  ///@{
  /**
   * Whether a plane is seen [default on].
   */
  void SetPlaneVisibility(int plane, bool visible);
  bool GetPlaneVisibility(int plane) const;
  int GetNumberOfVisiblePlanes() const;
  ///@}

  /**
   * The line, a polyline in the world, and the box that the planes are to reach round [world: lowest and
   * highest x, y, z]. Null: none.
   */
  void SetCurve(vtkPolyData* curve, const double box[6]);

  /**
   * The planes, output 0 of vtkOversketchProfilePlanes, and the section, output 1 of
   * vtkOversketchCrossSection. Null or empty: none.
   */
  void SetSection(vtkPolyData* planes, vtkPolyData* section);

  /**
   * For a drag: the share of the line's length [0 to 1] that the plane comes to when it is dragged from one
   * place of the window [px, y up] to another, from a share on.
   */
  double GetSlid(double t, const int from[2], const int to[2]);

protected:
  vtkOversketchProfilePlaneRepresentation();
  ~vtkOversketchProfilePlaneRepresentation() override;

  int FindGrip(const oversketch::View& view, double x, double y) override;
  void Paint(const oversketch::View& view, oversketch::Overlay& overlay) override;

private:
  void LayOut();

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
