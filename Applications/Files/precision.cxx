#include "precision.h"

#include "vtkBoundingBox.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace oversketch_files
{

namespace
{

constexpr double seenShare = 1e-4, keptShare = 1e-6; // of the size

std::string inWords(double distance, double size)
{
  if (!(size > 0.0 && distance > seenShare * size))
  {
    return {};
  }
  std::ostringstream text;
  text.precision(2);
  text << distance << ", " << 100.0 * distance / size << " % of the model's size";
  return text.str();
}

double farthest(const double bounds[6])
{
  double most = 0.0;
  for (int k = 0; k < 6; ++k)
  {
    most = std::max(most, std::abs(bounds[k]));
  }
  return most;
}

} // namespace

std::string lostInSingle(vtkPolyData* mesh)
{
  double most = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    for (const double x : p)
    {
      most = std::max(most, std::abs(x - static_cast<double>(static_cast<float>(x))));
    }
  }
  return inWords(most, mesh->GetLength());
}

std::string singleSteps(vtkPolyData* mesh)
{
  if (mesh->GetPoints()->GetDataType() != VTK_FLOAT)
  {
    return {};
  }
  const auto most = static_cast<float>(farthest(mesh->GetBounds()));
  const float next = std::nextafter(most, std::numeric_limits<float>::max());
  return inWords(static_cast<double>(next) - static_cast<double>(most), mesh->GetLength());
}

std::array<double, 3> nearOrigin(const std::vector<Piece>& pieces)
{
  vtkBoundingBox box;
  for (const Piece& piece : pieces)
  {
    box.AddBounds(piece.mesh->GetBounds());
  }
  std::array<double, 3> middle{};
  if (!box.IsValid())
  {
    return middle;
  }
  double bounds[6];
  box.GetBounds(bounds);
  if (farthest(bounds) * 0.5 * std::numeric_limits<float>::epsilon() > keptShare * box.GetDiagonalLength())
  {
    box.GetCenter(middle.data());
  }
  return middle;
}

} // namespace oversketch_files
