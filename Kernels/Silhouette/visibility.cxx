#include "Silhouette/visibility.h"

#include "Silhouette/occlusion.h"
#include "Stroke/meetings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

constexpr double samePlace = 1e-9; // of a segment: a crossing this near to its end is its end

// A curve on its way through the steps: its points on screen, and where it is to be cut.
struct Track
{
  Curve curve;
  std::vector<Vector3> screen; // depth minus infinity: no place on screen
  std::vector<char> cut;

  int size() const { return static_cast<int>(this->curve.points.size()); }
  int segmentCount() const { return this->size() - (this->curve.closed ? 0 : 1); }
  int after(int i) const { return i + 1 < this->size() ? i + 1 : 0; }
  bool onScreen(int i) const { return std::isfinite(this->screen[i][2]); }
};

// The part of a track from point `from`, `count` points on, round the end of a closed curve where need be.
struct Piece
{
  int from, count;
  bool whole; // a closed curve without a cut
  bool visible = false;
};

class Visibility
{
public:
  Visibility(const Mesh& surface,
    const std::vector<Vector3>& vertexNormals,
    const View& eye,
    const VisibilityOptions& settings,
    const Context& caller)
    : Model(surface)
    , Normals(vertexNormals)
    , Camera(eye)
    , Options(settings)
    , Caller(caller)
  {
  }

  VisibilityResult run(const std::vector<Curve>& curves)
  {
    this->Caller.checkpoint(0.0);
    this->Nearest = -1e-6 * boundingDiagonal(this->Model);
    for (const Curve& curve : curves)
    {
      this->Tracks.push_back(this->trackOf(curve));
      this->markCuspsAndEyePlane(this->Tracks.back());
    }
    this->insertCrossings();
    this->Caller.checkpoint(0.3);
    std::vector<std::vector<Piece>> pieces;
    for (const Track& track : this->Tracks)
    {
      pieces.push_back(piecesOf(track));
    }
    VisibilityResult result;
    this->vote(pieces, result);
    for (int i = 0; i < static_cast<int>(this->Tracks.size()); ++i)
    {
      this->emit(i, pieces[i], result.segments);
    }
    this->Caller.checkpoint(1.0);
    return result;
  }

private:
  Vector3 screenOf(const Vector3& position) const
  {
    const bool off = this->Camera.perspective() && !(this->Camera.depth(position) < this->Nearest);
    return off ? Vector3(0.0, 0.0, -std::numeric_limits<double>::infinity())
               : this->Camera.toScreen(position);
  }

  Track trackOf(const Curve& curve) const
  {
    Track track{ curve, {}, std::vector<char>(curve.points.size(), 0) };
    for (const CurvePoint& p : curve.points)
    {
      track.screen.push_back(this->screenOf(p.position));
    }
    return track;
  }

  void markCuspsAndEyePlane(Track& track) const
  {
    const double limit = std::cos(this->Options.cuspAngle * M_PI / 180.0);
    const int n = track.size();
    for (int i = 0; i < n; ++i)
    {
      if (!track.onScreen(i) || (!track.curve.closed && (i == 0 || i == n - 1)))
      {
        continue;
      }
      const int beside[2] = { (i + n - 1) % n, (i + 1) % n };
      Vector2 arms[2];
      bool measured = true;
      for (int k = 0; k < 2 && measured; ++k)
      {
        if (!track.onScreen(beside[k]))
        {
          track.cut[i] = 1;
          measured = false;
          break;
        }
        // Neighbours in the same place of the picture tell no direction: the next ones do.
        const int step = k == 0 ? n - 1 : 1;
        int other = beside[k];
        for (int steps = 1; steps < n; ++steps, other = (other + step) % n)
        {
          arms[k] = (track.screen[other] - track.screen[i]).head<2>();
          measured = track.onScreen(other) && arms[k].squaredNorm() > 0.0;
          if (measured || !track.onScreen(other) || (!track.curve.closed && (other == 0 || other == n - 1)))
          {
            break;
          }
        }
      }
      if (measured && arms[0].dot(arms[1]) > limit * arms[0].norm() * arms[1].norm())
      {
        track.cut[i] = 1;
      }
    }
  }

