// What --report tells of an edit: how well line and ring lie in the mesh, how evenly the region is laid flat,
// how its weights fall, what the edit did to its triangles.
#include "edit_figures.h"

#include "report.h"
#include "vtkOversketchCrossSection.h"
#include "vtkOversketchEdit.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchFlatten.h"
#include "vtkOversketchSharedMesh.h"
#include "vtkOversketchStrokeView.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace oversketch_command
{

namespace
{

using oversketch::Adjacency;
using oversketch::Mesh;
using oversketch::Triangle;
using oversketch::Vector3;

// The value at a share of the sorted values; NaN of none.
double ranked(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return std::nan("");
  }
  const auto at =
    values.begin() + static_cast<std::ptrdiff_t>(std::min(
                       share * static_cast<double>(values.size()), static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<double> valuesOf(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

std::vector<int> chainOf(vtkPolyData* curve)
{
  std::vector<int> chain;
  for (const double id : valuesOf(curve, "VertexId"))
  {
    chain.push_back(static_cast<int>(id));
  }
  return chain;
}

double smallestAngle(const Mesh& mesh, const Triangle& t)
{
  double least = 180.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3 a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
    const Vector3 b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
    least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / vtkMath::Pi());
  }
  return least;
}

std::shared_ptr<const oversketch::MeshData> dataOf(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  return oversketch::SharedMesh(bare);
}

// A mesh, and the triangles that have a corner strictly inside the region.
struct Region
{
  std::shared_ptr<const oversketch::MeshData> data;
  std::vector<char> inside; // per triangle
  int vertices = 0, triangles = 0;

  explicit Region(vtkPolyData* mesh)
  {
    this->data = dataOf(mesh);
    const std::vector<double> labels = valuesOf(mesh, "EditRegion");
    this->vertices = static_cast<int>(std::count(labels.begin(), labels.end(), 2.0));
    for (const Triangle& t : this->surface().triangles)
    {
      this->inside.push_back(
        std::any_of(t.begin(), t.end(), [&](int v) { return labels[static_cast<std::size_t>(v)] == 2.0; }));
      this->triangles += this->inside.back();
    }
  }
  const Mesh& surface() const { return this->data->Surface(); }

  std::vector<double> angles() const
  {
    std::vector<double> angles;
    for (std::size_t t = 0; t < this->inside.size(); ++t)
    {
      if (this->inside[t])
      {
        angles.push_back(smallestAngle(this->surface(), this->surface().triangles[t]));
      }
    }
    return angles;
  }
  // Of the edges between two triangles of the region [degrees].
  std::vector<double> dihedrals() const
  {
    const Adjacency& links = this->data->Neighbours();
    std::vector<double> angles;
    for (int e = 0; e < static_cast<int>(links.edges.size()); ++e)
    {
      const int* t = links.trianglesBegin(e);
      if (links.edges[e].triangleCount == 2 && this->inside[t[0]] && this->inside[t[1]])
      {
        const Vector3 a = facetNormal(this->surface(), t[0]), b = facetNormal(this->surface(), t[1]);
        angles.push_back(std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / vtkMath::Pi());
      }
    }
    return angles;
  }
};

Json::Value shapeOf(const Region& region)
{
  Json::Value json;
  json["triangles"] = region.triangles;
  json["smallest_angle_percentile_5"] = number(ranked(region.angles(), 0.05));
  json["dihedral_percentile_95"] = number(ranked(region.dihedrals(), 0.95));
  return json;
}

Vector3 gradient(const Mesh& mesh, const Triangle& t, const std::vector<double>& w)
{
  const Vector3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
  const Vector3 n = (b - a).cross(c - a);
  return (w[t[0]] * n.cross(c - b) + w[t[1]] * n.cross(a - c) + w[t[2]] * n.cross(b - a)) / n.squaredNorm();
}

// The median of the slope's jump over the edges of a curve, over the mean slope of the region. Beyond the
// ring weights are 0.
double slopeJump(const Region& region, const std::vector<double>& weights, const std::vector<int>& chain)
{
  const Mesh& mesh = region.surface();
  double slope = 0.0, area = 0.0;
  for (std::size_t t = 0; t < region.inside.size(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    const double size =
      (mesh.points[c[1]] - mesh.points[c[0]]).cross(mesh.points[c[2]] - mesh.points[c[0]]).norm();
    if (region.inside[t] && size > 0.0)
    {
      slope += size * gradient(mesh, c, weights).norm();
      area += size;
    }
  }
  const Adjacency& links = region.data->Neighbours();
  std::vector<double> jumps;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    const int edge = links.findEdge(chain[i - 1], chain[i]);
    if (edge < 0)
    {
      continue;
    }
    double sum = 0.0;
    for (const int* t = links.trianglesBegin(edge); t != links.trianglesEnd(edge); ++t)
    {
      const Triangle& c = mesh.triangles[*t];
      const int v = *std::find_if(
        c.begin(), c.end(), [&](int corner) { return corner != chain[i - 1] && corner != chain[i]; });
      const Vector3 along = (mesh.points[chain[i]] - mesh.points[chain[i - 1]]).normalized();
      const Vector3 away = mesh.points[v] - mesh.points[chain[i - 1]];
      sum += gradient(mesh, c, weights).dot((away - away.dot(along) * along).normalized());
    }
    jumps.push_back(std::abs(sum) / (slope / area));
  }
  return ranked(jumps, 0.5);
}

// Vertices less edges plus triangles.
int eulerNumber(vtkPolyData* polyData)
{
  const auto data = dataOf(polyData);
  const Mesh& mesh = data->Surface();
  std::vector<char> used(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
  {
    for (const int v : t)
    {
      used[static_cast<std::size_t>(v)] = 1;
    }
  }
  return static_cast<int>(std::count(used.begin(), used.end(), 1)) -
         static_cast<int>(data->Neighbours().edges.size()) + static_cast<int>(mesh.triangles.size());
}

// A curve and the mesh that it lies in.
struct LaidCurve
{
  vtkPolyData* curve;
  vtkPolyData* mesh;
  bool isClosed;
};

// Whether curves meet no vertex twice, and how many of their segments are no edges of the mesh.
void addChains(const std::vector<LaidCurve>& curves, Json::Value& json)
{
  bool isSimple = true;
  int loose = 0;
  for (const LaidCurve& laid : curves)
  {
    std::vector<int> chain = chainOf(laid.curve);
    isSimple = isSimple && std::set<int>(chain.begin(), chain.end()).size() == chain.size();
    if (laid.isClosed && !chain.empty())
    {
      chain.push_back(chain.front());
    }
    const auto data = dataOf(laid.mesh);
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      loose += data->Neighbours().findEdge(chain[i - 1], chain[i]) < 0;
    }
  }
  json["simple"] = isSimple;
  json["segments_off_edges"] = loose;
}

// Of the triangles of the disc: how many are turned over or flat.
int discFlips(vtkPolyData* disc)
{
  int flips = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < disc->GetNumberOfPolys(); ++t)
  {
    disc->GetPolys()->GetCellAtId(t, ids);
    Vector3 corners[3];
    for (int k = 0; k < 3; ++k)
    {
      disc->GetPoint(ids->GetId(k), corners[k].data());
    }
    flips += !((corners[1] - corners[0]).cross(corners[2] - corners[0])[2] > 0.0);
  }
  return flips;
}

// p95 over p5 of the disc's areas by the surface's.
double discAreas(vtkPolyData* disc, const Mesh& mesh)
{
  const std::vector<int> vertices = chainOf(disc);
  std::vector<double> ratios;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < disc->GetNumberOfPolys(); ++t)
  {
    disc->GetPolys()->GetCellAtId(t, ids);
    Vector3 flat[3], solid[3];
    for (int k = 0; k < 3; ++k)
    {
      disc->GetPoint(ids->GetId(k), flat[k].data());
      solid[k] = mesh.points[vertices[static_cast<std::size_t>(ids->GetId(k))]];
    }
    const double area = (solid[1] - solid[0]).cross(solid[2] - solid[0]).norm();
    if (area > 0.0)
    {
      ratios.push_back((flat[1] - flat[0]).cross(flat[2] - flat[0]).norm() / area);
    }
  }
  return ranked(ratios, 0.95) / ranked(ratios, 0.05);
}

// The same where the disc is not balanced.
double plainDiscAreas(vtkOversketchEdit* edit, vtkPolyData* line, const Mesh& mesh)
{
  vtkNew<vtkOversketchFlatten> plain;
  auto* step = vtkOversketchFlatten::SafeDownCast(edit->GetStep("Flatten"));
  plain->SetAsPublished(step->GetAsPublished());
  plain->SetRounds(0);
  vtkNew<vtkPolyData> enclosed, reference;
  enclosed->ShallowCopy(edit->GetInnerOutput("Enclose"));
  reference->ShallowCopy(line);
  plain->SetInputData(enclosed);
  plain->SetReferenceData(reference);
  plain->Update();
  return discAreas(plain->GetDiscOutput(), mesh);
}

double toSegments(const std::vector<Vector3>& line, const Vector3& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    const Vector3 way = line[i] - line[i - 1];
    const double t = std::clamp((p - line[i - 1]).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
    least = std::min(least, (line[i - 1] + t * way - p).norm());
  }
  return least;
}

std::vector<Vector3> pointsOf(vtkPolyData* data)
{
  std::vector<Vector3> points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    points.emplace_back(data->GetPoint(i));
  }
  return points;
}

