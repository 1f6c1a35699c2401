#include "vtkOversketchEditMotion.h"

#include "Matrix/moved.h"
#include "vtkOversketchEditTools.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <memory>
#include <numeric>
#include <string>

namespace oversketch
{

namespace
{

Matrix4 LogOf(const Matrix4& matrix, std::size_t handle)
{
  try
  {
    return logarithm(matrix);
  }
  catch (const Error& error)
  {
    throw Error(error.failure(), "Handle %1: %2", handle, error.message());
  }
}

const char* const profileRemedy = "take it from vtkOversketchCrossSection";
const char* const drawnRemedy = "draw the profile anew with vtkOversketchResketch";

// The points of the one polyline, and an array of them.
struct Line
{
  Polyline Points;
  std::vector<vtkIdType> Ids;

  Line(vtkPolyData* data, const std::string& holder)
  {
    if (data->GetNumberOfLines() != 1 || data->GetNumberOfCells() != 1)
    {
      throw Error(Failure::BadStroke,
        "The %1 input holds %2 polylines and %3 other cells; exactly one polyline is needed.",
        holder,
        data->GetNumberOfLines(),
        data->GetNumberOfCells() - data->GetNumberOfLines());
    }
    vtkNew<vtkIdList> ids;
    data->GetLines()->GetCellAtId(0, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      if (id < 0 || id >= data->GetNumberOfPoints())
      {
        throw Error(Failure::BadStroke, "Point %1 of the %2 does not exist; draw it anew.", i, holder);
      }
      Vector3 point;
      data->GetPoint(id, point.data());
      this->Points.emplace_back(point[0], point[1]);
      this->Ids.push_back(id);
    }
  }

  std::vector<double> Values(vtkPolyData* data,
    const char* name,
    const std::string& holder,
    const std::string& remedy) const
  {
    vtkDataArray* array =
      RequireArray(data->GetPointData(), name, 1, data->GetNumberOfPoints(), holder, remedy);
    return mapped(this->Ids, [array](vtkIdType id) { return array->GetComponent(id, 0); });
  }
};

FlatProfile ProfileOf(vtkPolyData* data)
{
  const std::string holder = "profile";
  const Line line(data, holder);
  FlatProfile profile;
  profile.points = line.Points;
  profile.t = line.Values(data, "CurveT", holder, profileRemedy);
  profile.beside = line.Values(data, "SideDistance", holder, profileRemedy);
  profile.toWorld = ReadMatrix(data->GetFieldData(), "ProfileMatrix", holder, profileRemedy);
  for (std::size_t i = 0; i < profile.points.size(); ++i)
  {
    const bool ordered = i == 0 ? profile.t[i] == 0.0 : profile.t[i] > profile.t[i - 1];
    if (!profile.points[i].allFinite() || !ordered || !(profile.t[i] <= 1.0) ||
        !(std::abs(profile.beside[i]) <= 1.0 + 1e-6))
    {
      throw Error(Failure::BadStroke,
        "Point %1 of the profile is not finite, or its CurveT or SideDistance is none: %2.",
        i,
        profileRemedy);
    }
  }
  const Eigen::Matrix3d linear = profile.toWorld.topLeftCorner<3, 3>();
  if (profile.points.size() < 2 || !(std::abs(linear.determinant()) > 0.0))
  {
    throw Error(Failure::BadStroke,
      "The profile has fewer than two points, or its ProfileMatrix is singular: %1.",
      profileRemedy);
  }
  return profile;
}

// Values of every vertex; zero where EditRegion is not 2, the share of the way 1.
struct VertexValues
{
  std::vector<double> Share, Parameter, Weight;
  std::vector<int> Inside;

  explicit VertexValues(vtkPolyData* mesh)
    : Share(static_cast<std::size_t>(mesh->GetNumberOfPoints()), 1.0)
    , Parameter(this->Share.size(), 0.0)
    , Weight(this->Share.size(), 0.0)
    , Inside(ReadInside(mesh))
  {
    // Places beside the boundary are between its vertices and others, and along the curve as both.
    std::vector<int> all(this->Share.size());
    std::iota(all.begin(), all.end(), 0);
    this->Parameter = ReadValues(mesh, "CurveParameter", all);
    const std::vector<double> share = ReadValues(mesh, "CurveDistance", this->Inside);
    const std::vector<double> weight = ReadValues(mesh, "EditWeight", this->Inside);
    for (std::size_t i = 0; i < this->Inside.size(); ++i)
    {
      this->Share[this->Inside[i]] = share[i];
      this->Weight[this->Inside[i]] = weight[i];
    }
  }

