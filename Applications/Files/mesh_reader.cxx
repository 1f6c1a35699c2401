#include "mesh_file.h"
#include "text.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangle.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace oversketch_files
{

const char* const meshExtensions = ".obj .ply .stl .off .vtp .gltf .glb";
const char* const writtenExtensions = ".obj .ply .stl .off .vtp .gltf .glb .3mf";

bool isMeshExtension(const std::string& extension)
{
  return isAmong(extension, meshExtensions);
}

bool isWrittenExtension(const std::string& extension)
{
  return isAmong(extension, writtenExtensions);
}

namespace
{

// Cosine between the triangles (0, 1, 2) and (0, 2, 3) of four corners.
double alike(vtkPolyData* mesh, const std::array<vtkIdType, 4>& ids)
{
  double p[4][3], first[3], second[3];
  for (std::size_t k = 0; k < 4; ++k)
  {
    mesh->GetPoint(ids[k], p[k]);
  }
  vtkTriangle::ComputeNormal(p[0], p[1], p[2], first);
  vtkTriangle::ComputeNormal(p[0], p[2], p[3], second);
  return vtkMath::Dot(first, second);
}

} // namespace

vtkIdType trianglesIn(vtkPolyData* mesh)
{
  return mesh->GetPolys()->GetNumberOfConnectivityIds() - 2 * mesh->GetNumberOfPolys();
}

vtkSmartPointer<vtkPolyData> withoutQuads(vtkPolyData* mesh)
{
  auto cut = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polygons;
  vtkCellData* arrays = cut->GetCellData();
  arrays->CopyAllocate(mesh->GetCellData(), 2 * mesh->GetNumberOfPolys());
  const auto add = [&](vtkIdType from, vtkIdType size, const vtkIdType* ids)
  { arrays->CopyData(mesh->GetCellData(), from, polygons->InsertNextCell(size, ids)); };
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    if (ids->GetNumberOfIds() != 4)
    {
      add(face, ids->GetNumberOfIds(), ids->begin());
      continue;
    }
    std::array<vtkIdType, 4> corners{ ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) };
    const std::array<vtkIdType, 4> turned{ corners[1], corners[2], corners[3], corners[0] };
    if (alike(mesh, turned) > alike(mesh, corners))
    {
      corners = turned;
    }
    const vtkIdType halves[2][3] = { { corners[0], corners[1], corners[2] },
      { corners[0], corners[2], corners[3] } };
    add(face, 3, halves[0]);
    add(face, 3, halves[1]);
  }
  cut->SetPoints(mesh->GetPoints());
  cut->SetPolys(polygons);
  cut->GetPointData()->ShallowCopy(mesh->GetPointData());
  cut->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  return cut;
}

namespace
{

void requireArrays(const std::string& path, vtkDataSetAttributes* data, vtkIdType count, const char* what)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != count)
    {
      std::ostringstream message;
      message << path << ": array " << (array->GetName() ? array->GetName() : "without name") << " has "
              << array->GetNumberOfTuples() << " values for " << count << ' ' << what
              << "; the file is damaged";
      throw Failed(message.str());
    }
  }
}

// Points finite, ids in range, arrays complete.
void requireSound(const std::string& path, vtkPolyData* mesh)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      throw Failed(path + ": point " + std::to_string(i) + " is not finite; repair the file");
    }
  }
  for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    if (!cells->IsValid())
    {
      throw Failed(
        path + ": its cells do not fit together (offsets beyond the connectivity); the file is damaged");
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, ids);
      if (std::any_of(ids->begin(), ids->end(), [points](vtkIdType id) { return id < 0 || id >= points; }))
      {
        throw Failed(path + ": cell " + std::to_string(cell) +
                     " names a point that does not exist; the file is damaged");
      }
    }
  }
  requireArrays(path, mesh->GetPointData(), points, "points");
  requireArrays(path, mesh->GetCellData(), mesh->GetNumberOfCells(), "cells");
}

// Triangulating takes time by the square of the corners.
constexpr vtkIdType mostCorners = 10000;