// How far a curve in the mesh is from the spline that was drawn, in the picture: root mean square and worst.
Json::Value offStroke(const std::vector<Vector3>& curve, vtkPolyData* spline)
{
  Json::Value json;
  std::vector<Vector3> drawn = pointsOf(spline);
  for (Vector3& p : drawn)
  {
    p[2] = 0.0;
  }
  const oversketch::View view = oversketch::ViewOf(spline);
  double sum = 0.0, worst = 0.0;
  for (Vector3 p : curve)
  {
    p = view.toDisplay(p);
    p[2] = 0.0;
    const double away = toSegments(drawn, p);
    sum += away * away;
    worst = std::max(worst, away);
  }
  json["rms_px"] = number(std::sqrt(sum / static_cast<double>(curve.size())));
  json["worst_px"] = number(worst);
  return json;
}

// The points of a curve that lie by what was seen under its stroke, within that way; the others lead over
// gaps.
std::vector<Vector3> seenPointsOf(vtkPolyData* curve, vtkPolyData* projected, double way)
{
  std::vector<std::vector<Vector3>> runs;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < projected->GetNumberOfLines(); ++cell)
  {
    projected->GetLines()->GetCellAtId(cell, ids);
    runs.emplace_back();
    for (const vtkIdType id : *ids)
    {
      runs.back().emplace_back(projected->GetPoint(id));
    }
  }
  std::vector<Vector3> points = pointsOf(curve);
  const auto isFar = [&](const Vector3& p)
  {
    return std::none_of(runs.begin(), runs.end(), [&](const auto& run) { return toSegments(run, p) <= way; });
  };
  points.erase(std::remove_if(points.begin(), points.end(), isFar), points.end());
  return points;
}

