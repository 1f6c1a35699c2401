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

// The array of the texture, for formats that keep it.
vtkAbstractArray* keptTexture(vtkPolyData* mesh)
{
  return textureOf(mesh).empty() ? nullptr : mesh->GetFieldData()->GetAbstractArray(textureArray);
}

// Names the arrays of the mesh that are not among those kept.
void noteDropped(vtkPolyData* mesh,
  const std::string& format,
  const std::set<vtkAbstractArray*>& kept,
  Notes& notes)
{
  std::string names;
  const auto collect = [&](vtkFieldData* data)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (kept.count(array) == 0)
      {
        names += (names.empty() ? "" : ", ") + std::string(array->GetName() ? array->GetName() : "(no name)");
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
        keptTexture(mesh),
        mesh->GetFieldData()->GetAbstractArray("MaterialLibraries"),
        mesh->GetFieldData()->GetAbstractArray("MaterialNames"),
        mesh->GetCellData()->GetArray("MaterialIds") },
      notes);
    std::string library;
    if (mesh->GetFieldData()->GetAbstractArray("MaterialLibraries"))
    {
      notes.push_back("OBJ names the material library that was read; it and its pictures are not copied");
    }
    else if (keptTexture(mesh))
    {
      requireWritable(path);
      library = writeObjMaterial(mesh, path, files);
      notes.push_back("OBJ keeps the texture beside it, in " + library);
    }
    write = [mesh, library](const std::string& file) { writeObj(mesh, file, library); };
  }
  else if (extension == ".ply")
  {
    noteDropped(mesh, "PLY", { points->GetTCoords(), coloursOf(mesh) }, notes);
    single = true;
    write = [&](const std::string& file) { writePly(mesh, file); };
  }
  else if (extension == ".stl")
  {
    noteDropped(mesh, "STL", {}, notes);
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
    noteDropped(mesh, "OFF", {}, notes);
    write = [&](const std::string& file) { writeOff(mesh, file); };
  }
  else if (extension == ".gltf" || extension == ".glb")
  {
    noteDropped(mesh,
      "glTF",
      { points->GetTCoords(), points->GetNormals(), coloursOf(mesh), keptTexture(mesh) },
      notes);
    single = true;
    write = [&](const std::string& file) { writeGltf(mesh, file, extension == ".glb"); };
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
