#include "mesh_file.h"
#include "quads.h"
#include "texture.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPLYWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <set>

namespace oversketch_files
{

namespace
{

template <typename Writer>
void finish(Writer* writer, const std::string& path)
{
  takeError();
  writer->SetFileName(path.c_str());
  const int done = writer->Write();
  if (!done || writer->GetErrorCode() != vtkErrorCode::NoError || !takeError().empty())
  {
    throw Failed(path + ": could not be written (is the disk full?)");
  }
}

void writePly(vtkPolyData* mesh, const std::string& path)
{
  vtkNew<vtkPLYWriter> writer;
  vtkNew<vtkPolyData> single; // it takes the memory of texture coordinates for floats without a look
  single->ShallowCopy(mesh);
  if (vtkDataArray* textures = mesh->GetPointData()->GetTCoords())
  {
    vtkNew<vtkFloatArray> floats;
    floats->DeepCopy(textures);
    single->GetPointData()->SetTCoords(floats);
  }
  writer->SetInputData(single);
  writer->SetFileTypeToBinary();
  writer->SetColorModeToOff();
  if (vtkDataArray* colours = coloursOf(mesh))
  {
    writer->SetColorModeToDefault();
    writer->SetArrayName(colours->GetName());
    writer->SetEnableAlpha(colours->GetNumberOfComponents() == 4);
  }
  finish(writer.Get(), path);
}

// Not every writer notices a full disk, and not every number fits into every format.
void requireReadBack(vtkPolyData* mesh, const std::string& path)
{
  if (mesh->GetNumberOfPolys() == 0)
  {
    return; // lines, as inner stages put them out
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

// The name of an array for a note; those of an assembled mesh's parts, Part12.Canvas, have one for all.
std::string notedName(vtkAbstractArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "(no name)";
  const std::size_t dot = name.find_first_not_of("0123456789", 4);
  const bool ofPart = name.rfind("Part", 0) == 0 && dot != 4 && dot != std::string::npos && name[dot] == '.';
  return ofPart ? "Part…" + name.substr(dot) : name;
}

// Names the arrays of the mesh that are neither among those kept nor its pictures, where these are.
void noteDropped(vtkPolyData* mesh,
  const std::string& format,
  std::set<vtkAbstractArray*> kept,
  bool keepsPictures,
  Notes& notes)
{
  const std::vector<vtkAbstractArray*> pictures = pictureArrays(mesh);
  kept.insert(pictures.begin(), keepsPictures ? pictures.end() : pictures.begin());
  std::string names;
  std::set<std::string> named;
  const auto collect = [&](vtkFieldData* data)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      const std::string name = notedName(array);
      if (kept.count(array) == 0 && (name.rfind("Part…", 0) != 0 || named.insert(name).second))
      {
        names += (names.empty() ? "" : ", ") + name;
      }
    }
  };
  collect(mesh->GetPointData());
  collect(mesh->GetCellData());
  collect(mesh->GetFieldData());
  if (!names.empty())
  {
    notes.push_back(format + " does not keep the arrays: " + names);
  }
}

} // namespace

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
  if ((extension == ".stl" || extension == ".gltf" || extension == ".glb") &&
      trianglesIn(mesh) != mesh->GetNumberOfPolys())
  {
    mesh = withoutQuads(mesh);
    notes.push_back(
      std::string(extension == ".stl" ? "STL" : "glTF") + " keeps no quads; they are cut in two");
  }
  vtkPointData* points = mesh->GetPointData();
  std::function<void(const std::string&)> write;
  bool single = false;
  if (extension == ".vtp")
  {
    write = [&](const std::string& file)
    {
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetInputData(mesh);
      finish(writer.Get(), file);
    };
  }
  else if (extension == ".obj")
  {
    noteDropped(mesh,
      "OBJ",
      { points->GetTCoords(),
        points->GetNormals(),
        mesh->GetFieldData()->GetAbstractArray("MaterialLibraries"),
        mesh->GetFieldData()->GetAbstractArray("MaterialNames"),
        mesh->GetCellData()->GetArray("MaterialIds") },
      true,
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
    noteDropped(mesh, "PLY", { points->GetTCoords(), coloursOf(mesh) }, false, notes);
    single = true;
    write = [&](const std::string& file) { writePly(mesh, file); };
  }
  else if (extension == ".stl")
  {
    noteDropped(mesh, "STL", {}, false, notes);
    single = true;
    write = [&](const std::string& file)
    {
      vtkNew<vtkSTLWriter> writer;
      writer->SetInputData(mesh);
      writer->SetFileTypeToBinary();
      finish(writer.Get(), file);
    };
  }
  else if (extension == ".off")
  {
    noteDropped(mesh, "OFF", {}, false, notes);
    write = [&](const std::string& file) { writeOff(mesh, file); };
  }
  else if (extension == ".gltf" || extension == ".glb")
  {
    noteDropped(mesh, "glTF", { points->GetTCoords(), points->GetNormals(), coloursOf(mesh) }, true, notes);
    single = true;
    write = [&](const std::string& file) { writeGltf(piecesOf(mesh), file, extension == ".glb"); };
  }
  else
  {
    throw Failed(path + ": is none of the mesh formats " + meshExtensions);
  }
  if (single && mesh->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    notes.push_back(extension.substr(1) + " keeps points in single precision");
  }
  files.write(path,
    [&](const std::string& file)
    {
      write(file);
      requireReadBack(mesh, file);
    });
}

} // namespace oversketch_files
