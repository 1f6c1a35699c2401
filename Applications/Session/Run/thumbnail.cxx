#include "thumbnail.h"

#include "Mesh/context.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace oversketch_session
{

namespace
{

using oversketch::Vector2;
using oversketch::Vector3;
using oversketch::View;
using Colour = std::array<float, 3>;

constexpr int fine = 2; // samples a pixel, each way
constexpr int columns = fine * Thumbnail::width, rows = fine * Thumbnail::height;
constexpr double margin = 0.06; // of the picture, on each side
constexpr Colour clay{ 196, 191, 183 }, orange{ 250, 150, 45 }, red{ 219, 33, 31 };
constexpr float ambient = 0.35F;
constexpr double lineRadius = 0.9;                // of the stroke [px]
constexpr vtkIdType often = vtkIdType{ 1 } << 16; // points or faces between two questions whether to go on

// Looking against z, at all of it.
View frontOf(vtkPolyData* mesh)
{
  double box[6];
  mesh->GetBounds(box);
  const double half = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4], 1e-30 });
  Eigen::Matrix4d world = Eigen::Matrix4d::Identity(), projection = Eigen::Matrix4d::Identity();
  world.col(3) << -0.5 * (box[0] + box[1]), -0.5 * (box[2] + box[3]), -0.5 * (box[4] + box[5]), 1.0;
  projection.diagonal() << 1.0 / half, 1.0 / half, -1.0 / half, 1.0;
  return { world, projection, columns, columns };
}

// The points of a mesh as a view shows them, and how bright the surface is there.
struct Seen
{
  std::vector<Vector3> places; // px of the view, and the depth, which grows towards the eye
  std::vector<float> light;
};

class Painter
{
public:
  explicit Painter(const std::function<bool()>& cancelled)
    : Cancelled(cancelled)
    , Colours(std::size_t(columns) * rows)
    , Depths(Colours.size(), -std::numeric_limits<float>::infinity())
  {
  }

  // False where the eye is within the mesh.
  bool see(const View& view, vtkPolyData* mesh, Seen& seen) const;
  // Puts what is seen and the stroke into the middle of the picture.
  void frame(const Seen& seen, const std::vector<Vector2>& stroke);
  void paint(vtkPolyData* mesh, const Seen& seen, const Colour& colour, float nearer);
  void paint(const std::vector<Vector2>& stroke);
  std::shared_ptr<const Thumbnail> picture() const;
  bool isStopped() const { return this->Stopped; }

private:
  bool stops() const { return this->Stopped = this->Stopped || (this->Cancelled && this->Cancelled()); }
  Vector2 inFrame(const Vector2& place) const { return this->Scale * (place - this->Low); }
  void triangle(const std::array<Vector3, 3>& corners,
    const std::array<float, 3>& light,
    const Colour& colour);

  const std::function<bool()>& Cancelled;
  mutable bool Stopped = false;
  Vector2 Low = Vector2::Zero(); // at the lower left corner of the picture
  double Scale = 1.0, DepthScale = 1.0, DepthLow = 0.0;
  struct Sample
  {
    Colour colour{};
    bool any = false;
  };
  std::vector<Sample> Colours; // rows from below
  std::vector<float> Depths;   // 0 to 1, the nearest is 1
};

bool Painter::see(const View& view, vtkPolyData* mesh, Seen& seen) const
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  seen.places.resize(static_cast<std::size_t>(count));
  std::vector<Vector3> world(seen.places.size()), normals(seen.places.size(), Vector3::Zero());
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (i % often == 0 && this->stops())
    {
      return true;
    }
    const auto at = static_cast<std::size_t>(i);
    mesh->GetPoint(i, world[at].data());
    if (!view.inFront(world[at]))
    {
      return false;
    }
    seen.places[at] = view.toScreen(world[at]);
  }
  auto faces = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  vtkIdType number = 0;
  for (faces->GoToFirstCell(); !faces->IsDoneWithTraversal(); faces->GoToNextCell(), ++number)
  {
    if (number % often == 0 && this->stops())
    {
      return true;
    }
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    faces->GetCurrentCell(corners, ids);
    for (vtkIdType k = 2; k < corners; ++k)
    {
      const auto a = static_cast<std::size_t>(ids[0]), b = static_cast<std::size_t>(ids[k - 1]),
                 c = static_cast<std::size_t>(ids[k]);
      const Vector3 normal = (world[b] - world[a]).cross(world[c] - world[a]);
      for (const std::size_t corner : { a, b, c })
      {
        normals[corner] += normal;
      }
    }
  }
  // A lamp at the eye, a little above and to the left.
  const Eigen::Matrix3d turned = view.viewTransform().topLeftCorner<3, 3>();
  const Vector3 lamp = (turned.transpose() * Vector3(-0.35, 0.45, 1.0)).normalized();
  seen.light.resize(seen.places.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const double length = normals[i].norm();
    const double cosine = length > 0.0 ? std::max(0.0, normals[i].dot(lamp) / length) : 0.0;
    seen.light[i] = ambient + (1.0F - ambient) * static_cast<float>(cosine);
  }
  return true;
}

