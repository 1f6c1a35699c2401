#include "Image/heights.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr long long mostQuads = 8000000; // sixteen million triangles

int quadsBeside(int others, double length, double othersLength)
{
  return static_cast<int>(std::clamp(std::round(others * length / othersLength), 1.0, 1.0 * mostQuads));
}

// What does not count may be missing, and what is equal stays so.
double between(double a, double b, double share)
{
  return share <= 0.0 ? a : share >= 1.0 ? b : a + share * (b - a);
}

// The height at a missing sample, by those up to three away.
double filledSample(const HeightImage& image, int column, int row)
{
  constexpr int reach = 3;
  double first = 0.0, weights = 0.0, mean = 0.0; // heights count from the first one
  Vector2 middle(0.0, 0.0);
  struct Known
  {
    Vector2 away;
    double height, weight;
  };
  std::array<Known, (2 * reach + 1) * (2 * reach + 1)> known;
  std::size_t count = 0;
  for (int j = std::max(row - reach, 0); j <= std::min(row + reach, image.height - 1); ++j)
  {
    for (int i = std::max(column - reach, 0); i <= std::min(column + reach, image.width - 1); ++i)
    {
      const double height = image.samples[static_cast<std::size_t>(j) * image.width + i];
      if (std::isfinite(height))
      {
        first = count == 0 ? height : first;
        const Vector2 away(i - column, j - row);
        known[count++] = { away, height - first, 1.0 / away.squaredNorm() };
        weights += known[count - 1].weight;
        middle += known[count - 1].weight * away;
        mean += known[count - 1].weight * known[count - 1].height;
      }
    }
  }
  middle /= weights;
  mean /= weights;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Vector2 rise(0.0, 0.0);
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vector2 away = known[k].away - middle;
    spread += known[k].weight * away * away.transpose();
    rise += known[k].weight * (known[k].height - mean) * away;
  }
  // Samples on one line tell the slope along it alone.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  double height = mean;
  for (int k = 0; k < 2; ++k)
  {
    if (axes.eigenvalues()[k] > 1e-9 * weights)
    {
      const Vector2 axis = axes.eigenvectors().col(k);
      height -= axis.dot(middle) * axis.dot(rise) / axes.eigenvalues()[k];
    }
  }
  return first + height;
}

} // namespace

FilledSamples fillNarrowGaps(HeightImage& image, const Context& context)
{
  const auto rows = [&](const auto& work) // of each sample
  {
    context.eachUntilCancelled(image.height,
      [&](int j)
      {
        for (int i = 0; i < image.width; ++i)
        {
          work(i, j, static_cast<std::size_t>(j) * image.width + i);
        }
      });
  };
  // Whether that is so of each of the nine samples round one.
  const auto allRound = [&](int i, int j, const auto& is)
  {
    bool all = i > 0 && j > 0 && i + 1 < image.width && j + 1 < image.height;
    for (int k = 0; k < 9 && all; ++k)
    {
      all = is(static_cast<std::size_t>(j + k / 3 - 1) * image.width + (i + k % 3 - 1));
    }
    return all;
  };
  std::vector<char> middles(image.samples.size()); // of blocks
  rows([&](int i, int j, std::size_t at)
    { middles[at] = allRound(i, j, [&](std::size_t k) { return !std::isfinite(image.samples[k]); }); });
  std::vector<double> filled = image.samples;
  std::atomic<std::size_t> count{ 0 }, left{ 0 };
  rows(
    [&](int i, int j, std::size_t at)
    {
      if (std::isfinite(image.samples[at]))
      {
        return;
      }
      bool inBlock = false;
      for (int v = std::max(j - 1, 0); v <= std::min(j + 1, image.height - 1); ++v)
      {
        for (int u = std::max(i - 1, 0); u <= std::min(i + 1, image.width - 1); ++u)
        {
          inBlock = inBlock || middles[static_cast<std::size_t>(v) * image.width + u];
        }
      }
      filled[at] = inBlock ? image.samples[at] : filledSample(image, i, j);
      ++(std::isfinite(filled[at]) ? count : left);
    });
  context.checkpoint(0.1);
  image.samples = std::move(filled);
  return { count, left };
}

