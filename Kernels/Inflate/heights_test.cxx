// Facts of image-assisted.md, section 12: how high the surface stands.
#include "Inflate/heights.h"

#include "Harness/drawn_meshes.h"
#include "Harness/inflation_chain.h"
#include "Harness/shapes.h"
#include "Harness/solid_shape.h"
#include "Inflate/solid.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Vector2 middle(513.3, 514.2);

// How far points off the rim are from a sphere about the middle: least and greatest [px].
std::pair<double, double> offSphere(const Solid& solid, double radius)
{
  std::pair<double, double> off(1e9, -1e9);
  for (const SolidPoint& point : solid.points)
  {
    const double r = (point.place - Vector3(middle[0], middle[1], 0.0)).norm() - radius;
    off = { std::min(off.first, r), std::max(off.second, r) };
  }
  return off;
}

std::vector<Circle> ringed(double radius)
{
  return { { radius, BoundaryKind::Object },
    { 0.75 * radius, BoundaryKind::Interior },
    { 0.5 * radius, BoundaryKind::Interior } };
}

void expectNone(const std::string& text, const std::string& words)
{
  try
  {
    CrossSection::parse(text);
    FAIL() << text;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

} // namespace

TEST(CrossSection, IsWhatItsTextSays)
{
  const CrossSection circle = CrossSection::parse(""), linear = CrossSection::parse("linear"),
                     step = CrossSection::parse("step"), curve = CrossSection::parse("0 0, 0.25 1, 1 0.5");
  for (const double u : { 0.0, 0.1, 0.5, 0.9, 1.0 })
  {
    EXPECT_NEAR(circle(u), std::sqrt(1.0 - (1.0 - u) * (1.0 - u)), 1e-15);
    EXPECT_EQ(CrossSection::parse("circle")(u), circle(u));
    EXPECT_EQ(linear(u), u);
    EXPECT_EQ(step(u), circle(std::min(1.0, 2.0 * u)));
    for (const CrossSection& each : { circle, linear, step, curve })
    {
      EXPECT_EQ(each(u) == 0.0, u == 0.0);
      EXPECT_LE(each(u), 1.0);
    }
  }
  EXPECT_EQ(curve(0.125), 0.5);
  EXPECT_EQ(curve(0.625), 0.75);
  EXPECT_EQ(curve(1.0), 0.5);
  EXPECT_EQ(circle.smoothing(), 0.3);
  EXPECT_EQ(linear.smoothing(), 0.0);
}

TEST(CrossSection, RefusesWhatWouldTearOrCollapse)
{
  expectNone("0 0.1, 1 1", "Point 0 of the profile is not \"0 0\"");
  expectNone("0 0, 0.5 0, 1 1", "Point 1 of the profile has a y that is not above 0");
  expectNone("0 0, 0.5 1.2, 1 1", "Point 1 of the profile has a y");
  expectNone("0 0, 1 -1", "Point 1 of the profile has a y");
  expectNone("0 0, 0.5 0.5, 0.5 1, 1 1", "Point 2 of the profile has an x that is not above");
  expectNone("sphere", "Point 0 of the profile is not two numbers");
  expectNone("0 0, 0.9 1", "not at x = 1");
}

TEST(C12_1, ADiscBecomesASphereOrACone)
{
  double least = 1e9, most = -1e9, cone = 0.0, share = 0.0;
  for (const double radius : { 50.0, 123.4, 200.0, 410.0 })
  {
    const std::vector<Circle> circles = ringed(radius);
    const PlanarMesh mesh = disc(middle, circles, 12, 3);
    for (const bool published : { false, true })
    {
      Chain chain(rimsOf(middle, circles), published);
      const auto [under, over] = offSphere(chain.solid(mesh), radius);
      if (published || radius <= 200.0)
      {
        least = std::min(least, under);
        most = std::max(most, over);
      }
      else
      {
        share = -under / radius; // what the profile's smoothing takes grows with R
      }
      chain.section = CrossSection::parse("linear");
      for (const SolidPoint& point : chain.solid(mesh).points)
      {
        const double d = radius - (point.place.head<2>() - middle).norm();
        cone = std::max(cone, std::abs(std::abs(point.place[2]) - d));
      }
    }
  }
  EXPECT_GE(least, -3.0);
  EXPECT_LE(most, 3.0);
  EXPECT_LE(share, 0.0125);
  EXPECT_LE(cone, 2.0);
  // Drawn by a hand that shakes.
  double low = 1e9, high = -1e9, publishedLow = 1e9;
  const std::vector<Circle> circles = ringed(200.0);
  const PlanarMesh mesh = disc(middle, circles, 12, 3);
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.5, 1.5);
    Rim rim{ ringAt(middle[0], middle[1], 200.0), 0 };
    for (Vector2& p : rim.points)
    {
      const double shift = uniform(random);
      p += shift * (p - middle).normalized();
    }
    Chain chain({ rim });
    const auto [under, over] = offSphere(chain.solid(mesh), 200.0);
    low = std::min(low, under);
    high = std::max(high, over);
    Chain published({ rim }, true);
    publishedLow = std::min(publishedLow, offSphere(published.solid(mesh), 200.0).first);
  }
  EXPECT_GE(low, -6.0);
  EXPECT_LE(high, 3.0);
  EXPECT_LT(publishedLow, -6.0);
  fact("C12_1",
    "discs of 50 to 410 px as published, to 200 px amended: " + digits(least) + " to " + digits(most) +
      " px off the sphere, amended 410 px up to " + digits(100.0 * share) +
      " % of R inside it; cone within " + digits(cone) + " px; 12 shaken circles of 200 px: " + digits(low) +
      " to " + digits(high) + " px, as published down to " + digits(publishedLow));
}