void Painter::frame(const Seen& seen, const std::vector<Vector2>& stroke)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& place : seen.places)
  {
    box.extend(place);
  }
  Eigen::AlignedBox2d flat(box.min().head<2>(), box.max().head<2>());
  for (const Vector2& place : stroke)
  {
    flat.extend(place);
  }
  const Vector2 size = flat.sizes().cwiseMax(1e-9);
  this->Scale = (1.0 - 2.0 * margin) * std::min(columns / size[0], rows / size[1]);
  this->Low = flat.center() - Vector2(columns, rows) / (2.0 * this->Scale);
  this->DepthLow = box.min()[2];
  this->DepthScale = 1.0 / std::max(box.sizes()[2], 1e-300);
}

void Painter::triangle(const std::array<Vector3, 3>& corners,
  const std::array<float, 3>& light,
  const Colour& colour)
{
  const Vector2 a = corners[0].head<2>(), ab = corners[1].head<2>() - a, ac = corners[2].head<2>() - a;
  const double area = ab[0] * ac[1] - ab[1] * ac[0];
  if (area == 0.0)
  {
    return;
  }
  const auto [lowX, highX] = std::minmax({ corners[0][0], corners[1][0], corners[2][0] });
  const auto [lowY, highY] = std::minmax({ corners[0][1], corners[1][1], corners[2][1] });
  const int left = std::max(0, static_cast<int>(std::ceil(lowX - 0.5))),
            right = std::min(columns - 1, static_cast<int>(std::floor(highX - 0.5))),
            bottom = std::max(0, static_cast<int>(std::ceil(lowY - 0.5))),
            top = std::min(rows - 1, static_cast<int>(std::floor(highY - 0.5)));
  for (int y = bottom; y <= top; ++y)
  {
    for (int x = left; x <= right; ++x)
    {
      const Vector2 at = Vector2(x + 0.5, y + 0.5) - a;
      const double u = (at[0] * ac[1] - at[1] * ac[0]) / area, v = (ab[0] * at[1] - ab[1] * at[0]) / area;
      if (u < 0.0 || v < 0.0 || u + v > 1.0)
      {
        continue;
      }
      const double w = 1.0 - u - v;
      const auto depth = static_cast<float>(w * corners[0][2] + u * corners[1][2] + v * corners[2][2]);
      const std::size_t place = std::size_t(y) * columns + std::size_t(x);
      if (depth > this->Depths[place])
      {
        this->Depths[place] = depth;
        const auto bright = static_cast<float>(w * light[0] + u * light[1] + v * light[2]);
        this->Colours[place] = { { bright * colour[0], bright * colour[1], bright * colour[2] }, true };
      }
    }
  }
}