double HeightImage::at(double column, double row) const
{
  if (std::isnan(column) || std::isnan(row))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double x = std::clamp(column, 0.0, this->width - 1.0);
  const double y = std::clamp(row, 0.0, this->height - 1.0);
  const int i = std::min(static_cast<int>(x), this->width - 2);
  const int j = std::min(static_cast<int>(y), this->height - 2);
  const double* lower = this->samples.data() + static_cast<std::size_t>(j) * this->width + i;
  const double* upper = lower + this->width;
  const double s = x - i, t = y - j;
  const double gray = between(between(lower[0], lower[1], s), between(upper[0], upper[1], s), t);
  return std::isfinite(gray) ? gray : std::numeric_limits<double>::quiet_NaN();
}

Terrain::Terrain(HeightImage image, const TerrainRules& rules)
  : Image(std::move(image))
  , Columns(rules.columns)
  , Rows(rules.rows)
  , Quad(rules.quad)
  , Scale(rules.scale)
  , Offset(rules.offset)
{
  const HeightImage& heights = this->Image;
  if (heights.width < 2 || heights.height < 2 ||
      heights.samples.size() != static_cast<std::size_t>(heights.width) * heights.height)
  {
    throw Error(Failure::BadMesh,
      "The height image has %1 x %2 samples; at least 2 x 2 are needed: take a larger image.",
      heights.width,
      heights.height);
  }
  if (!(this->Quad.minCoeff() >= 0.0) || !this->Quad.allFinite() || !std::isfinite(this->Scale) ||
      !std::isfinite(this->Offset) || !(heights.spacing.minCoeff() > 0.0) || !heights.spacing.allFinite() ||
      this->Columns < 0 || this->Rows < 0)
  {
    throw Error(Failure::BadMesh,
      "The terrain's number of quads, spacing, scale and offset must be finite, spacing and numbers not "
      "negative.");
  }
  // Sides of the whole image, by which quads are square.
  const double x = (heights.width - 1) * heights.spacing[0], y = (heights.height - 1) * heights.spacing[1];
  if (this->Columns == 0 && this->Rows == 0)
  {
    this->Columns = x >= y ? 64 : quadsBeside(64, x, y);
    this->Rows = x >= y ? quadsBeside(64, y, x) : 64;
  }
  this->Columns = this->Columns > 0 ? this->Columns : quadsBeside(this->Rows, x, y);
  this->Rows = this->Rows > 0 ? this->Rows : quadsBeside(this->Columns, y, x);
  const long long quads = static_cast<long long>(this->Columns) * this->Rows;
  if (quads > mostQuads)
  {
    throw Error(
      Failure::BadMesh, "The terrain would have %1 quads, more than %2; ask for fewer.", quads, mostQuads);
  }
  this->Quad[0] = this->Quad[0] > 0.0 ? this->Quad[0] : x / this->Columns;
  this->Quad[1] = this->Quad[1] > 0.0 ? this->Quad[1] : y / this->Rows;
}

double Terrain::column(int i) const
{
  return static_cast<double>(i) * (this->Image.width - 1) / this->Columns;
}

double Terrain::row(int j) const
{
  return static_cast<double>(j) * (this->Image.height - 1) / this->Rows;
}

double Terrain::heightAt(double x, double y) const
{
  return this->Offset +
         this->Scale * this->Image.at(x / this->Quad[0] * (this->Image.width - 1) / this->Columns,
                         y / this->Quad[1] * (this->Image.height - 1) / this->Rows);
}

// A quad needs all samples under it, and those round it that heights inside are made of: finer triangles read
// them.
std::vector<char> Terrain::completeQuads(const Context& context) const
{
  std::vector<char> complete(static_cast<std::size_t>(this->Columns) * this->Rows, 1);
  context.eachUntilCancelled(this->Rows,
    [&](int j)
    {
      const int low = static_cast<int>(this->row(j)), high = static_cast<int>(std::ceil(this->row(j + 1)));
      for (int i = 0; i < this->Columns; ++i)
      {
        const int left = static_cast<int>(this->column(i));
        const int right = static_cast<int>(std::ceil(this->column(i + 1)));
        char& whole = complete[static_cast<std::size_t>(j) * this->Columns + i];
        for (int v = low; v <= std::min(high, this->Image.height - 1) && whole; ++v)
        {
          const double* line = this->Image.samples.data() + static_cast<std::size_t>(v) * this->Image.width;
          whole = std::all_of(line + left,
            line + std::min(right, this->Image.width - 1) + 1,
            [](double gray) { return std::isfinite(gray); });
        }
      }
    });
  context.checkpoint(0.5);
  return complete;
}