// Of line and ring, each of which was drawn in one go.
void addOffStrokes(vtkOversketchEdit* edit,
  vtkPolyData* line,
  vtkPolyData* ring,
  double meanEdge,
  Json::Value& json)
{
  const auto splineOf = [&](int port, const char* stage) -> vtkPolyData*
  {
    auto* given = vtkPolyData::SafeDownCast(edit->GetInputDataObject(port, 0));
    vtkPolyData* spline = edit->GetInnerOutput(stage);
    return given->GetNumberOfLines() == 1 && spline->GetNumberOfPoints() > 0 ? spline : nullptr;
  };
  if (vtkPolyData* spline = splineOf(1, "ReferenceFit"))
  {
    json["off_stroke"] = offStroke(pointsOf(line), spline);
  }
  if (vtkPolyData* spline = splineOf(2, "BoundaryFit"))
  {
    const std::vector<Vector3> seen =
      seenPointsOf(ring, edit->GetInnerOutput("BoundaryProject"), 0.5 * meanEdge);
    json["ring_off_stroke"] = offStroke(seen, spline);
    json["ring_off_stroke"]["share_seen"] = number(edit->GetShareSeen());
  }
}

// How far the section of what the profile made is from the profile that was drawn, in mean edges.
Json::Value recut(vtkOversketchEdit* edit, vtkPolyData* bent, vtkPolyData* boundary, double meanEdge)
{
  vtkNew<vtkOversketchCrossSection> again;
  auto* step = vtkOversketchCrossSection::SafeDownCast(edit->GetStep("Section"));
  again->SetEnds(step->GetEnds());
  again->SetWalk(step->GetWalk());
  vtkNew<vtkPolyData> mesh, ring, planes;
  mesh->ShallowCopy(bent);
  ring->ShallowCopy(boundary);
  planes->ShallowCopy(edit->GetInnerOutput("Planes"));
  again->SetInputData(0, mesh);
  again->SetBoundaryData(ring);
  again->SetPlanesData(planes);
  again->Update();
  auto* drawn = vtkPolyData::SafeDownCast(edit->GetStep("Bend")->GetInputDataObject(3, 0));
  vtkDataArray* matrix = edit->GetInnerOutput("Section")->GetFieldData()->GetArray("ProfileMatrix");
  Json::Value json;
  if (again->GetErrorCode() != 0 || again->GetSectionOutput()->GetNumberOfPoints() == 0 || !matrix || !drawn)
  {
    return json;
  }
  Eigen::Matrix4d toWorld;
  for (int i = 0; i < 16; ++i)
  {
    toWorld(i / 4, i % 4) = matrix->GetComponent(0, i);
  }
  std::vector<Vector3> wanted;
  for (const Vector3& p : pointsOf(drawn))
  {
    wanted.emplace_back((toWorld * Vector3(p[0], p[1], 0.0).homogeneous()).head<3>());
  }
  double sum = 0.0, worst = 0.0;
  const std::vector<Vector3> cut = pointsOf(again->GetSectionOutput());
  for (const Vector3& p : cut)
  {
    const double away = toSegments(wanted, p) / meanEdge;
    sum += away;
    worst = std::max(worst, away);
  }
  json["mean"] = number(sum / static_cast<double>(cut.size()));
  json["worst"] = number(worst);
  return json;
}

} // namespace