vtkSmartPointer<vtkPolyData> trianglesOf(const std::string& path, vtkPolyData* mesh, Notes& notes)
{
  const vtkIdType others = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const vtkIdType strips = mesh->GetNumberOfStrips();
  bool triangles = true;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    const vtkIdType size = mesh->GetPolys()->GetCellSize(face);
    triangles = triangles && size == 3;
    if (size > mostCorners)
    {
      throw Failed(path + ": its polygon " + std::to_string(face) + " has " + std::to_string(size) +
                   " corners; at most " + std::to_string(mostCorners) + " are triangulated: split it");
    }
  }
  if (triangles && others + strips == 0)
  {
    return mesh;
  }
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(mesh);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  if (strips + others == 0 && filter->GetOutput()->GetNumberOfPolys() < trianglesIn(mesh))
  {
    filter->SetInputData(withoutQuads(mesh)); // some are too narrow for it
    filter->Update();
  }
  takeError(); // a polygon that cannot be triangulated is left out
  vtkSmartPointer<vtkPolyData> result = filter->GetOutput();
  if (!triangles || strips > 0)
  {
    notes.push_back(path + ": its polygons are triangulated (" + std::to_string(result->GetNumberOfPolys()) +
                    " triangles)");
  }
  if (others > 0)
  {
    notes.push_back(path + ": " + std::to_string(others) + " lines and vertices are dropped");
  }
  return result;
}

vtkSmartPointer<vtkPolyData> soundTriangles(const std::string& path, vtkPolyData* read, Notes& notes)
{
  if (!read || read->GetNumberOfPoints() == 0)
  {
    throw Failed(path + ": holds no points; the file is empty or damaged");
  }
  requireSound(path, read);
  vtkSmartPointer<vtkPolyData> mesh = trianglesOf(path, read, notes);
  if (mesh->GetNumberOfPolys() == 0)
  {
    throw Failed(path + ": holds no polygons; a surface mesh is needed");
  }
  return mesh;
}

} // namespace

vtkSmartPointer<vtkPolyData> readMesh(const std::string& path, Notes& notes)
{
  requireReadable(path);
  using Read = vtkSmartPointer<vtkPolyData> (*)(const std::string&, Notes&);
  static const std::map<std::string, Read> readers = { { ".obj", readObj },
    { ".ply", readPly },
    { ".stl", readStl },
    { ".off", readOff },
    { ".vtp", [](const std::string& file, Notes&) { return readVtp(file, wholeFile(file)); } },
    { ".gltf", readGltf },
    { ".glb", readGltf } };
  const auto reader = readers.find(extensionOf(path));
  if (reader == readers.end())
  {
    throw Failed(path + ": is none of the mesh formats " + meshExtensions);
  }
  vtkSmartPointer<vtkPolyData> mesh = soundTriangles(path, reader->second(path, notes), notes);
  if (const std::string steps = singleSteps(mesh); !steps.empty())
  {
    notes.push_back(path +
                    ": its numbers are of single precision: so far from the origin they come in steps of " +
                    steps + "; save it in double precision (.obj, .ply, .off), or nearer to the origin");
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> parseMesh(const std::string& name, const std::string& bytes)
{
  Notes none;
  return soundTriangles(name, readVtp(name, bytes), none);
}

vtkSmartPointer<vtkPolyData> readStroke(const std::string& path)
{
  requireReadable(path);
  const std::string bytes = wholeFile(path);
  if (extensionOf(path) == ".vtk" || bytes.rfind("# vtk DataFile", 0) == 0)
  {
    throw Failed(
      path + ": is a legacy VTK file, which as text loses digits of the view that a stroke carries; save the "
             "stroke as XML PolyData (.vtp)");
  }
  if (extensionOf(path) != ".vtp")
  {
    throw Failed(path + ": a stroke file is XML PolyData (.vtp)");
  }
  return parseStroke(path, bytes);
}

vtkSmartPointer<vtkPolyData> parseStroke(const std::string& path, const std::string& bytes)
{
  vtkSmartPointer<vtkPolyData> stroke = readVtp(path, bytes);
  if (!stroke || stroke->GetNumberOfPoints() == 0 ||
      stroke->GetNumberOfLines() + stroke->GetNumberOfVerts() == 0) // handles are vertices
  {
    throw Failed(path + ": holds no polyline; the file is empty or damaged");
  }
  requireSound(path, stroke);
  return stroke;
}

} // namespace oversketch_files
