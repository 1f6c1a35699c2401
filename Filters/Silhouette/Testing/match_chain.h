// The stages from silhouette to targets in a row, and what their tests ask of them. Header-only.
#ifndef oversketch_filters_silhouette_testing_match_chain_h
#define oversketch_filters_silhouette_testing_match_chain_h

#include "Harness/promises.h"
#include "vtkOversketchMatch.h"
#include "vtkOversketchOutline.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchTargets.h"

#include "vtkFieldData.h"

#include <gtest/gtest.h>

namespace oversketch_test
{

const Vector3 up(0, 1, 0), front(0, 0, 1);

inline std::vector<Vector2> arc(const View& view,
  double radius,
  double from,
  double to,
  const Vector3& centre = Vector3::Zero())
{
  std::vector<Vector2> samples;
  const int count = 400;
  for (int i = 0; i <= count; ++i)
  {
    const double a = (from + (to - from) * i / count) * pi / 180.0;
    samples.push_back(view.toDisplay(centre + radius * Vector3(std::cos(a), std::sin(a), 0.0)).head<2>());
  }
  return samples;
}

inline std::vector<Vector3> sphereNormals(const Mesh& mesh)
{
  std::vector<Vector3> normals = mesh.points;
  for (Vector3& n : normals)
    n.normalize();
  return normals;
}

inline vtkSmartPointer<vtkPolyData> sphere(int levels = 5)
{
  const Mesh mesh = icosphere(levels);
  const std::vector<Vector3> normals = sphereNormals(mesh);
  return toPolyData(mesh, &normals);
}

inline Vector3 pointOf(vtkPolyData* data, vtkIdType i)
{
  Vector3 p;
  data->GetPoint(i, p.data());
  return p;
}

inline Vector3 tuple(vtkPolyData* data, const char* name, vtkIdType i)
{
  Vector3 p;
  data->GetPointData()->GetArray(name)->GetTuple(i, p.data());
  return p;
}

inline double field(vtkPolyData* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

inline double angleOf(const Vector3& p)
{
  return std::atan2(p[1], p[0]) * 180.0 / pi;
}

struct Chain
{
  vtkNew<vtkOversketchSilhouette> silhouette;
  vtkNew<vtkOversketchOutline> outline;
  vtkNew<vtkOversketchMatch> match;
  vtkNew<vtkOversketchTargets> targets;
  vtkNew<vtkPolyData> stroke;

  Chain(vtkPolyData* mesh, vtkPolyData* strokeData, bool withOutline = false)
  {
    this->stroke->ShallowCopy(strokeData);
    this->silhouette->SetInputData(mesh);
    this->silhouette->SetStrokeData(this->stroke);
    this->outline->SetInputData(mesh);
    this->outline->SetStrokeData(this->stroke);
    this->outline->SetCurvesConnection(this->silhouette->GetOutputPort());
    this->match->AddInputConnection(this->silhouette->GetOutputPort());
    if (withOutline)
    {
      this->match->AddInputConnection(this->outline->GetOutputPort());
    }
    this->match->SetStrokeData(this->stroke);
    this->targets->SetInputConnection(this->match->GetOutputPort());
    this->targets->SetStrokeData(this->stroke);
    this->targets->SetMeshData(mesh);
    this->targets->Update();
  }
  void setStroke(vtkPolyData* data)
  {
    this->stroke->ShallowCopy(data);
    this->stroke->Modified();
    this->targets->Update();
  }
};

} // namespace oversketch_test
#endif
