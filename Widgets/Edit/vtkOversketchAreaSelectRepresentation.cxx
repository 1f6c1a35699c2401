#include "vtkOversketchAreaSelectRepresentation.h"

#include "drawn_curve.h"
#include "edit_overlay.h"
#include "region_patch.h"

#include "Mesh/context.h"
#include "Stroke/canvas.h"
#include "vtkOversketchFilterTools.h"

#include "vtkBoundingBox.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchAreaSelectRepresentation);

namespace
{

constexpr double rimShare = 0.997; // the share at which the region's rim is drawn
constexpr double farthest = 1.5;   // of a sample on the disc's plane
constexpr double longest = 0.015;  // of an outline's steps on the disc, to follow the model

} // namespace

struct vtkOversketchAreaSelectRepresentation::Internals
{
  std::unique_ptr<RegionPatch> patch;
  std::vector<WorldLine> areas;              // on the disc
  std::vector<std::vector<WorldLine>> lines; // of each area, pieces in the world
  std::vector<std::array<Vector3, 2>> border;
  double box[6] = { -1.0, 1.0, -1.0, 1.0, 0.0, 0.0 };
};

vtkOversketchAreaSelectRepresentation::vtkOversketchAreaSelectRepresentation()
  : Inner(std::make_unique<Internals>())
{
}

vtkOversketchAreaSelectRepresentation::~vtkOversketchAreaSelectRepresentation() = default;

void vtkOversketchAreaSelectRepresentation::Follow()
{
  Internals& inner = *this->Inner;
  inner.lines.clear();
  inner.border.clear();
  if (inner.patch)
  {
    const PatchSide side = patchSide(this->Side);
    inner.border = inner.patch->level(side, rimShare);
    for (const WorldLine& area : inner.areas)
    {
      Polyline outline = flat(area.points);
      outline.push_back(outline.front());
      std::vector<WorldLine> pieces(1);
      for (const Vector2& p : uniformPolyline(outline, longest))
      {
        if (const auto place = inner.patch->placeOf(side, p))
        {
          pieces.back().points.push_back(*place);
        }
        else if (this->Side == Disc)
        {
          pieces.back().points.emplace_back(p[0], p[1], 0.0);
        }
        else if (!pieces.back().points.empty())
        {
          pieces.emplace_back();
        }
      }
      inner.lines.push_back(std::move(pieces));
    }
    vtkBoundingBox box;
    for (const Vector3& p : inner.patch->shape(side).points)
    {
      double place[3] = { p[0], p[1], p[2] };
      box.AddPoint(place);
    }
    box.GetBounds(inner.box);
  }
  this->Modified();
}

bool vtkOversketchAreaSelectRepresentation::SetRegion(vtkPolyData* mesh)
{
  Internals& inner = *this->Inner;
  bool fits = true;
  try
  {
    followRegion(inner.patch, mesh);
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    fits = false;
  }
  this->Follow();
  return fits;
}

bool vtkOversketchAreaSelectRepresentation::HasRegion() const
{
  return this->Inner->patch != nullptr;
}

void vtkOversketchAreaSelectRepresentation::SetSide(int side)
{
  if (side != this->Side && (side == Disc || side == Model))
  {
    this->Side = side;
    this->Follow();
  }
}

void vtkOversketchAreaSelectRepresentation::SetAreas(vtkPolyData* areas)
{
  this->Inner->areas = linesOf(areas);
  this->Follow();
}

void vtkOversketchAreaSelectRepresentation::PutOnDisc(vtkPolyData* stroke, vtkPolyData* area)
{
  const Internals& inner = *this->Inner;
  std::vector<Vector3> places;
  if (inner.patch)
  {
    const View view = ViewOf(stroke);
    for (const Vector2& sample : StrokeOf(stroke))
    {
      const SurfaceHit hit = inner.patch->under(patchSide(this->Side), view, sample);
      Vector3& place = places.emplace_back(Vector3::Zero());
      if (hit.found())
      {
        place.head<2>() = inner.patch->discAt(hit.at);
      }
      else if (const auto beside = ontoCanvas(view, sample); beside && this->Side == Disc)
      {
        place.head<2>() = beside->cwiseMax(-farthest).cwiseMin(farthest);
      }
      else
      {
        places.pop_back();
      }
    }
  }
  putLine(area, places);
}

void vtkOversketchAreaSelectRepresentation::Paint(const View& view, Overlay& overlay)
{
  const Internals& inner = *this->Inner;
  for (const Polyline& piece : segmentsIn(view, inner.border))
  {
    overlay.line(piece, 2.0, inkGrey);
  }
  for (std::size_t i = 0; i < inner.lines.size(); ++i)
  {
    overlay.rimmed(seenIn(view, inner.lines[i]), static_cast<int>(i) == this->Area ? 4.5 : 3.0, axisGreen);
  }
}

double* vtkOversketchAreaSelectRepresentation::GetBounds()
{
  return this->Inner->patch ? this->Inner->box : nullptr;
}

void vtkOversketchAreaSelectRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Side: " << (this->Side == Disc ? "disc" : "model") << "\n";
  os << indent << "Area: " << this->Area << "\n";
  os << indent << "Areas: " << this->Inner->areas.size() << "\n";
}
