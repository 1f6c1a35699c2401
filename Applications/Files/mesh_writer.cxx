#include "colours.h"
#include "kept_arrays.h"
#include "mesh_file.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

namespace oversketch_files
{

namespace
{

void writeVtp(vtkPolyData* mesh, const std::string& path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(path.c_str());
  takeError();
  if (!writer->Write() || writer->GetErrorCode() != vtkErrorCode::NoError || !takeError().empty())
  {
    throw Failed(path + ": could not be written (is the disk full?)");
  }
}

// Not every writer notices a full disk, and not every number fits into every format.
void requireReadBack(vtkPolyData* mesh, const std::string& path)
{
  if (mesh->GetNumberOfPolys() == 0 || !isMeshExtension(extensionOf(path)))
  {
    return; // lines, as inner stages put them out; what is not read
  }
  std::string why;
  try
  {
    Notes none;
    // An STL file keeps no triangle whose corners are one in single precision.
    const vtkIdType read = readMesh(path, none)->GetNumberOfPolys();
    const vtkIdType written = trianglesIn(mesh);
    if (read == written || (extensionOf(path) == ".stl" && read < written))
    {
      return;
    }
    why = "it has " + std::to_string(read) + " triangles of " + std::to_string(written);
  }
  catch (const Failed& failed)
  {
    why = failed.what();
    why.erase(0, why.rfind(path + ": ", 0) == 0 ? path.size() + 2 : 0);
  }
  throw Failed(path + ": could not be written (is the disk full?); what was written reads: " + why);
}

// Pictures beside a PLY file: their names, and which of them each face wears, -1 for none; the latter is
// empty where all wear the first one.
struct PlyPictures
{
  std::vector<std::string> names;
  std::vector<int> worn;
};

PlyPictures picturesBeside(vtkPolyData* mesh, const std::string& path, NewFiles& files)
{
  PlyPictures pictures;
  const std::vector<Piece> pieces = piecesOf(mesh);
  std::vector<int> numbers; // of the pieces
  for (const std::string& name : writePictures(pieces, path, files))
  {
    auto place = std::find(pictures.names.begin(), pictures.names.end(), name);
    if (place == pictures.names.end() && !name.empty())
    {
      place = pictures.names.insert(place, name);
    }
    numbers.push_back(name.empty() ? -1 : static_cast<int>(place - pictures.names.begin()));
  }
  if (pieces.size() > 1)
  {
    const std::vector<int> parts = partsOf(mesh);
    vtkDataArray* ids = mesh->GetCellData()->GetArray("PartId");
    for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
    {
      const auto part =
        std::lower_bound(parts.begin(), parts.end(), static_cast<int>(ids->GetComponent(face, 0)));
      pictures.worn.push_back(numbers[static_cast<std::size_t>(part - parts.begin())]);
    }
  }
  return pictures;
}

// Words for a distance, with its share of the mesh's size; "" up to 1e-4 of that, which nobody sees.
std::string inWords(double distance, double size)
{
  if (!(size > 0.0 && distance > 1e-4 * size))
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

// How far points move where they are rounded to single precision [the mesh's units], in words.
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

// Of a format that holds numbers of single precision alone.
void noteSingle(vtkPolyData* mesh, const std::string& format, Notes& notes)
{
  if (const std::string lost = lostInSingle(mesh); !lost.empty())
  {
    notes.push_back(
      format + " keeps numbers in single precision: so far from the origin points move by up to " + lost +
      "; move the mesh to the origin, or write .obj, .ply, .off, .vtp, .gltf, .glb or .3mf");
  }
}

// Of a format that holds colours as bytes alone.
void noteBytes(const std::string& format, vtkDataArray* colours, Notes& notes)
{
  if (colours && !areBytes(colours))
  {
    notes.push_back(format + " keeps colours of 8 bits; they are rounded");
  }
}

// With the pictures that the mesh wears.
std::set<vtkAbstractArray*> withPictures(vtkPolyData* mesh, std::set<vtkAbstractArray*> kept)
{
  const std::vector<vtkAbstractArray*> pictures = pictureArrays(mesh);
  kept.insert(pictures.begin(), pictures.end());
  return kept;
}

} // namespace

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
  constexpr double keptShare = 1e-6; // of the size
  if (farthest(bounds) * 0.5 * std::numeric_limits<float>::epsilon() > keptShare * box.GetDiagonalLength())
  {
    box.GetCenter(middle.data());
  }
  return middle;
}

std::string bytesOf(vtkPolyData* data)
{
  // Arrays without what VTK remembers of them, such as ranges, which the writer writes where they are known.
  const auto bare = [](vtkDataArray* array)
  {
    auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    copy->ShallowCopy(array);
    copy->SetName(array->GetName());
    if (copy->HasInformation())
    {
      copy->GetInformation()->Clear();
    }
    return copy;
  };
  vtkNew<vtkPolyData> clean;
  clean->ShallowCopy(data);
  vtkNew<vtkPoints> points;
  if (data->GetPoints()) // a drawing without strokes has none
  {
    points->SetData(bare(data->GetPoints()->GetData()));
  }
  clean->SetPoints(points);
  for (vtkFieldData* arrays : { static_cast<vtkFieldData*>(clean->GetPointData()),
         static_cast<vtkFieldData*>(clean->GetCellData()),
         clean->GetFieldData() })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = arrays->GetArray(i);
      if (array && array->GetName())
      {
        arrays->AddArray(bare(array)); // replaces that of its name
      }
    }
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(clean);
  writer->WriteToOutputStringOn();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  takeError();
  if (!writer->Write())
  {
    throw Failed("a mesh could not be encoded; is there memory left?");
  }
  return writer->GetOutputString();
}

