// Bodies with limbs of known extent, the section that a stroke on a limb would match, and how well a region
// meets a limb.
#ifndef oversketch_filters_region_testing_limbed_bodies_h
#define oversketch_filters_region_testing_limbed_bodies_h

#include "Harness/polydata.h"
#include "Silhouette/extract.h"

#include "vtkFieldData.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace oversketch_test
{

struct Capsule
{
  Vector3 from, to;
  double radius;
  double distance(const Vector3& p) const
  {
    const Vector3 axis = this->to - this->from;
    const double length = axis.squaredNorm();
    const double t = length > 0.0 ? std::clamp((p - this->from).dot(axis) / length, 0.0, 1.0) : 0.0;
    return (p - this->from - t * axis).norm() - this->radius;
  }
};

inline int nearest(const std::vector<Capsule>& capsules, const Vector3& p)
{
  const auto less = [&](const Capsule& a, const Capsule& b) { return a.distance(p) < b.distance(p); };
  return int(std::min_element(capsules.begin(), capsules.end(), less) - capsules.begin());
}

// A ball of radius 0.6 (capsule 0) with `limbs` equal limbs of radius 0.15 and length 1 in the xz plane.
inline std::vector<Capsule> body(int limbs)
{
  std::vector<Capsule> capsules{ { { 0, 0, 0 }, { 0, 0, 0 }, 0.6 } };
  const Vector3 ends[4] = { { 1.5, 0, 0 }, { 0, 0, 1.5 }, { -1.5, 0, 0 }, { 0, 0, -1.5 } };
  for (int i = 0; i < limbs; ++i)
  {
    capsules.push_back({ { 0, 0, 0 }, ends[i], 0.15 });
  }
  return capsules;
}

// The surface of the union of the capsules, by marching on a grid.
inline Mesh surfaceOf(const std::vector<Capsule>& capsules, double spacing = 0.05)
{
  vtkNew<vtkImageData> image;
  const int n = int(2.0 * 1.8 / spacing);
  image->SetDimensions(n, n, n);
  image->SetSpacing(spacing, spacing, spacing);
  const double origin = -0.5 * (n - 1) * spacing + 0.37 * spacing; // no grid point on a plane of symmetry
  image->SetOrigin(origin, origin, origin);
  image->AllocateScalars(VTK_DOUBLE, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Vector3 p;
    image->GetPoint(i, p.data());
    static_cast<double*>(image->GetScalarPointer())[i] = -capsules[nearest(capsules, p)].distance(p);
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData* surface = contour->GetOutput();
  Mesh mesh;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    mesh.points.emplace_back(surface->GetPoint(i));
  }
  double volume = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    surface->GetCellPoints(i, count, ids);
    mesh.triangles.push_back({ int(ids[0]), int(ids[1]), int(ids[2]) });
    volume += mesh.points[ids[0]].dot(mesh.points[ids[1]].cross(mesh.points[ids[2]]));
  }
  if (volume < 0.0)
  {
    for (Triangle& t : mesh.triangles)
    {
      std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

// Handles along the silhouette seen orthographically from `from`, up to `half` on either side of the point
// nearest tip; they ask for no move.
inline vtkSmartPointer<vtkPolyData> handlesAt(const Mesh& mesh,
  const Vector3& from,
  const Vector3& up,
  const Vector3& tip,
  double half)
{
  const auto curves =
    extractSilhouette(mesh, buildAdjacency(mesh), vertexNormals(mesh), orthographicView(from, up, 100.0));
  const Curve* curve = nullptr;
  int middle = 0;
  double best = 1e300;
  for (const Curve& c : curves)
  {
    for (int i = 0; i < int(c.points.size()); ++i)
    {
      if ((c.points[i].position - tip).norm() < best)
      {
        best = (c.points[i].position - tip).norm();
        curve = &c;
        middle = i;
      }
    }
  }
  const int n = int(curve->points.size());
  const auto at = [&](int i) -> const CurvePoint& { return curve->points[((i % n) + n) % n]; };
  const auto reach = [&](int direction)
  {
    double length = 0.0;
    int i = middle;
    while (std::abs(i - middle) < n / 2 - 1)
    {
      length += (at(i + direction).position - at(i).position).norm();
      if (length > half)
      {
        break;
      }
      i += direction;
    }
    return i;
  };
  const int first = reach(-1), last = reach(1);
  std::vector<double> lengths{ 0.0 };
  for (int i = first; i < last; ++i)
  {
    lengths.push_back(lengths.back() + (at(i + 1).position - at(i).position).norm());
  }
  auto handles = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName("MeshVertices");
  vertices->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> weights, positions, targets, length;
  weights->SetName("MeshWeights");
  weights->SetNumberOfComponents(3);
  positions->SetName("RelativePosition");
  targets->SetName("UnmergedTarget");
  targets->SetNumberOfComponents(3);
  length->SetName("SectionLength");
  length->InsertNextValue(lengths.back());
  for (int i = first; i <= last; ++i)
  {
    const CurvePoint& p = at(i);
    points->InsertNextPoint(p.position.data());
    const vtkIdType ids[3] = { p.binding.vertices[0], p.binding.vertices[1], p.binding.vertices[2] };
    vertices->InsertNextTypedTuple(ids);
    weights->InsertNextTypedTuple(p.binding.weights.data());
    positions->InsertNextValue(lengths[i - first] / lengths.back());
    targets->InsertNextTuple(p.position.data());
  }
  handles->SetPoints(points);
  handles->GetPointData()->AddArray(vertices);
  handles->GetPointData()->AddArray(weights);
  handles->GetPointData()->AddArray(positions);
  handles->GetPointData()->AddArray(targets);
  handles->GetFieldData()->AddArray(length);
  return handles;
}

inline std::vector<char> flagsOf(vtkPolyData* polyData, const char* name)
{
  std::vector<char> flags;
  vtkDataArray* array = polyData->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    flags.push_back(char(array->GetComponent(i, 0)));
  }
  return flags;
}

// Area of intersection over area of union: the triangles wholly in the region, and those nearest to the
// capsule.
inline double overlap(const Mesh& mesh,
  const std::vector<char>& region,
  const std::vector<Capsule>& capsules,
  int limb)
{
  double both = 0.0, either = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    const Vector3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const double area = (b - a).cross(c - a).norm();
    const bool in = nearest(capsules, (a + b + c) / 3.0) == limb;
    const bool selected = region[t[0]] && region[t[1]] && region[t[2]];
    both += in && selected ? area : 0.0;
    either += in || selected ? area : 0.0;
  }
  return both / either;
}

} // namespace oversketch_test
#endif
