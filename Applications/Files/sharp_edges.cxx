#include "sharp_edges.h"

#include "vtkOversketchCarriedArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

namespace oversketch_files
{

namespace
{

constexpr double edge = 60.0;         // degrees between faces
constexpr double off = 40.0;          // between a face and the normal at a point of it, which an edge bends
constexpr double share = 0.08;        // of such faces: coarse CAD models have over a half, animals up to 0.04
constexpr vtkIdType largest = 200000; // faces
constexpr vtkIdType largestInHand = 20000; // faces of another mesh that follows a hand
constexpr vtkIdType looked = 10000;        // faces that are looked at, evenly among all
// However finely it is divided, a cube's edges are 4.9 times as long as the root of its area, a drum's 2.9.
// Creases of animals are seldom longer than the root, and then most of them end at once.
constexpr double longEnough = 1.0;
// Of their length, what goes on at both ends: CAD models 0.75 and more, animals up to 0.5.
constexpr double unbroken = 0.6;
constexpr double straightOn = 40.0; // degrees
constexpr double crease = 30.0;     // degrees between the faces beside a line that was drawn on the surface
const char* const movedArray = "StellarMoved"; // Filters/Stellar/README.md
constexpr int snapped = 4;                     // in it, of a point that lay on such a line

using Vector = std::array<double, 3>;

double cosine(double degrees)
{
  return std::cos(vtkMath::RadiansFromDegrees(degrees));
}

Vector minus(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

// The cosine between two vectors, of which none need be of length 1; of a vector without length 1.
double between(const Vector& a, const Vector& b)
{
  const double lengths = vtkMath::Norm(a.data()) * vtkMath::Norm(b.data());
  return lengths > 0.0 ? vtkMath::Dot(a.data(), b.data()) / lengths : 1.0;
}

struct SharpFace
{
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  Vector normal{}; // twice as long as its area
};

struct Surface
{
  vtkPoints* points;
  vtkCellArray* faces;
  vtkDataArray* normals;

  Vector point(vtkIdType at) const
  {
    Vector place;
    this->points->GetPoint(at, place.data());
    return place;
  }
  SharpFace face(vtkIdType at) const
  {
    SharpFace face;
    this->faces->GetCellAtId(at, face.count, face.points);
    const Vector first = this->point(face.points[0]);
    Vector last = minus(this->point(face.points[1]), first);
    for (vtkIdType i = 2; i < face.count; ++i)
    {
      const Vector next = minus(this->point(face.points[i]), first);
      Vector cross;
      vtkMath::Cross(last.data(), next.data(), cross.data());
      vtkMath::Add(face.normal.data(), cross.data(), face.normal.data());
      last = next;
    }
    return face;
  }
  // How far the normal at one of its points is off a face.
  double bend(const SharpFace& face, vtkIdType point) const
  {
    Vector normal;
    this->normals->GetTuple(point, normal.data());
    return between(normal, face.normal);
  }
};

// Of so many faces that it needs no closer look.
bool isBentAllOver(const Surface& surface)
{
  const vtkIdType count = surface.faces->GetNumberOfCells();
  const double least = cosine(off);
  const vtkIdType step = std::max(vtkIdType{ 1 }, count / looked);
  vtkIdType bent = 0, seen = 0;
  for (vtkIdType cell = 0; cell < count; cell += step, ++seen)
  {
    const SharpFace face = surface.face(cell);
    const auto isBent = [&](vtkIdType point) { return surface.bend(face, point) < least; };
    bent += std::any_of(face.points, face.points + face.count, isBent);
  }
  return static_cast<double>(bent) > share * static_cast<double>(seen);
}

using Edge = std::pair<vtkIdType, vtkIdType>; // of points

// Each in both directions, in order. The normal at a point of one is half the angle off a face there at
// least, so that few have to be looked at.
std::vector<Edge> edgesOf(const Surface& surface)
{
  const vtkIdType count = surface.faces->GetNumberOfCells();
  std::vector<char> bent(static_cast<std::size_t>(count), 0); // faces with such a point
  const double least = cosine(0.45 * edge);
  const auto look = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      const SharpFace face = surface.face(cell);
      bent[static_cast<std::size_t>(cell)] = std::any_of(
        face.points, face.points + face.count, [&](vtkIdType at) { return surface.bend(face, at) < least; });
    }
  };
  // Others give out their points by way of one list.
  surface.faces->IsStorage64Bit() ? vtkSMPTools::For(0, count, look) : look(0, count);
  std::vector<bool> isBent(static_cast<std::size_t>(surface.points->GetNumberOfPoints()));
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const SharpFace face = bent[static_cast<std::size_t>(cell)] ? surface.face(cell) : SharpFace();
    for (vtkIdType i = 0; i < face.count; ++i)
    {
      if (surface.bend(face, face.points[i]) < least)
      {
        isBent[static_cast<std::size_t>(face.points[i])] = true;
      }
    }
  }
  std::vector<std::pair<Edge, vtkIdType>> sides; // of faces
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    surface.faces->GetCellAtId(cell, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType from = points[i], to = points[i + 1 < size ? i + 1 : 0];
      if (isBent[static_cast<std::size_t>(from)] && isBent[static_cast<std::size_t>(to)])
      {
        sides.push_back({ std::minmax(from, to), cell });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Edge> edges;
  const double sharp = cosine(edge);
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    const auto& [side, cell] = sides[i];
    if (sides[i - 1].first == side &&
        between(surface.face(sides[i - 1].second).normal, surface.face(cell).normal) < sharp)
    {
      edges.push_back(side);
      edges.emplace_back(side.second, side.first);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Whether another one follows on an edge's end, or it is a corner.
bool goesOn(const Surface& surface, const std::vector<Edge>& edges, const Edge& one)
{
  const auto first = std::lower_bound(edges.begin(), edges.end(), Edge(one.second, 0));
  const Vector end = surface.point(one.second), along = minus(end, surface.point(one.first));
  int met = 0;
  bool isStraight = false;
  for (auto it = first; it != edges.end() && it->first == one.second; ++it, ++met)
  {
    isStraight = isStraight || (it->second != one.first &&
                                 between(minus(surface.point(it->second), end), along) > cosine(straightOn));
  }
  return isStraight || met > 2;
}

bool isOutlined(const Surface& surface)
{
  const std::vector<Edge> edges = edgesOf(surface);
  if (edges.empty())
  {
    return false;
  }
  double area = 0.0, all = 0.0, whole = 0.0;
  for (vtkIdType cell = 0; cell < surface.faces->GetNumberOfCells(); ++cell)
  {
    area += 0.5 * vtkMath::Norm(surface.face(cell).normal.data());
  }
  for (const Edge& one : edges)
  {
    const double length =
      0.5 * vtkMath::Norm(minus(surface.point(one.first), surface.point(one.second)).data());
    all += length;
    const bool isWhole = goesOn(surface, edges, one) && goesOn(surface, edges, { one.second, one.first });
    whole += isWhole ? length : 0.0;
  }
  return all > longEnough * std::sqrt(area) && whole > unbroken * all;
}

bool isSharp(vtkPolyData* mesh)
{
  const Surface surface{ mesh->GetPoints(), mesh->GetPolys(), mesh->GetPointData()->GetNormals() };
  const vtkIdType count = mesh->GetNumberOfPolys();
  return surface.normals && count > 0 && count <= largest && (isBentAllOver(surface) || isOutlined(surface));
}

// A face at a point, with its other corners there: those that its edges to the point lead to.
struct SharpCorner
{
  vtkIdType point, cell, beside[2];
  bool operator<(const SharpCorner& other) const { return this->point < other.point; }
};

// At the points of lines that were drawn on the surface, in the points' order.
std::vector<SharpCorner> cornersOnLines(const Surface& surface, vtkDataArray* moved)
{
  std::vector<SharpCorner> corners;
  for (vtkIdType cell = 0; cell < surface.faces->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    surface.faces->GetCellAtId(cell, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (static_cast<int>(moved->GetComponent(points[i], 0)) & snapped)
      {
        corners.push_back(
          { points[i], cell, { points[i > 0 ? i - 1 : size - 1], points[i + 1 < size ? i + 1 : 0] } });
      }
    }
  }
  std::stable_sort(corners.begin(), corners.end());
  return corners;
}

// Whether two faces meet at their point in one smooth piece, without regard to others: they share an edge
// that is no crease of a line.
bool areSmooth(const Surface& surface, vtkDataArray* moved, const SharpCorner& a, const SharpCorner& b)
{
  for (const vtkIdType end : a.beside)
  {
    if (end == b.beside[0] || end == b.beside[1])
    {
      const bool isOfLine = static_cast<int>(moved->GetComponent(end, 0)) & snapped;
      return !isOfLine || between(surface.face(a.cell).normal, surface.face(b.cell).normal) > cosine(crease);
    }
  }
  return false;
}

// A mesh cut along such creases, with, of each of its points, that of the mesh; null where there are none.
// Normals averaged across a crest make a row of teeth of it, one triangle wide.
vtkSmartPointer<vtkPolyData> splitAlongLines(vtkPolyData* mesh, vtkIdList* from)
{
  vtkPointData* data = mesh->GetPointData();
  vtkDataArray* moved = data->GetArray(movedArray);
  const Surface surface{ mesh->GetPoints(), mesh->GetPolys(), data->GetNormals() };
  if (!moved || !surface.normals || moved->GetNumberOfTuples() != mesh->GetNumberOfPoints())
  {
    return nullptr;
  }
  const std::vector<SharpCorner> corners = cornersOnLines(surface, moved);
  struct Piece
  {
    vtkIdType point;
    std::vector<vtkIdType> cells;
  };
  std::vector<Piece> pieces; // that are no longer the point's
  std::vector<std::pair<vtkIdType, Vector>> normals;
  for (auto first = corners.begin(); first != corners.end();)
  {
    const auto last = std::upper_bound(first, corners.end(), *first);
    const auto count = static_cast<std::size_t>(last - first);
    std::vector<std::size_t> pieceOf(count);
    std::iota(pieceOf.begin(), pieceOf.end(), std::size_t{ 0 });
    for (std::size_t a = 0; a < count; ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        if (pieceOf[a] != pieceOf[b] && areSmooth(surface, moved, first[a], first[b]))
        {
          std::replace(pieceOf.begin(), pieceOf.end(), std::size_t{ pieceOf[a] }, std::size_t{ pieceOf[b] });
        }
      }
    }
    const bool isSplit =
      std::any_of(pieceOf.begin(), pieceOf.end(), [&](std::size_t piece) { return piece != pieceOf[0]; });
    for (std::size_t piece = 0; isSplit && piece < count; ++piece)
    {
      Piece one{ first->point, {} };
      Vector normal{};
      for (std::size_t a = 0; a < count; ++a)
      {
        if (pieceOf[a] == piece)
        {
          Vector flat = surface.face(first[a].cell).normal;
          vtkMath::Normalize(flat.data());
          vtkMath::Add(normal.data(), flat.data(), normal.data());
          one.cells.push_back(first[a].cell);
        }
      }
      if (!one.cells.empty())
      {
        vtkMath::Normalize(normal.data());
        const bool isFirst = piece == pieceOf[0];
        normals.emplace_back(
          isFirst ? one.point : mesh->GetNumberOfPoints() + static_cast<vtkIdType>(pieces.size()), normal);
        if (!isFirst)
        {
          pieces.push_back(std::move(one));
        }
      }
    }
    first = last;
  }
  if (pieces.empty())
  {
    return nullptr;
  }
  from->SetNumberOfIds(mesh->GetNumberOfPoints() + static_cast<vtkIdType>(pieces.size()));
  std::iota(from->begin(), from->begin() + mesh->GetNumberOfPoints(), vtkIdType{ 0 });
  vtkNew<vtkCellArray> faces;
  faces->DeepCopy(mesh->GetPolys());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const vtkIdType now = mesh->GetNumberOfPoints() + static_cast<vtkIdType>(i);
    from->SetId(now, pieces[i].point);
    for (const vtkIdType cell : pieces[i].cells)
    {
      vtkNew<vtkIdList> points;
      faces->GetCellAtId(cell, points);
      std::replace(points->begin(), points->end(), vtkIdType{ pieces[i].point }, vtkIdType{ now });
      faces->ReplaceCellAtId(cell, points);
    }
  }
  auto cut = vtkSmartPointer<vtkPolyData>::New();
  const std::vector<vtkIdType> sources(from->begin(), from->end());
  vtkNew<vtkPoints> points;
  points->SetData(oversketch::CarriedArray(mesh->GetPoints()->GetData(), sources));
  cut->SetPoints(points);
  cut->SetPolys(faces);
  cut->GetCellData()->ShallowCopy(mesh->GetCellData());
  cut->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  cut->GetPointData()->CopyAllOn();
  oversketch::CopyElements(data, sources, cut->GetPointData());
  for (const auto& [point, normal] : normals)
  {
    cut->GetPointData()->GetNormals()->SetTuple(point, normal.data());
  }
  return cut;
}

vtkSmartPointer<vtkPolyData> split(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SetFeatureAngle(edge);
  normals->SplittingOn();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

bool areSame(vtkDataArray* a, vtkDataArray* b)
{
  const auto bytes = [](vtkDataArray* of)
  {
    return static_cast<std::size_t>(of->GetNumberOfValues()) *
           static_cast<std::size_t>(of->GetDataTypeSize());
  };
  return a == b || (a->GetDataType() == b->GetDataType() && bytes(a) == bytes(b) &&
                     std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes(a)) == 0);
}

// As vtkPolyDataNormals makes them.
vtkSmartPointer<vtkFloatArray> normalsOf(const Surface& surface)
{
  std::vector<Vector> sums(static_cast<std::size_t>(surface.points->GetNumberOfPoints()));
  for (vtkIdType cell = 0; cell < surface.faces->GetNumberOfCells(); ++cell)
  {
    SharpFace face = surface.face(cell);
    vtkMath::Normalize(face.normal.data());
    for (vtkIdType i = 0; i < face.count; ++i)
    {
      Vector& sum = sums[static_cast<std::size_t>(face.points[i])];
      vtkMath::Add(sum.data(), face.normal.data(), sum.data());
    }
  }
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(surface.points->GetNumberOfPoints());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    vtkMath::Normalize(sums[i].data());
    normals->SetTuple(static_cast<vtkIdType>(i), sums[i].data());
  }
  return normals;
}

} // namespace

