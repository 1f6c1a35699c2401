#include "vtkOversketchRegionRepresentation.h"

#include "drawn_curve.h"
#include "edit_overlay.h"
#include "pen_view.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <limits>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchRegionRepresentation);

struct vtkOversketchRegionRepresentation::Internals
{
  std::vector<WorldLine> curves[2]; // the line, the ring

  double distance(const View& view, int curve, const Vector2& place) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const WorldLine& line : this->curves[curve - Reference])
    {
      least = std::min(least, distanceTo(view, line.points, line.closed, place));
    }
    return least;
  }
};

vtkOversketchRegionRepresentation::vtkOversketchRegionRepresentation()
  : Inner(std::make_unique<Internals>())
{
}

vtkOversketchRegionRepresentation::~vtkOversketchRegionRepresentation() = default;

void vtkOversketchRegionRepresentation::SetReference(vtkPolyData* line)
{
  this->Inner->curves[0] = linesOf(line);
  this->Modified();
}

void vtkOversketchRegionRepresentation::SetBoundary(vtkPolyData* ring)
{
  this->Inner->curves[1] = linesOf(ring);
  this->Modified();
}

double vtkOversketchRegionRepresentation::DistanceTo(int curve, double x, double y)
{
  const bool isCurve = curve == Reference || curve == Boundary;
  const auto view = this->Renderer && isCurve ? PenView::of(this->Renderer).sight() : std::nullopt;
  return view ? this->Inner->distance(*view, curve, inViewport(this->Renderer, x, y))
              : std::numeric_limits<double>::infinity();
}

int vtkOversketchRegionRepresentation::FindGrip(const View& view, double x, double y)
{
  const double line = this->Inner->distance(view, Reference, Vector2(x, y)),
               ring = this->Inner->distance(view, Boundary, Vector2(x, y));
  return std::min(line, ring) > this->GetGrabDistance() ? 0 : line <= ring ? Reference : Boundary;
}

void vtkOversketchRegionRepresentation::Paint(const View& view, Overlay& overlay)
{
  for (const bool isRim : { true, false })
  {
    for (const int curve : { Boundary, Reference })
    {
      const bool isThin = this->LineWas && curve == Reference;
      const double width = (this->GetActiveGrip() == curve ? 5.0
                             : isThin                      ? 1.0
                                                           : 3.0) +
                           (isRim && !isThin ? 2.0 : 0.0);
      const Colour colour = isRim ? paperWhite : curve == Boundary ? sectionBlue : strokeRed;
      for (const Polyline& piece : seenIn(view, this->Inner->curves[curve - Reference]))
      {
        overlay.line(piece, width, colour);
      }
    }
  }
}

void vtkOversketchRegionRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LineWas: " << this->LineWas << "\n";
  os << indent << "Reference: " << this->Inner->curves[0].size() << " polylines\n";
  os << indent << "Boundary: " << this->Inner->curves[1].size() << " polylines\n";
}
