// Models of the shared test data as the tests of this module read them; null or empty, saying so, where they
// are absent.
#ifndef oversketch_filters_augment_testing_shared_models_h
#define oversketch_filters_augment_testing_shared_models_h

#include "AugmentTools.h"
#include "Harness/data.h"

#include "vtkOBJReader.h"

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace oversketch_test
{

// Points in single precision, as VTK's reader makes them up to 9.2; later ones read them in double.
inline vtkSmartPointer<vtkPolyData> objModel(const std::string& name)
{
  const std::string path = sharedData("meshes/" + name);
  if (path.empty())
  {
    std::cout << name << " is absent: set OVERSKETCH_DATA\n";
    return nullptr;
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_FLOAT);
  points->DeepCopy(reader->GetOutput()->GetPoints());
  reader->GetOutput()->SetPoints(points);
  return reader->GetOutput();
}

// In double precision, of an .obj of triangles alone or an .off.
inline oversketch::Mesh exactModel(const std::string& name)
{
  oversketch::Mesh mesh;
  std::ifstream file(sharedData("meshes/" + name));
  if (!file)
  {
    std::cout << name << " is absent: set OVERSKETCH_DATA\n";
  }
  const bool off = name.find(".off") != std::string::npos;
  std::string line;
  for (int header = off ? 2 : 0; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string kind = off ? "" : "#";
    Vector3 p;
    oversketch::Triangle t;
    if (header > 0)
    {
      --header;
    }
    else if (off && line.rfind("3 ", 0) == 0 && words >> kind >> t[0] >> t[1] >> t[2])
    {
      mesh.triangles.push_back(t);
    }
    else if (off || (words >> kind && kind == "v"))
    {
      words >> p[0] >> p[1] >> p[2];
      mesh.points.push_back(p);
    }
    else if (kind == "f" && words >> t[0] >> t[1] >> t[2])
    {
      mesh.triangles.push_back({ t[0] - 1, t[1] - 1, t[2] - 1 });
    }
  }
  return mesh;
}

} // namespace oversketch_test
#endif
