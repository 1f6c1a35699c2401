// Regions with their frames and cross-sections, for tests. Header-only.
#ifndef oversketch_testing_harness_section_shapes_h
#define oversketch_testing_harness_section_shapes_h

#include "Harness/regions.h"
#include "Section/follow.h"
#include "Section/walk.h"

namespace oversketch_test
{

// A region with all that its profile asks for.
struct Profiled
{
  EditScene scene;
  Adjacency links;
  std::vector<Vector3> curve;
  CurveFrames frames;
  double plane;
  CurveFrame frame;
  Binding start;

  explicit Profiled(EditScene made, double t = 0.5)
    : scene(std::move(made))
    , links(buildAdjacency(this->scene.mesh))
    , curve(pick(this->scene.mesh.points, this->scene.reference))
    , frames(this->curve, pick(vertexNormals(this->scene.mesh), this->scene.reference))
    , plane(t)
    , frame(this->frames.at(t))
  {
    double length = 0.0, before = 0.0;
    for (std::size_t i = 1; i < this->curve.size(); ++i)
    {
      length += (this->curve[i] - this->curve[i - 1]).norm();
    }
    for (std::size_t i = 1; i < this->curve.size(); ++i)
    {
      const double step = (this->curve[i] - this->curve[i - 1]).norm();
      if (before + step >= t * length)
      {
        const double share = (t * length - before) / step;
        this->start = Binding::edge(this->scene.reference[i - 1], this->scene.reference[i], 1.0 - share);
        break;
      }
      before += step;
    }
  }

  static std::vector<Vector3> pick(const std::vector<Vector3>& values, const std::vector<int>& ids)
  {
    std::vector<Vector3> chosen;
    chosen.reserve(ids.size());
    for (const int id : ids)
    {
      chosen.push_back(values[id]);
    }
    return chosen;
  }

  Section section(const SectionRules& rules = {}) const { return this->section(this->scene.mesh, rules); }
  Section section(const Mesh& mesh, const SectionRules& rules = {}) const
  {
    return Sectioner(mesh, this->links, this->scene.boundary).at(this->frame, this->start, rules);
  }

  // Negative on the side of -1.
  FlatProfile flat(const Section& section) const
  {
    std::vector<double> beside;
    for (const Binding& place : section.places)
    {
      double value = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        value +=
          place.weights[k] * this->scene.side[place.vertices[k]] * this->scene.distance[place.vertices[k]];
      }
      beside.push_back(value);
    }
    return ProfileFit().flat(section.points, beside, section.normal, this->frame.outward);
  }

  RegionPlaces region() const
  {
    RegionPlaces places;
    for (int v = 0; v < this->scene.mesh.vertexCount(); ++v)
    {
      if (this->scene.region[v] == 2)
      {
        places.vertices.push_back(v);
        places.distance.push_back(this->scene.distance[v]);
        places.parameter.push_back(this->scene.parameter[v]);
        places.side.push_back(this->scene.side[v]);
      }
    }
    return places;
  }

  // One displacement of each vertex of the mesh.
  std::vector<Vector3> moves(const FlatProfile& profile,
    const ProfileChange& change,
    const std::vector<double>& handles = {},
    const Context& context = {}) const
  {
    const RegionPlaces places = this->region();
    const std::vector<double> shares =
      sideShares(this->scene.mesh.points, places, this->curve, this->frames, context);
    const std::vector<Vector3> moved = profileMoves(this->scene.mesh.points,
      places,
      shares,
      change,
      profile.toWorld,
      this->frame,
      this->frames,
      PlaneReach(this->plane, handles),
      {},
      context);
    std::vector<Vector3> all(this->scene.mesh.points.size(), Vector3::Zero());
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      all[places.vertices[i]] = moved[i];
    }
    return all;
  }

  Vector2 flatPoint(const FlatProfile& profile, const Vector3& point) const
  {
    return (profile.toWorld.inverse() * point.homogeneous()).head<2>();
  }
  ProfileChange change(const FlatProfile& profile, const Polyline& drawn) const
  {
    return { profile, this->flatPoint(profile, this->frame.origin), drawn, profile.t };
  }
};

inline Mesh movedBy(Mesh mesh, const std::vector<Vector3>& moves)
{
  for (std::size_t v = 0; v < moves.size(); ++v)
  {
    mesh.points[v] += moves[v];
  }
  return mesh;
}

} // namespace oversketch_test
#endif