  // Difference of a weight from that of its share.
  double Rest(std::size_t vertex, const WeightOfShare& weight) const
  {
    return this->Weight[vertex] - (weight ? weight(this->Share[vertex]) : 0.0);
  }
};

double WeightAt(double share, double rest, const WeightOfShare& weight)
{
  return std::clamp((weight ? weight(share) : 0.0) + rest, 0.0, 1.0);
}

} // namespace

Pulls PullsOf(vtkPolyData* handles)
{
  const std::vector<double> places = ReadHandlePlaces(handles);
  const std::vector<Matrix4> matrices = ReadHandleMatrices(handles);
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  Pulls pulls;
  for (const std::size_t i : order)
  {
    const Matrix4 log = LogOf(matrices[i], i);
    if (pulls.Places.empty() || pulls.Places.back() != places[i])
    {
      pulls.Places.push_back(places[i]);
      pulls.Logs.push_back(log);
    }
    else
    {
      pulls.Logs.back() += log;
    }
  }
  return pulls;
}

DrawnChange ReadChange(vtkPolyData* profile, vtkPolyData* drawn, const std::vector<double>& handles)
{
  FlatProfile old = ProfileOf(profile);
  const CurveFrame plane = FrameOf(ReadMatrix(profile->GetFieldData(), "Frame", "profile", profileRemedy));
  vtkDataArray* where = profile->GetFieldData()->GetArray("PlaneT");
  if (!where || where->GetNumberOfTuples() != 1)
  {
    throw Error(
      Failure::MissingArray, std::string("The profile has no field array PlaneT: ") + profileRemedy + ".");
  }
  const Line fresh(drawn, "new profile");
  const Vector2 middle = (old.toWorld.inverse() * plane.origin.homogeneous()).head<2>();
  ProfileChange change(old, middle, fresh.Points, fresh.Values(drawn, "SourceT", "new profile", drawnRemedy));
  return { std::move(old), plane, std::move(change), PlaneReach(where->GetComponent(0, 0), handles) };
}

Motion MotionOfHandles(vtkPolyData* mesh, vtkPolyData* handles, const WeightOfShare& weight)
{
  const VertexValues read(mesh);
  Motion motion;
  motion.channels = 3;
  for (std::size_t v = 0; v < read.Share.size(); ++v)
  {
    motion.values.insert(motion.values.end(), { read.Share[v], read.Parameter[v], read.Rest(v, weight) });
  }
  motion.movement = [pulls = PullsOf(handles), weight](
                      const std::vector<Vector3>& points, const std::vector<double>& values)
  {
    std::vector<double> shares;
    shares.reserve(points.size() * pulls.Places.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double* at = values.data() + 3 * i;
      const double own = WeightAt(at[0], at[2], weight);
      for (const double part : tents(pulls.Places, at[1]))
      {
        shares.push_back(own * part);
      }
    }
    return moved(points, pulls.Logs, shares, ThreadsOnly());
  };
  return motion;
}

Motion MotionOfProfile(vtkPolyData* mesh,
  vtkPolyData* reference,
  vtkPolyData* profile,
  vtkPolyData* drawn,
  vtkPolyData* handles,
  bool useTexture,
  const WeightOfShare& weight)
{
  const VertexValues read(mesh);
  const auto shared = SharedMesh(mesh);
  const auto curve = std::make_shared<const CurveOnMesh>(reference, *shared);
  RegionPlaces region;
  region.vertices = read.Inside;
  region.side = ReadValues(mesh, "CurveSide", read.Inside, -1.0);
  const std::vector<double> inside =
    sideShares(shared->Surface().points, region, curve->Points, curve->Frames, ThreadsOnly());
  std::vector<double> sides(read.Share.size(), 0.5);
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    sides[read.Inside[i]] = inside[i];
  }
  const auto change = std::make_shared<const DrawnChange>(
    ReadChange(profile, drawn, handles ? ReadHandlePlaces(handles) : std::vector<double>()));
  Motion motion;
  motion.channels = 4;
  for (std::size_t v = 0; v < read.Share.size(); ++v)
  {
    motion.values.insert(
      motion.values.end(), { read.Share[v], read.Parameter[v], sides[v], read.Rest(v, weight) });
  }
  motion.movement = [curve, change, useTexture, weight](
                      const std::vector<Vector3>& points, const std::vector<double>& values)
  {
    RegionPlaces places;
    std::vector<double> shares, weights;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double* at = values.data() + 4 * i;
      places.vertices.push_back(static_cast<int>(i));
      places.distance.push_back(at[0]);
      places.parameter.push_back(at[1]);
      shares.push_back(at[2]);
      if (useTexture)
      {
        weights.push_back(WeightAt(at[0], at[3], weight));
      }
    }
    std::vector<Vector3> result = profileMoves(points,
      places,
      shares,
      change->Change,
      change->Old.toWorld,
      change->Plane,
      curve->Frames,
      change->Reach,
      weights,
      ThreadsOnly());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      result[i] += points[i];
    }
    return result;
  };
  return motion;
}

} // namespace oversketch