vtkSmartPointer<vtkPolyData> SharpEdges::look(vtkPolyData* mesh)
{
  this->Split = nullptr;
  this->Faces = nullptr;
  if (!mesh)
  {
    return mesh;
  }
  this->IsSolid = isSharp(mesh);
  this->Faces = mesh->GetPolys();
  this->Points = mesh->GetNumberOfPoints();
  if (!this->IsSolid)
  {
    this->Split = splitAlongLines(mesh, this->From);
    return this->Split ? this->Split : vtkSmartPointer<vtkPolyData>(mesh);
  }
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("number");
  numbers->SetNumberOfValues(mesh->GetNumberOfPoints());
  std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + numbers->GetNumberOfValues(), vtkIdType{ 0 });
  vtkNew<vtkPolyData> numbered;
  numbered->ShallowCopy(mesh);
  numbered->GetPointData()->AddArray(numbers);
  this->Split = split(numbered);
  vtkPointData* data = this->Split->GetPointData();
  auto* from = vtkIdTypeArray::SafeDownCast(data->GetArray(numbers->GetName()));
  this->From->SetNumberOfIds(from->GetNumberOfValues());
  std::copy_n(from->GetPointer(0), from->GetNumberOfValues(), this->From->GetPointer(0));
  data->RemoveArray(numbers->GetName());
  return this->Split;
}

vtkSmartPointer<vtkPolyData> SharpEdges::lookMoved(vtkPolyData* mesh) const
{
  const bool isIt = mesh && this->Split && mesh->GetNumberOfPoints() == this->Points &&
                    areSame(mesh->GetPolys()->GetConnectivityArray(), this->Faces->GetConnectivityArray()) &&
                    areSame(mesh->GetPolys()->GetOffsetsArray(), this->Faces->GetOffsetsArray());
  if (!isIt)
  {
    const bool isSmall = mesh && this->Split && mesh->GetNumberOfPolys() <= largestInHand;
    vtkNew<vtkIdList> from;
    const vtkSmartPointer<vtkPolyData> cut = !isSmall        ? nullptr
                                             : this->IsSolid ? split(mesh)
                                                             : splitAlongLines(mesh, from);
    return cut ? cut : vtkSmartPointer<vtkPolyData>(mesh);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(this->From->GetNumberOfIds());
  mesh->GetPoints()->GetPoints(this->From, points);
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(this->Split);
  moved->SetPoints(points);
  moved->GetPointData()->SetNormals(normalsOf({ points, moved->GetPolys(), nullptr }));
  return moved;
}

} // namespace oversketch_files