void Painter::paint(vtkPolyData* mesh, const Seen& seen, const Colour& colour, float nearer)
{
  auto faces = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  vtkIdType number = 0;
  for (faces->GoToFirstCell(); !faces->IsDoneWithTraversal(); faces->GoToNextCell(), ++number)
  {
    if (number % often == 0 && this->stops())
    {
      return;
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    faces->GetCurrentCell(count, ids);
    const auto corner = [&](vtkIdType id) -> Vector3
    {
      const Vector3& place = seen.places[static_cast<std::size_t>(id)];
      const Vector2 flat = this->inFrame(place.head<2>());
      return { flat[0], flat[1], this->DepthScale * (place[2] - this->DepthLow) + nearer };
    };
    const auto light = [&](vtkIdType id) { return seen.light[static_cast<std::size_t>(id)]; };
    for (vtkIdType k = 2; k < count; ++k)
    {
      this->triangle({ corner(ids[0]), corner(ids[k - 1]), corner(ids[k]) },
        { light(ids[0]), light(ids[k - 1]), light(ids[k]) },
        colour);
    }
  }
}

// Over all else.
void Painter::paint(const std::vector<Vector2>& stroke)
{
  const double radius = lineRadius * fine;
  for (std::size_t i = 1; i < stroke.size(); ++i)
  {
    const Vector2 from = this->inFrame(stroke[i - 1]), step = this->inFrame(stroke[i]) - from;
    const int dots = std::clamp(static_cast<int>(std::ceil(step.norm())), 1, 2 * columns);
    for (int dot = 0; dot <= dots; ++dot)
    {
      const Vector2 at = from + step * (double(dot) / dots);
      for (int y = static_cast<int>(at[1] - radius); y <= static_cast<int>(at[1] + radius); ++y)
      {
        for (int x = static_cast<int>(at[0] - radius); x <= static_cast<int>(at[0] + radius); ++x)
        {
          if (x >= 0 && x < columns && y >= 0 && y < rows && (Vector2(x, y) - at).norm() <= radius)
          {
            this->Colours[std::size_t(y) * columns + std::size_t(x)] = { red, true };
          }
        }
      }
    }
  }
}

std::shared_ptr<const Thumbnail> Painter::picture() const
{
  auto made = std::make_shared<Thumbnail>();
  made->pixels.reserve(std::size_t(4) * Thumbnail::width * Thumbnail::height);
  for (int row = Thumbnail::height - 1; row >= 0; --row)
  {
    for (int column = 0; column < Thumbnail::width; ++column)
    {
      Colour sum{};
      int any = 0;
      for (int k = 0; k < fine * fine; ++k)
      {
        const int y = fine * row + k / fine, x = fine * column + k % fine;
        const Sample& sample = this->Colours[std::size_t(y) * columns + std::size_t(x)];
        any += sample.any;
        for (std::size_t c = 0; c < 3; ++c)
        {
          sum[c] += sample.any ? sample.colour[c] : 0.0F;
        }
      }
      for (const float channel : sum)
      {
        made->pixels.push_back(any ? static_cast<std::uint8_t>(std::lround(channel / static_cast<float>(any)))
                                   : std::uint8_t{ 0 });
      }
      made->pixels.push_back(static_cast<std::uint8_t>(255 * any / (fine * fine)));
    }
  }
  return made;
}

std::optional<View> viewOf(vtkPolyData* stroke)
{
  if (!stroke || stroke->GetNumberOfPoints() == 0)
  {
    return std::nullopt;
  }
  try
  {
    return oversketch::ViewOf(stroke);
  }
  catch (const oversketch::Error&)
  {
    return std::nullopt; // lines of several views
  }
}

} // namespace

std::shared_ptr<const Thumbnail> thumbnailOf(vtkPolyData* mesh,
  vtkPolyData* moved,
  vtkPolyData* stroke,
  const std::function<bool()>& cancelled)
{
  Painter painter(cancelled);
  Seen whole, part;
  std::vector<std::vector<Vector2>> lines;
  const std::optional<View> drawn = viewOf(stroke);
  const bool asDrawn = drawn && painter.see(*drawn, mesh, whole);
  const View view = asDrawn ? *drawn : frontOf(mesh);
  if (!asDrawn)
  {
    painter.see(view, mesh, whole);
  }
  std::vector<Vector2> all;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; asDrawn && i < stroke->GetNumberOfLines(); ++i)
  {
    stroke->GetLines()->GetCellAtId(i, ids);
    lines.emplace_back();
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const double* at = stroke->GetPoint(ids->GetId(k));
      lines.back().emplace_back(at[0], at[1]);
      all.push_back(lines.back().back());
    }
  }
  const bool isPart =
    !painter.isStopped() && moved && moved->GetNumberOfPoints() > 0 && painter.see(view, moved, part);
  if (painter.isStopped())
  {
    return nullptr;
  }
  painter.frame(whole, all);
  painter.paint(mesh, whole, clay, 0.0F);
  if (isPart)
  {
    painter.paint(moved, part, orange, 0.004F); // over the surface that it is a part of
  }
  for (const std::vector<Vector2>& line : lines)
  {
    painter.paint(line);
  }
  return painter.isStopped() ? nullptr : painter.picture();
}

} // namespace oversketch_session