  // The point of a segment at a share of its length on screen.
  CurvePoint between(const Track& track, int first, int second, double place) const
  {
    const double q0 = track.screen[first][2], q1 = track.screen[second][2];
    // Depth is -1/z in perspective, and affine on screen; along the segment in space z is.
    const double share = this->Camera.perspective() ? place * q1 / (q0 + place * (q1 - q0)) : place;
    const Binding& a = track.curve.points[first].binding;
    const Binding& b = track.curve.points[second].binding;
    int vertices[6];
    double weights[6];
    int count = 0;
    for (const Binding* binding : { &a, &b })
    {
      const double factor = binding == &a ? 1.0 - share : share;
      for (int k = 0; k < 3; ++k)
      {
        const int slot =
          static_cast<int>(std::find(vertices, vertices + count, binding->vertices[k]) - vertices);
        if (slot == count)
        {
          vertices[count] = binding->vertices[k];
          weights[count++] = 0.0;
        }
        weights[slot] += factor * binding->weights[k];
      }
    }
    if (count > 3)
    {
      throw Error(Failure::BadMesh,
        "Two consecutive curve points share no triangle of the mesh (vertices %1 to %2); give the curves as "
        "the silhouette or snake filter made them.",
        vertices[0],
        vertices[count - 1]);
    }
    CurvePoint p;
    for (int k = 0; k < 3; ++k)
    {
      p.binding.vertices[k] = k < count ? vertices[k] : vertices[0];
      p.binding.weights[k] = k < count ? weights[k] : 0.0;
    }
    p.position = p.binding.of(this->Model.points);
    p.normal = p.binding.of(this->Normals).normalized();
    return p;
  }

  void insertCrossings()
  {
    std::vector<ImageSegment> segments;
    for (int c = 0; c < static_cast<int>(this->Tracks.size()); ++c)
    {
      const Track& track = this->Tracks[c];
      for (int i = 0; i < track.segmentCount(); ++i)
      {
        const int j = track.after(i);
        if (track.onScreen(i) && track.onScreen(j))
        {
          segments.push_back({ c, i, j, track.screen[i].head<2>(), track.screen[j].head<2>() });
          if (!segments.back().from.allFinite() || !segments.back().to.allFinite())
          {
            throw Error(Failure::BadStroke,
              "A curve of the outline has no place in the picture: it passes through the plane of the "
              "camera, or the mesh or the view is damaged. Draw the stroke in a view from farther away.");
          }
        }
      }
    }
    const std::vector<Crossing> crossings = findCrossings(segments, this->Caller);
    auto crossing = crossings.begin();
    for (int c = 0; c < static_cast<int>(this->Tracks.size()); ++c)
    {
      const Track& old = this->Tracks[c];
      Track track{ {}, {}, {} };
      track.curve.closed = old.curve.closed;
      const auto add = [&](const CurvePoint& p, const Vector3& screen, char cut)
      {
        track.curve.points.push_back(p);
        track.screen.push_back(screen);
        track.cut.push_back(cut);
      };
      std::vector<char> cuts = old.cut;
      for (int i = 0; i < old.size(); ++i)
      {
        const std::size_t here = track.cut.size();
        add(old.curve.points[i], old.screen[i], cuts[i]);
        double last = 0.0;
        for (; crossing != crossings.end() && segments[crossing->segment].curve == c &&
               segments[crossing->segment].first == i;
             ++crossing)
        {
          const int next = segments[crossing->segment].second;
          if (crossing->place < samePlace)
          {
            track.cut[here] = 1;
          }
          else if (crossing->place > 1.0 - samePlace)
          {
            cuts[next] = 1;
          }
          else if (crossing->place > last + samePlace)
          {
            const CurvePoint p = this->between(old, i, next, crossing->place);
            add(p, this->screenOf(p.position), 1);
            last = crossing->place;
          }
        }
      }
      if (!cuts.empty())
      {
        track.cut[0] |= cuts[0];
      }
      this->Tracks[c] = std::move(track);
    }
  }

  static std::vector<Piece> piecesOf(const Track& track)
  {
    const int n = track.size();
    std::vector<int> ends;
    for (int i = 0; i < n; ++i)
    {
      if (track.cut[i] || (!track.curve.closed && (i == 0 || i == n - 1)))
      {
        ends.push_back(i);
      }
    }
    std::vector<Piece> pieces;
    if (ends.empty() || n < 2)
    {
      pieces.push_back({ 0, n, true });
      return pieces;
    }
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    {
      pieces.push_back({ ends[k], ends[k + 1] - ends[k] + 1, false });
    }
    if (track.curve.closed)
    {
      pieces.push_back({ ends.back(), n - ends.back() + ends.front() + 1, false });
    }
    return pieces;
  }

