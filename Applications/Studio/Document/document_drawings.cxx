// A document's drawings: begun over a picture or on an empty canvas, or a further part of the model.
#include "document.h"

#include "picture_files.h"
#include "system_strings.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr double canvasSize[2] = { 1024.0, 768.0 }; // of an empty one

// z of the surface that is seen from the front at a place; that of the place where there is none.
double surfaceUnder(vtkPolyData* mesh, const Point& place)
{
  double highest = -std::numeric_limits<double>::infinity();
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    double a[3], b[3], c[3];
    mesh->GetPoint(ids->GetId(0), a);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
    {
      mesh->GetPoint(ids->GetId(i - 1), b);
      mesh->GetPoint(ids->GetId(i), c);
      const double at[2] = { place[0], place[1] };
      double flat[3][2], shares[3];
      std::copy_n(a, 2, flat[0]);
      std::copy_n(b, 2, flat[1]);
      std::copy_n(c, 2, flat[2]);
      const bool isOver = vtkTriangle::BarycentricCoords(at, flat[0], flat[1], flat[2], shares) != 0 &&
                          *std::min_element(shares, shares + 3) >= 0.0;
      highest = isOver ? std::max(highest, shares[0] * a[2] + shares[1] * b[2] + shares[2] * c[2]) : highest;
    }
  }
  return std::isfinite(highest) ? highest : place[2];
}

} // namespace

Document::ReadDrawing Document::readDrawing(const QString& picture)
{
  const ReadPicture read = readPicture(picture);
  return { drawingOver(read.image), read.decoded };
}

bool Document::beginDrawing(const std::function<bool()>& mayLeave)
{
  return this->beginDrawing(drawingOn(canvasSize[0], canvasSize[1]), tr("Drawing"), mayLeave);
}

std::function<Document::ReadDrawing()> Document::partReader(const QString& picture) const
{
  // On the model's surface; where there is none yet, over what is drawn on.
  std::optional<Point> place;
  double side = 0.0; // as long as a model that was opened, whose units are no pixels
  if (this->Result.mesh && this->Result.mesh->GetNumberOfPoints() > 0)
  {
    double box[6];
    this->Result.mesh->GetBounds(box);
    place = { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]) };
    (*place)[2] = surfaceUnder(this->Result.mesh, *place);
    side = this->session().mesh ? std::max(box[1] - box[0], box[3] - box[2]) : 0.0;
  }
  const bool isDrawn = !this->session().mesh && !this->session().nodes.empty();
  const SharedStep first = isDrawn ? this->session().nodes.front().step : nullptr;
  return [picture, place, side, first]
  {
    const auto canvas = first ? canvasOf(*first) : std::array<double, 4>{};
    const Point middle{ 0.5 * (canvas[0] + canvas[2]), 0.5 * (canvas[1] + canvas[3]), 0.0 };
    const ReadPicture read = readPicture(picture);
    const int* size = read.decoded->pixels->GetDimensions();
    const double own = std::max(size[0], size[1]);
    const double room = std::max(canvas[2] - canvas[0], canvas[3] - canvas[1]);
    const double length = side > 0.0 ? side : room > 0.0 ? std::min(own, room) : own;
    return ReadDrawing{ partOver(read.image, place ? *place : middle, length / own), read.decoded };
  };
}

bool Document::beginDrawing(SharedStep step, const QString& name, const std::function<bool()>& mayLeave)
{
  if (!mayLeave())
  {
    return false;
  }
  Opened drawing;
  drawing.session.nodes = { firstNode(std::move(step)) };
  drawing.session.meshName = name.toStdString();
  drawing.session.backend = this->Backend;
  this->open(std::move(drawing));
  return true;
}

} // namespace oversketch_studio