void writeMesh(vtkPolyData* mesh, const std::string& path, Notes& notes)
{
  NewFiles files;
  writeMesh(mesh, path, notes, files);
  files.commit();
}

void writeMesh(vtkPolyData* given, const std::string& path, Notes& notes, NewFiles& files)
{
  const std::string extension = extensionOf(path);
  vtkSmartPointer<vtkPolyData> mesh = given;
  if ((extension == ".stl" || extension == ".3mf" || extension == ".gltf" || extension == ".glb") &&
      trianglesIn(mesh) != mesh->GetNumberOfPolys())
  {
    mesh = withoutQuads(mesh);
    const std::string format = extension == ".stl" ? "STL" : extension == ".3mf" ? "3MF" : "glTF";
    notes.push_back(format + " keeps no quads; they are cut in two");
  }
  vtkPointData* points = mesh->GetPointData();
  std::function<void(const std::string&)> write;
  if (extension == ".vtp")
  {
    write = [&](const std::string& file) { writeVtp(mesh, file); };
  }
  else if (extension == ".obj")
  {
    noteDropped(mesh,
      "OBJ",
      withPictures(mesh,
        { points->GetTCoords(),
          points->GetNormals(),
          coloursOf(mesh),
          mesh->GetFieldData()->GetAbstractArray("MaterialLibraries"),
          mesh->GetFieldData()->GetAbstractArray("MaterialNames"),
          mesh->GetCellData()->GetArray("MaterialIds"),
          mesh->GetFieldData()->GetAbstractArray("GroupNames"),
          mesh->GetCellData()->GetArray("GroupIds") }),
      notes);
    const bool isNamed = mesh->GetFieldData()->GetAbstractArray("MaterialLibraries") != nullptr;
    const std::vector<Piece> pieces = isNamed ? std::vector<Piece>{ { "", "", mesh } } : piecesOf(mesh);
    std::string library;
    if (isNamed)
    {
      notes.push_back("OBJ names the material library that was read; it and its pictures are not copied");
    }
    else if (pieces.size() > 1 || !pieces.front().picture.empty())
    {
      requireWritable(path);
      library = writeObjMaterials(pieces, path, files);
      notes.push_back(
        std::string("OBJ keeps the texture") + (pieces.size() > 1 ? "s" : "") + " beside it, in " + library);
    }
    write = [pieces, library](const std::string& file) { writeObj(pieces, file, library); };
  }
  else if (extension == ".ply")
  {
    noteDropped(mesh, "PLY", withPictures(mesh, keptByPly(mesh)), notes);
    noteBytes("PLY", coloursOf(mesh) ? coloursOf(mesh) : faceColoursOf(mesh), notes);
    requireWritable(path);
    const PlyPictures pictures = picturesBeside(mesh, path, files);
    for (const std::string& name : pictures.names)
    {
      notes.push_back("PLY keeps the texture beside it, in " + name);
    }
    write = [mesh, pictures](const std::string& file)
    { writePly(mesh, file, pictures.names, pictures.worn); };
  }
  else if (extension == ".stl")
  {
    noteDropped(mesh, "STL", { faceColoursOf(mesh) }, notes);
    if (!fitsStl(faceColoursOf(mesh)))
    {
      notes.emplace_back("STL keeps colours of faces in 5 bits, without opacity; they are rounded");
    }
    noteSingle(mesh, "STL", notes);
    write = [&](const std::string& file) { writeStl(mesh, file); };
  }
  else if (extension == ".off")
  {
    noteDropped(mesh,
      "OFF",
      { points->GetTCoords(), points->GetNormals(), coloursOf(mesh), faceColoursOf(mesh) },
      notes);
    write = [&](const std::string& file) { writeOff(mesh, file); };
  }
  else if (extension == ".gltf" || extension == ".glb")
  {
    noteDropped(mesh,
      "glTF",
      withPictures(mesh, { points->GetTCoords(), points->GetNormals(), coloursOf(mesh) }),
      notes);
    const std::string name = std::filesystem::path(path).stem().string();
    write = [mesh, name, extension](const std::string& file)
    { writeGltf(piecesOf(mesh), name, file, extension == ".glb"); };
  }
  else if (extension == ".3mf")
  {
    noteDropped(mesh, "3MF", { mesh->GetCellData()->GetArray("PartId") }, notes);
    write = [&](const std::string& file) { write3mf(mesh, file); };
  }
  else
  {
    throw Failed(path + ": is none of the mesh formats " + writtenExtensions);
  }
  files.write(path,
    [&](const std::string& file)
    {
      write(file);
      requireReadBack(mesh, file);
    });
}

} // namespace oversketch_files