  void vote(std::vector<std::vector<Piece>>& pieces, VisibilityResult& result) const
  {
    std::vector<OcclusionQuery> queries;
    std::vector<Piece*> voters;
    for (std::size_t c = 0; c < pieces.size(); ++c)
    {
      const Track& track = this->Tracks[c];
      for (Piece& piece : pieces[c])
      {
        bool asked = false;
        const auto ask = [&](const Vector3& screen, const std::array<int, 3>& vertices)
        {
          asked = true;
          if (std::isfinite(screen[2]))
          {
            queries.push_back({ screen, vertices });
            voters.push_back(&piece);
          }
        };
        for (int k = 0; k < piece.count; ++k)
        {
          const int i = (piece.from + k) % track.size();
          if (!track.cut[i])
          {
            ask(track.screen[i], track.curve.points[i].binding.vertices);
          }
        }
        for (int k = 0; k + 1 < piece.count && !asked; ++k)
        {
          const int i = (piece.from + k) % track.size(), j = (piece.from + k + 1) % track.size();
          if (track.onScreen(i) && track.onScreen(j))
          {
            const CurvePoint p = this->between(track, i, j, 0.5);
            queries.push_back({ this->screenOf(p.position), p.binding.vertices });
            voters.push_back(&piece);
          }
        }
      }
    }
    const std::vector<char> hidden = this->test(queries, result);
    for (std::size_t q = 0; q < queries.size(); ++q)
    {
      voters[q]->visible = voters[q]->visible || !hidden[q];
    }
  }

  std::vector<char> test(const std::vector<OcclusionQuery>& queries, VisibilityResult& result) const
  {
    const std::vector<Vector3> screen = projectVertices(this->Model, this->Camera, this->Caller);
    if (const std::shared_ptr<Device> device = Device::choose(this->Options.backend, result.warning))
    {
      try
      {
        std::vector<char> hidden = device->info().fp64
                                     ? occludedOnDevice<double>(*device, this->Model, screen, queries)
                                     : occludedOnDevice<float>(*device, this->Model, screen, queries);
        result.used = Backend::OpenCL;
        return hidden;
      }
      catch (const Error& error)
      {
        result.warning = { "%1 The host tests visibility instead.", error.message() };
      }
    }
    result.used = Backend::Host;
    return occludedOnHost<double>(this->Model, screen, queries, this->Caller);
  }

  // One segment per piece, or per run of visible neighbours.
  void emit(int source, const std::vector<Piece>& pieces, std::vector<VisibilitySegment>& segments) const
  {
    const Track& track = this->Tracks[source];
    const int count = static_cast<int>(pieces.size());
    const bool rejoin = this->Options.rejoin;
    const bool allVisible =
      std::all_of(pieces.begin(), pieces.end(), [](const Piece& p) { return p.visible; });
    if (pieces[0].whole || (track.curve.closed && rejoin && allVisible))
    {
      segments.push_back({ track.curve, source, pieces[0].visible });
      return;
    }
    // A run may go on over the end of a closed curve: begin behind a hidden piece.
    int start = 0;
    while (track.curve.closed && rejoin && start < count && pieces[(start + count - 1) % count].visible)
    {
      ++start;
    }
    for (int k = 0; k < count; ++k)
    {
      const Piece& piece = pieces[(start + k) % count];
      const bool join = rejoin && k > 0 && piece.visible && segments.back().visible;
      if (!join)
      {
        segments.push_back({ Curve(), source, piece.visible });
      }
      for (int i = join ? 1 : 0; i < piece.count; ++i)
      {
        segments.back().curve.points.push_back(track.curve.points[(piece.from + i) % track.size()]);
      }
    }
  }

  const Mesh& Model;
  const std::vector<Vector3>& Normals;
  const View& Camera;
  const VisibilityOptions& Options;
  const Context& Caller;
  double Nearest = 0.0;
  std::vector<Track> Tracks;
};

} // namespace

VisibilityResult findVisible(const std::vector<Curve>& curves,
  const Mesh& mesh,
  const std::vector<Vector3>& normals,
  const View& view,
  const VisibilityOptions& options,
  const Context& context)
{
  return Visibility(mesh, normals, view, options, context).run(curves);
}

} // namespace oversketch
