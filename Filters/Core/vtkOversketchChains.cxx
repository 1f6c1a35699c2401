#include "vtkOversketchChains.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <sstream>

namespace oversketch
{

namespace
{

const char* const vertexName = "VertexId";
const char* const chainRemedy = "lay the curve into the mesh with vtkOversketchInsertCurve";

} // namespace

std::vector<Chain> ReadChains(vtkPolyData* curves, int vertexCount, const std::string& holder)
{
  const vtkIdType count = curves->GetNumberOfLines(), points = curves->GetNumberOfPoints();
  if (count == 0 || count != curves->GetNumberOfCells())
  {
    throw Error(
      Failure::BadStroke, "The " + holder + " must be polylines and no other cells: " + chainRemedy + ".");
  }
  vtkDataArray* vertices = RequireArray(curves->GetPointData(), vertexName, 1, points, holder, chainRemedy);
  std::vector<Chain> chains(static_cast<std::size_t>(count));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    Chain& chain = chains[static_cast<std::size_t>(cell)];
    curves->GetLines()->GetCellAtId(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      const double vertex = id >= 0 && id < points ? vertices->GetComponent(id, 0) : -1.0;
      if (!(vertex >= 0.0 && vertex < vertexCount))
      {
        std::ostringstream message;
        message << "Point " << i << " of the " << holder
                << " is no vertex of the mesh (array VertexId): " << chainRemedy << '.';
        throw Error(Failure::BadStroke, message.str());
      }
      chain.Vertices.push_back(static_cast<int>(vertex));
      chain.Ids.push_back(id);
    }
  }
  return chains;
}

Chain ReadChain(vtkPolyData* curve, int vertexCount, const std::string& holder)
{
  const std::vector<Chain> chains = ReadChains(curve, vertexCount, holder);
  if (chains.size() > 1)
  {
    std::ostringstream message;
    message << "There are " << chains.size() << " polylines where the " << holder
            << " is one: give that one.";
    throw Error(Failure::BadStroke, message.str());
  }
  return chains.front();
}

MeshKey ChainsKey(vtkPolyData* curves)
{
  return MeshKey(curves, { curves->GetPointData()->GetArray(vertexName) });
}

} // namespace oversketch