TEST(C12_2, AnAnnulusBecomesATorus)
{
  const std::vector<Circle> circles{ { 200.0, BoundaryKind::Object },
    { 175.0, BoundaryKind::Interior },
    { 150.0, BoundaryKind::Interior },
    { 125.0, BoundaryKind::Interior },
    { 100.0, BoundaryKind::Hole } };
  double least = 1e9, most = -1e9;
  for (const bool published : { false, true })
  {
    Chain chain(rimsOf(middle, circles), published);
    for (const SolidPoint& point : chain.solid(disc(middle, circles, 24, 2)).points)
    {
      const double tube = std::hypot((point.place.head<2>() - middle).norm() - 150.0, point.place[2]) - 50.0;
      least = std::min(least, tube);
      most = std::max(most, tube);
    }
  }
  EXPECT_GE(least, -2.0);
  EXPECT_LE(most, 2.0);
  fact("C12_2",
    "annulus 200 / 100, as published and amended: tube's radius " + digits(least) + " to " + digits(most) +
      " px off 50");
}

TEST(C12_3, ARectanglesMiddleIsACylinder)
{
  const Vector2 corner(114.0, 434.0), size(800.0, 160.0);
  const PlanarMesh mesh = rectangle(corner, size, 20, 4, false, 2);
  Chain chain({ rectangleRim(corner, size) });
  double off = 0.0;
  for (const SolidPoint& point : chain.solid(mesh).points)
  {
    if (std::abs(point.place[0] - 514.0) <= 200.0)
    {
      off = std::max(off, std::abs(std::hypot(point.place[1] - 514.0, point.place[2]) - 80.0));
    }
  }
  EXPECT_LE(off, 1.0);
  // As published its corners are roofs: u = 1 on the diagonals.
  Chain published({ rectangleRim(corner, size) }, true);
  double diagonal = 0.0;
  int compared = 0;
  for (const SolidPoint& point : published.solid(mesh).points)
  {
    const Vector2 d = point.place.head<2>() - corner;
    if (std::abs(d[0] - d[1]) < 1e-9 && d[0] >= 5.0 && d[0] < 80.0)
    {
      diagonal = std::max(diagonal, std::abs(std::abs(point.place[2]) - d[0]));
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
  EXPECT_LE(diagonal, 1e-3);
  fact("C12_3",
    "800 x 160 px: the middle " + digits(off) + " px off the cylinder; as published z = d on a corner's " +
      "diagonal within " + digits(diagonal) + " px");
}

TEST(C12_6, PoissonsDiscIsASphereAndItsStripHigher)
{
  double off = 0.0, direct = 0.0;
  for (const double radius : { 100.0, 200.0, 400.0 })
  {
    const std::vector<Circle> circles = ringed(radius);
    Chain chain(rimsOf(middle, circles));
    chain.poisson = true;
    for (const SolidPoint& point : chain.solid(disc(middle, circles, 12, 3)).points)
    {
      const double rho = (point.place.head<2>() - middle).norm();
      const double z = std::sqrt(std::max(0.0, radius * radius - rho * rho));
      off = std::max(off, std::abs((point.place - Vector3(middle[0], middle[1], 0.0)).norm() - radius));
      direct = std::max(direct, std::abs(std::abs(point.place[2]) - z));
    }
  }
  EXPECT_LE(off, 2.0);
  const Vector2 corner(14.0, 464.0), size(1000.0, 100.0);
  Chain chain({ rectangleRim(corner, size) });
  chain.poisson = true;
  double strip = 0.0;
  for (const SolidPoint& point : chain.solid(rectangle(corner, size, 20, 2, false, 3)).points)
  {
    if (std::abs(point.place[0] - 514.0) <= 250.0)
    {
      const double y = point.place[1] - 514.0;
      strip =
        std::max(strip, std::abs(std::abs(point.place[2]) - std::sqrt(2.0 * std::max(0.0, 2500.0 - y * y))));
    }
  }
  EXPECT_LE(strip, 2.0);
  fact("C12_6",
    "discs of 100 to 400 px: within " + digits(off) + " px of the sphere (z alone " + digits(direct) +
      "); strip of half-width 50 px: within " + digits(strip) + " px of H sqrt(2) times its section");
}

namespace
{

// A body with five arms, or a limb of a constant width that grows out of it.
Rim star(double arms)
{
  Rim rim;
  for (int i = 0; i < 720; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / 720;
    const double radius = 300.0 + arms * std::cos(5.0 * angle);
    rim.points.emplace_back(middle + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return rim;
}

} // namespace

TEST(Heights, NoKnobStandsOnASummit)
{
  double steeper = 0.0, low = 1e9;
  for (const double arms : { 60.0, 100.0, 140.0 })
  {
    Chain chain({ star(arms) });
    chain.withMaps(Context(),
      [&](const HeightMaps& maps)
      {
        const MapReader reader(maps);
        const auto height = [&](const Vector2& at)
        { return std::sqrt(reader.distance(at) * reader.inner(maps.ratio, at, 0)); };
        for (int ray = 0; ray < 20; ++ray)
        {
          const double angle = 0.31415926535 * ray, step = 8.0;
          const Vector2 way(std::cos(angle), std::sin(angle));
          double before = 0.0;
          for (double r = 0.0; r < 0.6 * reader.distance(middle); r += step)
          {
            const double slope = (height(middle + r * way) - height(middle + (r + step) * way)) / step;
            steeper = std::max(steeper, before - slope);
            before = slope;
          }
        }
        low = std::min(low, height(middle) / reader.distance(middle));
        return 0;
      });
  }
  // Down from the summit it is steeper and steeper: nothing stands on it.
  EXPECT_LE(steeper, 0.03);
  EXPECT_GE(low, 0.9);
}

TEST(Heights, ALimbIsAsThickAsItIsWide)
{
  // A disc of 200 px with a limb of a half width of 12 px.
  Rim rim;
  for (int i = 0; i <= 300; ++i)
  {
    const double angle = 0.06 + (2.0 * 3.14159265358979323846 - 0.12) * i / 300;
    rim.points.emplace_back(Vector2(300.0, 514.0) + 200.0 * Vector2(std::cos(angle), std::sin(angle)));
  }
  rim.points.emplace_back(900.0, 502.0);
  rim.points.emplace_back(900.0, 526.0);
  Chain chain({ rim });
  chain.withMaps(Context(),
    [&](const HeightMaps& maps)
    {
      const MapReader reader(maps);
      for (double x = 540.0; x < 880.0; x += 7.0)
      {
        const Vector2 at(x, 514.0);
        EXPECT_NEAR(std::sqrt(reader.distance(at) * reader.inner(maps.ratio, at, 0)) / 12.0, 1.0, 0.04) << x;
      }
      return 0;
    });
}

TEST(Heights, ScaleWithTheFactorAndThePixel)
{
  const std::vector<Circle> circles = ringed(100.0);
  const PlanarMesh mesh = disc(middle, circles, 12, 2);
  Chain chain(rimsOf(middle, circles));
  const std::vector<double> once = chain.heights(mesh);
  chain.factor = 2.5;
  const std::vector<double> more = chain.heights(mesh);
  for (std::size_t i = 0; i < once.size(); ++i)
  {
    EXPECT_NEAR(more[i], 2.5 * once[i], 1e-9);
    EXPECT_EQ(once[i] == 0.0, isRim(mesh.points[i].kind)) << i;
  }
  EXPECT_EQ(more, chain.heights(mesh, twoThreads()));
  for (const double factor : { 0.0, -1.0, std::nan("") })
  {
    chain.factor = factor;
    EXPECT_THROW(chain.heights(mesh), Error);
  }
  chain.factor = 1.0;
  PlanarMesh outside = mesh;
  outside.points[3].place[0] = -1.0;
  EXPECT_THROW(chain.heights(outside), Error);
}

TEST(Heights, FrontAndBackMeetAtRimsAlone)
{
  // The mesh's rim lies outside the drawn one, as a coarse polyline's may: T is 0 there.
  const std::vector<Circle> circles = ringed(110.0);
  const PlanarMesh mesh = disc(middle, circles, 12, 3);
  for (const char* text : { "circle", "linear", "step", "0 0, 1 1e-3" })
  {
    Chain chain(rimsOf(middle, ringed(100.0)));
    chain.section = CrossSection::parse(text);
    const std::vector<double> heights = chain.heights(mesh);
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
      EXPECT_EQ(heights[i] > 0.0, !isRim(mesh.points[i].kind)) << text << " " << i;
    }
  }
  // What lies beside another object's samples reads its own alone.
  DistanceMaps maps = distanceMaps(pixelFrame(60, 40),
    { { ringAt(15, 20, 10), 0 }, { ringAt(42, 20, 14), 1 } },
    ThicknessMode::Local,
    Context());
  std::vector<float> values(maps.frame.count());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = maps.object[i] == 0 ? 5.0f : 9.0f;
  }
  const HeightMaps heights{ maps, values, values };
  const MapReader reader(heights);
  for (double x = 22.0; x < 32.0; x += 0.37)
  {
    EXPECT_EQ(reader.inner(values, Vector2(x, 20.3), 0), 5.0);
    EXPECT_EQ(reader.inner(values, Vector2(x, 20.3), 1), 9.0);
  }
  EXPECT_EQ(reader.inner(values, Vector2(42.0, 20.0), 0), 0.0) << "none within 16 px";
}
