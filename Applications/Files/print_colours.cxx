#include "print_colours.h"

#include "colours.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace oversketch_files
{

const char* const faceColourExtensions = ".ply .stl .off .vtp";

namespace
{

using Colour = std::array<double, 3>; // bytes

Colour between(const Colour& a, const Colour& b, double share)
{
  Colour made;
  for (std::size_t k = 0; k < 3; ++k)
  {
    made[k] = std::round(a[k] + share * (b[k] - a[k]));
  }
  return made;
}

Colour colourOf(double thick, double wall)
{
  const Colour red{ 215, 48, 39 }, yellow{ 254, 224, 144 }, pale{ 224, 243, 248 }, blue{ 69, 117, 180 },
    grey{ 150, 150, 150 };
  return thick < 0.0    ? grey
         : thick == 0.0 ? red
         : thick < wall ? between(red, yellow, thick / wall)
                        : between(pale, blue, wall > 0.0 ? std::min(1.0, thick / wall - 1.0) : 1.0);
}

} // namespace

vtkSmartPointer<vtkPolyData> colouredByWall(vtkPolyData* checked, double wall)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(checked->GetPoints());
  mesh->SetPolys(checked->GetPolys());
  vtkDataArray* walls = checked->GetCellData()->GetArray("Wall");
  vtkDataArray* faulty = checked->GetCellData()->GetArray("Faulty");
  mesh->GetCellData()->AddArray(walls);
  mesh->GetCellData()->AddArray(faulty);
  std::vector<double> colours;
  for (vtkIdType face = 0; face < walls->GetNumberOfTuples(); ++face)
  {
    const bool isFaulty = faulty->GetComponent(face, 0) != 0.0;
    for (const double byte : isFaulty ? Colour{ 25, 25, 25 } : colourOf(walls->GetComponent(face, 0), wall))
    {
      colours.push_back(byte / 255.0);
    }
  }
  setColours(mesh->GetCellData(), colours, 3);
  return mesh;
}

} // namespace oversketch_files