void addEditFigures(vtkOversketchEdit* edit, Json::Value& json)
{
  json["bridges"] = edit->GetBridges();
  json["moved_points"] = edit->GetMovedPoints();
  json["folded_edges"] = edit->GetFoldedEdges();
  json["crossings"] = edit->GetCrossings();
  vtkPolyData* rest = edit->GetInnerOutput("Distance");
  const bool isProfile = edit->GetInnerOutput("Bend")->GetNumberOfPoints() > 0;
  vtkPolyData* moved = edit->GetInnerOutput(isProfile ? "Bend" : "Deform");
  vtkNew<vtkPolyData> line;
  edit->GetHold(line);
  auto* ring = vtkPolyData::SafeDownCast(edit->GetStep("Enclose")->GetInputDataObject(2, 0));
  const Region region(rest);
  const std::vector<int> lineChain = chainOf(line), ringChain = chainOf(ring);

  json["region"]["vertices"] = region.vertices;
  json["region"]["triangles"] = region.triangles;
  const std::set<int> curves = [&]
  {
    std::set<int> both(lineChain.begin(), lineChain.end());
    both.insert(ringChain.begin(), ringChain.end());
    return both;
  }();
  std::vector<double> atCurves;
  for (const Triangle& t : region.surface().triangles)
  {
    if (std::any_of(t.begin(), t.end(), [&](int v) { return curves.count(v) > 0; }))
    {
      atCurves.push_back(smallestAngle(region.surface(), t));
    }
  }
  json["curves"]["smallest_angle_percentile_5"] = number(ranked(atCurves, 0.05));
  const double meanEdge = rest->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0);
  addOffStrokes(edit, line, ring, meanEdge, json["curves"]);

  double step = 0.0;
  const std::vector<double> along = valuesOf(rest, "CurveParameter");
  for (std::size_t t = 0; t < region.inside.size(); ++t)
  {
    const Triangle& c = region.surface().triangles[t];
    for (std::size_t k = 0; region.inside[t] && k < 3; ++k)
    {
      step = std::max(step, std::abs(along[c[k]] - along[c[(k + 1) % 3]]));
    }
  }
  json["parameter_step"] = number(step);
  auto* disc = vtkPolyData::SafeDownCast(edit->GetStep("Flatten")->GetOutputDataObject(1));
  json["disc_flips"] = discFlips(disc);
  json["disc_area_ratio_95_5"] = number(discAreas(disc, region.surface()));
  json["plain_disc_area_ratio_95_5"] = number(plainDiscAreas(edit, line, region.surface()));
  vtkPolyData* weighted = edit->GetInnerOutput("Texture");
  weighted = weighted->GetNumberOfPoints() > 0 ? weighted : edit->GetInnerOutput("Shading");
  const std::vector<double> weights = valuesOf(weighted, "EditWeight");
  json["slope_jump"]["line"] = number(slopeJump(region, weights, lineChain));
  std::vector<int> closed = ringChain;
  closed.push_back(ringChain.front());
  json["slope_jump"]["ring"] = number(slopeJump(region, weights, closed));

  json["shape"]["rest"] = shapeOf(region);
  json["shape"]["moved"] = shapeOf(Region(moved));
  vtkPolyData* last = moved;
  std::vector<LaidCurve> laid{ { line, rest, false }, { ring, rest, true } };
  const bool isRemeshed = edit->GetRule() != vtkOversketchEdit::Off && edit->GetMovedPoints() > 0;
  if (isRemeshed)
  {
    last = edit->GetInnerOutput("Retriangulate");
    json["shape"]["retriangulated"] = shapeOf(Region(last));
    for (const int port : { 1, 2 })
    {
      auto* curve = vtkPolyData::SafeDownCast(edit->GetStep("Retriangulate")->GetOutputDataObject(port));
      laid.push_back({ curve, last, port == 2 });
    }
  }
  addChains(laid, json["curves"]);
  json["euler_number"]["before"] = eulerNumber(edit->GetInnerOutput("MeanEdge"));
  json["euler_number"]["after"] = eulerNumber(last);
  json["folded_share"] =
    number(edit->GetFoldedEdges() / std::max(1.0, static_cast<double>(Region(last).dihedrals().size())));
  if (isProfile)
  {
    json["recut"] = recut(edit, moved, ring, meanEdge);
  }
}

} // namespace oversketch_command