// Whether two quads meet at vertex (i, j) by a corner alone.
bool Terrain::cornerJoint(const std::vector<char>& kept, int i, int j) const
{
  if (i <= 0 || j <= 0 || i >= this->Columns || j >= this->Rows)
  {
    return false;
  }
  const std::size_t q = static_cast<std::size_t>(j) * this->Columns + i; // upper right of the vertex
  const bool a = kept[q], b = kept[q - 1], c = kept[q - this->Columns - 1], d = kept[q - this->Columns];
  return a == c && b == d && a != b;
}

void Terrain::dropCornerJoints(std::vector<char>& kept) const
{
  const auto neighbours = [&](int i, int j)
  {
    const std::size_t q = static_cast<std::size_t>(j) * this->Columns + i;
    return (i > 0 && kept[q - 1]) + (i + 1 < this->Columns && kept[q + 1]) +
           (j > 0 && kept[q - this->Columns]) + (j + 1 < this->Rows && kept[q + this->Columns]);
  };
  std::vector<std::array<int, 2>> open;
  for (int j = 1; j < this->Rows; ++j)
  {
    for (int i = 1; i < this->Columns; ++i)
    {
      if (this->cornerJoint(kept, i, j))
      {
        open.push_back({ i, j });
      }
    }
  }
  // A quad that goes may leave others at its four corners.
  for (std::size_t next = 0; next < open.size(); ++next)
  {
    const auto [i, j] = open[next];
    if (!this->cornerJoint(kept, i, j))
    {
      continue;
    }
    const bool rising = kept[static_cast<std::size_t>(j) * this->Columns + i]; // upper right and lower left
    const int above = rising ? i : i - 1, below = rising ? i - 1 : i;
    const bool lowerGoes = neighbours(below, j - 1) < neighbours(above, j);
    const int goesI = lowerGoes ? below : above, goesJ = lowerGoes ? j - 1 : j;
    kept[static_cast<std::size_t>(goesJ) * this->Columns + goesI] = 0;
    for (int k = 0; k < 4; ++k)
    {
      open.push_back({ goesI + k % 2, goesJ + k / 2 });
    }
  }
}

Mesh Terrain::baseMesh(const Context& context) const
{
  std::vector<char> kept = this->completeQuads(context);
  this->dropCornerJoints(kept);
  Mesh mesh;
  const int across = this->Columns + 1;
  std::vector<int> ids(static_cast<std::size_t>(across) * (this->Rows + 1), -1);
  for (int j = 0; j < this->Rows; ++j)
  {
    for (int i = 0; i < this->Columns; ++i)
    {
      if (kept[static_cast<std::size_t>(j) * this->Columns + i])
      {
        const std::size_t v = static_cast<std::size_t>(j) * across + i;
        ids[v] = ids[v + 1] = ids[v + across] = ids[v + across + 1] = 0;
      }
    }
  }
  for (int j = 0; j <= this->Rows; ++j)
  {
    for (int i = 0; i < across; ++i)
    {
      int& id = ids[static_cast<std::size_t>(j) * across + i];
      if (id == 0)
      {
        id = mesh.vertexCount();
        mesh.points.emplace_back(i * this->Quad[0],
          j * this->Quad[1],
          this->Offset + this->Scale * this->Image.at(this->column(i), this->row(j)));
      }
    }
    context.checkpoint(0.5 + 0.4 * j / this->Rows);
  }
  for (int j = 0; j < this->Rows; ++j)
  {
    for (int i = 0; i < this->Columns; ++i)
    {
      if (kept[static_cast<std::size_t>(j) * this->Columns + i])
      {
        const int* lower = ids.data() + static_cast<std::size_t>(j) * across + i;
        const int* upper = lower + across;
        mesh.triangles.push_back({ lower[1], upper[1], lower[0] });
        mesh.triangles.push_back({ upper[0], lower[0], upper[1] });
      }
    }
  }
  if (mesh.triangles.empty())
  {
    throw Error(Failure::BadMesh,
      "No quad of the terrain has all its samples: the height image is all but missing. Fill its holes, or "
      "ask "
      "for more quads.");
  }
  return mesh;
}

} // namespace oversketch
